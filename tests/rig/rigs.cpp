// SPDX-License-Identifier: MIT
#include "rig/rigs.h"

#include "support/random_math.h"
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace croquis {
namespace {

std::vector<LabelledRig> read_rigs() {
  std::ifstream file(std::string(CROQUIS_SOURCE_DIR) + "/tests/rig/rigs.txt");
  std::vector<LabelledRig> rigs;
  std::vector<Vec3> positions;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line.front() == '#') continue;
    if (line.starts_with("rig ")) {
      rigs.push_back({line.substr(4), {}, {}});
      positions.clear();
      continue;
    }
    std::istringstream in(line);
    Joint joint;
    Vec3 at = Vec3::Zero();
    std::string helper, bone;
    in >> joint.parent >> at.x() >> at.y() >> at.z() >> helper >> bone;
    in.ignore(1);
    std::getline(in, joint.name);
    at *= 1e-4;
    positions.push_back(at);
    joint.helper = helper == "h";
    joint.rest.translation = joint.parent < 0 ? at : Vec3(at - positions[static_cast<std::size_t>(joint.parent)]);
    LabelledRig& rig = rigs.back();
    if (bone != "-") rig.labels.set(parse_humanoid_bone(bone).value(), static_cast<int>(rig.joints.size()), 1.0);
    rig.joints.push_back(joint);
  }
  if (rigs.empty()) throw std::runtime_error("tests/rig/rigs.txt is missing or empty");
  return rigs;
}

}  // namespace

const std::vector<LabelledRig>& labelled_rigs() {
  static const std::vector<LabelledRig> rigs = read_rigs();
  return rigs;
}

const LabelledRig& labelled_rig(const std::string& name) {
  for (const LabelledRig& rig : labelled_rigs()) {
    if (rig.name == name) return rig;
  }
  throw std::runtime_error("no labelled rig " + name);
}

Skeleton with_random_axes(const Skeleton& skeleton, std::uint64_t seed) {
  Random random(seed);
  std::vector<Joint> joints = skeleton.joints();
  std::vector<Affine> model;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    Affine wanted = Affine::Identity();
    wanted.translate(skeleton.rest_position(static_cast<int>(i)));
    wanted.rotate(random_rotation(random));
    const Affine parent = i == 0 ? Affine::Identity() : model[static_cast<std::size_t>(joints[i].parent)];
    joints[i].rest = decompose(parent.inverse() * wanted);
    model.push_back(wanted);
  }
  return Skeleton(joints);
}

}  // namespace croquis
