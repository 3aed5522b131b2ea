// SPDX-License-Identifier: MIT
#include "croquis/posing/standing.h"

#include <algorithm>

#include "croquis/posing/body_points.h"
#include "croquis/posing/pose_edit.h"

namespace croquis {
namespace {

/// The joint at which a foot's leg begins: the last before a joint with several limbs.
int leg_top(const Skeleton& skeleton, int foot) {
  int joint = foot;
  while (skeleton.parent(joint) > 0 && skeleton.children(skeleton.parent(joint)).size() == 1) {
    joint = skeleton.parent(joint);
  }
  return joint;
}

}  // namespace

std::vector<PosePin> pin_standing_feet(const Skeleton& skeleton, const HumanoidMap& humanoid, const Pose& start,
                                       const std::vector<LineInput>& inputs, const LineSolverOptions& options) {
  std::vector<PosePin> pins;
  if (!options.floor || !options.stand) return pins;
  const std::vector<Vec3> positions = compute_positions(skeleton, start);
  const std::vector<Quat> rotations = compute_model_rotations(skeleton, start);
  for (const int foot : find_standing_feet(skeleton, humanoid, positions, *options.floor)) {
    int leg = leg_top(skeleton, foot);
    if (const auto bone = humanoid.bone_of(foot)) {
      const auto upper = *bone == HumanoidBone::leftFoot ? HumanoidBone::leftUpperLeg : HumanoidBone::rightUpperLeg;
      if (humanoid.has(upper)) leg = humanoid.joint(upper);
    }
    bool carried = options.move_body, told = false;
    for (const LineInput& input : inputs) {
      for (const int joint : input.line.joints) {
        carried = carried || skeleton.is_ancestor(joint, foot);
        // A line across the hips ends where the legs begin and says nothing of them.
        told = told || (joint != leg && skeleton.is_ancestor(leg, joint));
      }
    }
    for (const PosePin& pin : options.pins) told = told || skeleton.is_ancestor(leg, pin.joint);
    if (!carried || told) continue;
    const auto at = static_cast<std::size_t>(foot);
    pins.push_back({foot, positions[at], rotations[at]});
  }
  return pins;
}

}  // namespace croquis
