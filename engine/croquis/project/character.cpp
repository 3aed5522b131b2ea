// SPDX-License-Identifier: MIT
#include "croquis/project/character.h"

#include "croquis/base/error.h"
#include "croquis/base/text.h"

namespace croquis {

void Character::check() const {
  const int joints = skeleton.joint_count();
  const auto want = [&](bool holds, const std::string& what) {
    if (!holds) throw_invalid_argument("Character '" + printable(name) + "': " + what);
  };
  want(std::ssize(start.local) == joints, "the start pose does not fit the skeleton");
  want(source_nodes.empty() || std::ssize(source_nodes) == joints, "wanted one source node per joint");
  for (const Part& part : parts) {
    part.mesh.check();
    const int vertices = part.mesh.vertex_count();
    if (part.skin) part.skin->check(vertices, joints);
    want(part.skin || (part.joint >= 0 && part.joint < joints), "a part hangs on a joint that is not there");
    want(part.shape_weights.size() == part.shapes.size(), "wanted one weight per shape");
    for (const BlendShape& shape : part.shapes) {
      for (const auto* deltas : {&shape.positions, &shape.normals, &shape.tangents}) {
        want(deltas->empty() || std::ssize(*deltas) == vertices, "a shape does not fit its mesh");
      }
    }
  }
  for (const Clip& clip : clips) {
    for (const Curve& curve : clip.curves) {
      curve.check();
      const int most = curve.target == CurveTarget::weights ? static_cast<int>(parts.size()) : joints;
      want(curve.joint >= 0 && curve.joint < most, "clip '" + printable(clip.name) + "' moves what is not there");
    }
  }
}

Box bounding_box(const Character& character, const Pose& pose, const std::vector<std::vector<Vec3f>>& positions) {
  Box box;
  for (const auto& part : positions) {
    for (const Vec3f& position : part) box.extend(Vec3(position.cast<double>()));
  }
  const std::vector<Vec3> joints = compute_positions(character.skeleton, pose);
  for (int i = 0; i < character.skeleton.joint_count(); ++i) {
    if (!character.skeleton.joint(i).helper) box.extend(joints[static_cast<std::size_t>(i)]);
  }
  return box;
}

}  // namespace croquis
