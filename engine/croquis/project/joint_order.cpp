// SPDX-License-Identifier: MIT
#include "croquis/project/joint_order.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "croquis/base/error.h"

namespace croquis {
namespace {

std::vector<int> depth_first(const Skeleton& skeleton) {
  std::vector<int> order, waiting{0};
  while (!waiting.empty()) {
    const int joint = waiting.back();
    waiting.pop_back();
    order.push_back(joint);
    const std::vector<int>& children = skeleton.children(joint);
    waiting.insert(waiting.end(), children.rbegin(), children.rend());
  }
  return order;
}

}  // namespace

Character in_file_order(Character character) {
  if (character.source != nullptr) throw_invalid_argument("in_file_order: the character has the order of its file");
  const Skeleton& skeleton = character.skeleton;
  const std::vector<int> order = depth_first(skeleton);
  if (std::is_sorted(order.begin(), order.end())) return character;
  std::vector<int> place(order.size());  // old index -> new index
  for (std::size_t i = 0; i < order.size(); ++i) place[static_cast<std::size_t>(order[i])] = static_cast<int>(i);
  const auto moved = [&](int joint) { return joint < 0 ? joint : place[static_cast<std::size_t>(joint)]; };

  std::vector<Joint> joints;
  Pose start;
  for (const int old : order) {
    joints.push_back(skeleton.joint(old));
    joints.back().parent = moved(joints.back().parent);
    start.local.push_back(character.start.local[static_cast<std::size_t>(old)]);
  }
  for (HumanoidMap::Entry& entry : character.humanoid.entries) entry.joint = moved(entry.joint);
  for (Part& part : character.parts) {
    part.joint = moved(part.joint);
    if (!part.skin) continue;
    for (int& joint : part.skin->joints) joint = moved(joint);
  }
  for (Clip& clip : character.clips) {
    for (Curve& curve : clip.curves) {
      if (curve.target != CurveTarget::weights) curve.joint = moved(curve.joint);
    }
  }
  character.skeleton = Skeleton(std::move(joints));
  character.start = std::move(start);
  return character;
}

}  // namespace croquis
