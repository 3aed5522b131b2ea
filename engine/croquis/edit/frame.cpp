// SPDX-License-Identifier: MIT
#include "croquis/edit/frame.h"

#include <string>
#include <utility>
#include <vector>

#include "croquis/base/error.h"
#include "croquis/base/text.h"
#include "croquis/skinning/skinning.h"

namespace croquis {
namespace {

/// The joints that any program keeps: not the ends of bones without children that BVH readers add.
std::vector<int> lasting_joints(const Skeleton& skeleton) {
  std::vector<int> joints;
  for (int i = 0; i < skeleton.joint_count(); ++i) {
    const int parent = skeleton.parent(i);
    const bool end = parent >= 0 && skeleton.children(i).empty() && skeleton.name(i) == skeleton.name(parent) + "_end";
    if (!end) joints.push_back(i);
  }
  return joints;
}

std::string shown(const Skeleton& skeleton, int joint) {
  return "'" + printable(skeleton.name(joint)) + "' (#" + std::to_string(joint) + ")";
}

}  // namespace

Character character_at_frame(Character character, int frame) {
  if (character.clips.empty()) throw_invalid_argument("frame " + std::to_string(frame) + ": the file has no clip");
  const Clip& clip = character.clips.front();
  const double time = clip.frame_time(frame);
  character.start = sample_pose(clip, time, character.start);
  for (std::size_t i = 0; i < character.parts.size(); ++i) {
    Part& part = character.parts[i];
    part.shape_weights = sample_weights(clip, time, static_cast<int>(i), part.shape_weights);
  }
  return character;
}

Pose start_pose_of(const Character& source, const Character& target) {
  const Skeleton& from = source.skeleton;
  const Skeleton& to = target.skeleton;
  const std::vector<int> from_joints = lasting_joints(from), to_joints = lasting_joints(to);
  if (from_joints.size() != to_joints.size()) {
    throw_invalid_argument("not the same skeleton: the start pose has " + std::to_string(from_joints.size()) +
                           " joints, wanted " + std::to_string(to_joints.size()));
  }
  std::vector<int> place_of(static_cast<std::size_t>(from.joint_count()), -1);  // joint of `from` -> joint of `to`
  std::vector<bool> taken(static_cast<std::size_t>(to.joint_count()), false);
  Pose pose = rest_pose(to);
  for (const int a : from_joints) {
    // Programs order siblings as they like: the same name under the same parent is the same joint.
    const int parent = from.parent(a) < 0 ? -1 : place_of[static_cast<std::size_t>(from.parent(a))];
    const auto same = std::find_if(to_joints.begin(), to_joints.end(), [&](int b) {
      return !taken[static_cast<std::size_t>(b)] && to.parent(b) == parent && to.name(b) == from.name(a);
    });
    if (same == to_joints.end()) {
      throw_invalid_argument("not the same skeleton: joint " + shown(from, a) +
                             " of the start pose has no counterpart under the same parent");
    }
    taken[static_cast<std::size_t>(*same)] = true;
    place_of[static_cast<std::size_t>(a)] = *same;
    pose.local[static_cast<std::size_t>(*same)] = source.start.local[static_cast<std::size_t>(a)];
  }
  return pose;
}

std::vector<BakedPart> bake_parts(const Character& character, const Pose& pose) {
  std::vector<BakedPart> baked;
  for (PosedPart& part : pose_character(character, pose)) {
    baked.push_back({std::move(part.positions), std::move(part.normals), std::move(part.tangents), {}});
  }
  return baked;
}

}  // namespace croquis
