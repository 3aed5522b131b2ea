// SPDX-License-Identifier: MIT
#include "croquis/edit/frame.h"

#include <string>
#include <utility>
#include <vector>

#include "croquis/base/error.h"
#include "croquis/base/text.h"

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
  std::vector<int> place_of(static_cast<std::size_t>(from.joint_count()), -1);  // joint of `from` -> joint of `to`
  Pose pose = rest_pose(to);
  for (std::size_t i = 0; i < std::min(from_joints.size(), to_joints.size()); ++i) {
    const int a = from_joints[i], b = to_joints[i];
    const int parent = from.parent(a) < 0 ? -1 : place_of[static_cast<std::size_t>(from.parent(a))];
    if (from.name(a) != to.name(b) || parent != to.parent(b)) {
      throw_invalid_argument("not the same skeleton: joint " + shown(from, a) + " of the start pose stands where " +
                             shown(to, b) + " is wanted" +
                             (from.name(a) == to.name(b) ? ", under another parent" : ""));
    }
    place_of[static_cast<std::size_t>(a)] = b;
    pose.local[static_cast<std::size_t>(b)] = source.start.local[static_cast<std::size_t>(a)];
  }
  if (from_joints.size() != to_joints.size()) {
    throw_invalid_argument("not the same skeleton: the start pose has " + std::to_string(from_joints.size()) +
                           " joints, wanted " + std::to_string(to_joints.size()));
  }
  return pose;
}

}  // namespace croquis
