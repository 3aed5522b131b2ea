// SPDX-License-Identifier: MIT
#include "croquis/rig/body_line.h"

#include <algorithm>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/base/text.h"

namespace croquis {
namespace {

constexpr int kMostLines = 64;

std::string shown(const Skeleton& skeleton, int joint) { return "'" + printable(skeleton.reference(joint)) + "'"; }

void check_index(const Skeleton& skeleton, int joint, const char* function) {
  if (joint >= 0 && joint < skeleton.joint_count()) return;
  throw_invalid_argument(std::string(function) + ": got joint #" + std::to_string(joint) + ", wanted #0 to #" +
                         std::to_string(skeleton.joint_count() - 1));
}

/// The path from a to b as a line; empty joints if a and b are the same.
BodyLine line_between(const Skeleton& skeleton, int a, int b, std::string name) {
  BodyLine line{std::move(name), {}};
  if (a != b) line.joints = skeleton.path(a, b);
  return line;
}

/// The lines of a humanoid that its bones allow.
std::vector<BodyLine> humanoid_lines(const Skeleton& skeleton, const HumanoidMap& humanoid) {
  using enum HumanoidBone;
  const auto or_else = [&](HumanoidBone bone, HumanoidBone other) { return humanoid.has(bone) ? bone : other; };
  const HumanoidBone top = or_else(head, neck);
  // A limb without hand or foot ends at its lower joint.
  const HumanoidBone left_hand = or_else(leftHand, leftLowerArm), right_hand = or_else(rightHand, rightLowerArm);
  const HumanoidBone left_foot = or_else(leftFoot, leftLowerLeg), right_foot = or_else(rightFoot, rightLowerLeg);
  const struct {
    const char* name;
    HumanoidBone from, to;
  } wanted[] = {
      {"trunk", hips, top},
      {"left_foot-head", left_foot, top},
      {"right_foot-head", right_foot, top},
      {"left_hand-right_hand", left_hand, right_hand},
      {"left_foot-right_hand", left_foot, right_hand},
      {"right_foot-left_hand", right_foot, left_hand},
      {"left_foot-left_hand", left_foot, left_hand},
      {"right_foot-right_hand", right_foot, right_hand},
      {"left_foot-right_foot", left_foot, right_foot},
      {"hips-left_hand", hips, left_hand},
      {"hips-right_hand", hips, right_hand},
      {"left_arm", leftUpperArm, left_hand},
      {"right_arm", rightUpperArm, right_hand},
      {"left_leg", leftUpperLeg, left_foot},
      {"right_leg", rightUpperLeg, right_foot},
      {"shoulders", leftUpperArm, rightUpperArm},
      {"hips", leftUpperLeg, rightUpperLeg},
  };
  std::vector<BodyLine> lines;
  for (const auto& [name, from, to] : wanted) {
    if (!humanoid.has(from) || !humanoid.has(to)) continue;
    BodyLine line = line_between(skeleton, humanoid.joint(from), humanoid.joint(to), name);
    if (!line.joints.empty()) lines.push_back(std::move(line));
  }
  return lines;
}

/// A tree without its helpers at top and bottom: the topmost bone above each joint, and the bones that end a branch.
struct Branches {
  std::vector<int> top;       ///< per joint: the topmost joint above it (or itself) that is no helper; -1 for none
  std::vector<double> depth;  ///< per joint: rest length of the way from its top
  std::vector<int> ends;      ///< joints that are no helpers and have none but helpers below, the deepest first
};

Branches find_branches(const Skeleton& skeleton) {
  const auto count = static_cast<std::size_t>(skeleton.joint_count());
  Branches branches{std::vector<int>(count, -1), std::vector<double>(count, 0.0), {}};
  std::vector<bool> has_bone_below(count, false);
  for (int i = skeleton.joint_count() - 1; i > 0; --i) {
    const auto child = static_cast<std::size_t>(i), parent = static_cast<std::size_t>(skeleton.parent(i));
    if (!skeleton.joint(i).helper || has_bone_below[child]) has_bone_below[parent] = true;
  }
  for (int i = 0; i < skeleton.joint_count(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    const int above = i == 0 ? -1 : branches.top[static_cast<std::size_t>(skeleton.parent(i))];
    branches.top[at] = above >= 0 ? above : skeleton.joint(i).helper ? -1 : i;
    if (above >= 0) {
      branches.depth[at] = branches.depth[static_cast<std::size_t>(skeleton.parent(i))] +
                           (skeleton.rest_position(i) - skeleton.rest_position(skeleton.parent(i))).norm();
    }
    if (!skeleton.joint(i).helper && !has_bone_below[at]) branches.ends.push_back(i);
  }
  std::stable_sort(branches.ends.begin(), branches.ends.end(), [&](int a, int b) {
    return branches.depth[static_cast<std::size_t>(a)] > branches.depth[static_cast<std::size_t>(b)];
  });
  if (std::ssize(branches.ends) > kMostLines) branches.ends.resize(kMostLines);
  return branches;
}

/// A tree that is no humanoid: the longest path, the ways from the top to the ends, the ways between ends, each kind
/// longest first. A line does not pass above the topmost bone, where separate trees of a file hang together.
std::vector<BodyLine> tree_lines(const Skeleton& skeleton) {
  const Branches branches = find_branches(skeleton);
  struct Candidate {
    int from, to;
    double length;
  };
  std::vector<Candidate> from_top, between_ends;
  const auto depth = [&](int joint) { return branches.depth[static_cast<std::size_t>(joint)]; };
  const auto top = [&](int joint) { return branches.top[static_cast<std::size_t>(joint)]; };
  for (const int end : branches.ends) {
    if (top(end) != end) from_top.push_back({top(end), end, depth(end)});
    for (const int other : branches.ends) {
      if (other <= end || top(other) != top(end)) continue;
      const std::vector<int> path = skeleton.path(end, other);
      const double shared = depth(*std::min_element(path.begin(), path.end()));
      between_ends.push_back({end, other, depth(end) + depth(other) - 2.0 * shared});
    }
  }
  const auto longer = [](const Candidate& a, const Candidate& b) { return a.length > b.length; };
  std::stable_sort(from_top.begin(), from_top.end(), longer);
  std::stable_sort(between_ends.begin(), between_ends.end(), longer);
  std::vector<Candidate> all = from_top;
  all.insert(all.end(), between_ends.begin(), between_ends.end());
  if (!all.empty()) {
    // Of equals the first: a way from the top rather than one between ends.
    const auto longest = std::min_element(all.begin(), all.end(), longer);
    std::rotate(all.begin(), longest, longest + 1);
  }
  if (std::ssize(all) > kMostLines) all.resize(kMostLines);
  std::vector<BodyLine> lines;
  for (const Candidate& c : all) {
    std::string name = skeleton.reference(c.from) + "-" + skeleton.reference(c.to);
    const bool taken = std::any_of(lines.begin(), lines.end(), [&](const BodyLine& l) { return l.name == name; });
    if (taken) name = "#" + std::to_string(c.from) + "-#" + std::to_string(c.to);
    lines.push_back(line_between(skeleton, c.from, c.to, std::move(name)));
  }
  return lines;
}

}  // namespace

std::vector<SkeletonSegment> segments_of_selection(const Skeleton& skeleton, std::span<const int> selection) {
  if (selection.empty()) throw_invalid_argument("the selection holds no joint, wanted at least two");
  std::vector<bool> selected(static_cast<std::size_t>(skeleton.joint_count()), false);
  for (const int joint : selection) {
    check_index(skeleton, joint, "segments_of_selection");
    selected[static_cast<std::size_t>(joint)] = true;
  }
  const auto selected_children = [&](int joint) {
    std::vector<int> found;
    for (const int child : skeleton.children(joint)) {
      if (selected[static_cast<std::size_t>(child)]) found.push_back(child);
    }
    return found;
  };
  std::vector<SkeletonSegment> segments;
  for (int root = 0; root < skeleton.joint_count(); ++root) {
    const int above = skeleton.parent(root);
    if (!selected[static_cast<std::size_t>(root)] || (above >= 0 && selected[static_cast<std::size_t>(above)]))
      continue;
    const std::vector<int> starts = selected_children(root);
    if (starts.empty()) {
      throw_invalid_argument("joint " + shown(skeleton, root) +
                             " is selected alone: a segment needs a joint and its child");
    }
    for (const int start : starts) {
      SkeletonSegment segment{root, start};
      for (std::vector<int> next; !(next = selected_children(segment.back())).empty();) {
        if (next.size() > 1) {
          throw_invalid_argument("joint " + shown(skeleton, segment.back()) + " has " + std::to_string(next.size()) +
                                 " selected children (" + shown(skeleton, next[0]) + ", " + shown(skeleton, next[1]) +
                                 (next.size() > 2 ? ", ..." : "") +
                                 ") and a selected parent: a line cannot fork there");
        }
        segment.push_back(next.front());
      }
      segments.push_back(std::move(segment));
    }
  }
  return segments;
}

BodyLine make_body_line(const Skeleton& skeleton, std::span<const int> joints) {
  if (joints.size() < 2) {
    throw_invalid_argument("a body line needs at least two joints, got " + std::to_string(joints.size()));
  }
  for (const int joint : joints) check_index(skeleton, joint, "make_body_line");
  BodyLine line{skeleton.reference(joints.front()) + "-" + skeleton.reference(joints.back()), {joints.front()}};
  std::vector<bool> passed(static_cast<std::size_t>(skeleton.joint_count()), false);
  passed[static_cast<std::size_t>(joints.front())] = true;
  for (std::size_t i = 1; i < joints.size(); ++i) {
    std::vector<int> way = skeleton.path(joints[i - 1], joints[i]);
    // A joint given twice in a row comes back to itself.
    if (way.size() > 1) way.erase(way.begin());
    for (const int joint : way) {
      if (passed[static_cast<std::size_t>(joint)]) {
        throw_invalid_argument("the body line comes back to joint " + shown(skeleton, joint) + " on its way from " +
                               shown(skeleton, joints[i - 1]) + " to " + shown(skeleton, joints[i]));
      }
      passed[static_cast<std::size_t>(joint)] = true;
      line.joints.push_back(joint);
    }
  }
  return line;
}

std::vector<SkeletonSegment> segments_of_line(const Skeleton& skeleton, const BodyLine& line) {
  const std::vector<int>& joints = line.joints;
  if (joints.size() < 2) throw_invalid_argument("segments_of_line: the line has fewer than two joints");
  for (const int joint : joints) check_index(skeleton, joint, "segments_of_line");
  if (skeleton.path(joints.front(), joints.back()) != joints) {
    throw_invalid_argument("segments_of_line: the joints of the line are not the path between its ends");
  }
  // Parents stand before their children, so the topmost joint has the smallest index.
  const auto top = std::min_element(joints.begin(), joints.end());
  std::vector<SkeletonSegment> segments;
  if (top != joints.begin()) segments.emplace_back(std::make_reverse_iterator(top + 1), joints.rend());
  if (top + 1 != joints.end()) segments.emplace_back(top, joints.end());
  return segments;
}

std::vector<BodyLine> standard_body_lines(const Skeleton& skeleton, const HumanoidMap& humanoid) {
  std::vector<BodyLine> lines;
  if (humanoid.is_humanoid()) lines = humanoid_lines(skeleton, humanoid);
  return lines.empty() ? tree_lines(skeleton) : lines;
}

BodyLine find_body_line(const Skeleton& skeleton, const HumanoidMap& humanoid, std::string_view name) {
  std::vector<std::string> names;
  for (BodyLine& line : standard_body_lines(skeleton, humanoid)) {
    if (line.name == name) return std::move(line);
    names.push_back(printable(line.name));
  }
  throw_invalid_argument("no body line is named '" + printable(name) + "'; there are " +
                         (names.empty() ? std::string("none") : join(names, ", ")));
}

}  // namespace croquis
