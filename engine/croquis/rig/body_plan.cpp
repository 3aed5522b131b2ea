// SPDX-License-Identifier: MIT
#include "croquis/rig/body_plan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace croquis {
namespace {

constexpr std::size_t kDeepestPath = 24;  // how far below its start a branch is looked at, ...
constexpr int kMostJoints = 200;          // ... and how many joints of it
constexpr std::size_t kMostPairs = 12;

using Roles = std::array<NameRole, 3>;
constexpr Roles kArm = {NameRole::upper_arm, NameRole::lower_arm, NameRole::hand};
constexpr Roles kLeg = {NameRole::upper_leg, NameRole::lower_leg, NameRole::foot};

/// Two limbs under one joint.
struct Pair {
  int joint = -1;
  Limb first, second;
  int first_branch = -1, second_branch = -1;  ///< the joint's children that the limbs hang on
  double score = 0.0;
};

class PlanSearch {
 public:
  PlanSearch(const Skeleton& skeleton, const std::vector<JointName>& names)
      : skeleton_(skeleton), names_(names), rank_(names.size(), 0), last_(names.size(), 0) {
    // Ranks in depth-first order: the joints under one joint have the ranks from its own to its last.
    std::vector<int> sizes(names.size(), 1);
    for (int i = skeleton.joint_count() - 1; i > 0; --i) value(sizes, skeleton.parent(i)) += value(sizes, i);
    for (int i = 0; i < skeleton.joint_count(); ++i) {
      int next = value(rank_, i) + 1;
      value(last_, i) = value(rank_, i) + value(sizes, i) - 1;
      for (const int child : skeleton.children(i)) {
        value(rank_, child) = next;
        next += value(sizes, child);
      }
    }
  }

  [[nodiscard]] std::optional<BodyPlan> run() const {
    const std::vector<Pair> legs = find_pairs(kLeg), arms = find_pairs(kArm);
    std::optional<BodyPlan> best;
    double best_score = 0.0;
    for (const Pair& leg : legs) {
      for (const Pair& arm : arms) {
        BodyPlan plan;
        const double score = join(leg, arm, plan);
        if (score > best_score) {
          best_score = score;
          best = plan;
        }
      }
    }
    return best;
  }

 private:
  [[nodiscard]] static int& value(std::vector<int>& values, int joint) {
    return values[static_cast<std::size_t>(joint)];
  }
  [[nodiscard]] bool is_below(int top, int joint) const {
    const auto i = static_cast<std::size_t>(top), k = static_cast<std::size_t>(joint);
    return rank_[i] <= rank_[k] && rank_[k] <= last_[i];
  }
  [[nodiscard]] const JointName& name(int joint) const { return names_[static_cast<std::size_t>(joint)]; }
  [[nodiscard]] Vec3 at(int joint) const { return skeleton_.rest_position(joint); }
  [[nodiscard]] double affinity(int joint, NameRole role) const { return name(joint).affinity(role); }

  [[nodiscard]] double skip_cost(int joint, NameRole role, int from, int to) const;
  [[nodiscard]] Limb limb_of(const std::vector<int>& path, std::size_t u, std::size_t l, std::size_t e,
                             const Roles& roles) const;
  [[nodiscard]] Limb best_limb(int start, const Roles& roles) const;
  [[nodiscard]] std::vector<Pair> find_pairs(const Roles& roles) const;
  double join(const Pair& leg, const Pair& arm, BodyPlan& plan) const;
  [[nodiscard]] int find_head(const Pair& leg, const Pair& arm, int hips, int chest, bool& named) const;
  [[nodiscard]] int follow_neck(int first) const;
  [[nodiscard]] double length_of(const Limb& limb) const;
  [[nodiscard]] int lowest_below(int top, const Vec3& up) const;
  [[nodiscard]] bool is_mirrored(const Limb& a, const Limb& b) const;
  [[nodiscard]] bool stands_like_a_human(const BodyPlan& plan) const;
  [[nodiscard]] bool is_quadruped(const BodyPlan& plan) const;
  [[nodiscard]] Vec3 find_left(const Pair& leg, const Pair& arm, const Vec3& up) const;

  const Skeleton& skeleton_;
  const std::vector<JointName>& names_;
  std::vector<int> rank_, last_;
};

double cosine(const Vec3& a, const Vec3& b) {
  const double scale = a.norm() * b.norm();
  return scale > 0.0 ? a.dot(b) / scale : 0.0;
}

/// What it costs that a joint lies within a part of a limb: little for a twist bone on the straight way.
double PlanSearch::skip_cost(int joint, NameRole role, int from, int to) const {
  if (affinity(joint, role) > 0.5) return 0.3;
  if (name(joint).ignored) return 0.05;
  const Vec3 way = at(to) - at(from), part = at(joint) - at(from);
  return way.cross(part).norm() < 0.02 * way.squaredNorm() ? 0.1 : 0.25;
}

/// How well three joints of a path do for a limb: what their names say, two long parts of like length, nothing else
/// between them.
Limb PlanSearch::limb_of(const std::vector<int>& path, std::size_t u, std::size_t l, std::size_t e,
                         const Roles& roles) const {
  const bool has_end = e < path.size();
  Limb limb{path[u], path[l], has_end ? path[e] : -1};
  limb.score = has_end ? 0.0 : -0.5;
  int left = 0, right = 0;
  for (std::size_t i = 0; i < (has_end ? 3U : 2U); ++i) {
    const int joint = i == 0 ? limb.upper : i == 1 ? limb.lower : limb.end;
    const double says = affinity(joint, roles[i]);
    limb.score += says;
    limb.names += std::max(0.0, says) / 3.0;
    left += name(joint).side == NameSide::left ? 1 : 0;
    right += name(joint).side == NameSide::right ? 1 : 0;
  }
  limb.side = left > right ? NameSide::left : right > left ? NameSide::right : NameSide::none;
  for (std::size_t i = 0; i < u; ++i) {  // of two halves of an upper arm the first
    if (affinity(path[i], roles[0]) >= std::max(0.5, affinity(path[u], roles[0]))) limb.score -= 0.3;
  }
  for (std::size_t i = u + 1; i < std::min(e, path.size()); ++i) {
    if (i == l) continue;
    limb.score -= skip_cost(path[i], i < l ? roles[0] : roles[2], path[i < l ? u : l],
                            path[i < l ? l : std::min(e, path.size() - 1)]);
  }
  if (u > 0 && roles[0] == NameRole::upper_arm) limb.score += 0.15;  // most arms hang on a clavicle
  if (!has_end) return limb;
  const double first = (at(limb.lower) - at(limb.upper)).norm(), second = (at(limb.end) - at(limb.lower)).norm();
  const double shorter = std::min(first, second), longer = std::max(first, second);
  if (first + second < 0.04 * skeleton_.extent()) limb.score -= 1.5;
  if (longer > 0.0) limb.score += std::min(1.0, shorter / (0.6 * longer));
  limb.score += 0.5 * std::min(1.5, shorter / (0.1 * skeleton_.extent()));
  return limb;
}

Limb PlanSearch::best_limb(int start, const Roles& roles) const {
  Limb best;
  std::vector<int> path;
  int visited = 0;
  const std::function<void(int)> walk = [&](int joint) {
    if (path.size() == kDeepestPath || ++visited > kMostJoints) return;
    path.push_back(joint);
    const std::size_t last = path.size() - 1;
    for (std::size_t l = 1; l <= last; ++l) {
      for (std::size_t u = 0; u < l; ++u) {
        if (l == last) {  // two joints alone count only if names call them what they are
          if (affinity(path[u], roles[0]) < 0.55 || affinity(path[l], roles[1]) < 0.9) continue;
        }
        const Limb limb = limb_of(path, u, l, l == last ? path.size() : last, roles);
        if (limb.score > best.score) best = limb;
      }
    }
    for (const int child : skeleton_.children(joint)) walk(child);
    path.pop_back();
  };
  walk(start);
  return best;
}

std::vector<Pair> PlanSearch::find_pairs(const Roles& roles) const {
  std::vector<Pair> pairs;
  for (int joint = 0; joint < skeleton_.joint_count(); ++joint) {
    std::vector<std::pair<int, Limb>> limbs;
    for (const int child : skeleton_.children(joint)) {
      if (skeleton_.children(joint).size() < 2) break;
      const Limb limb = best_limb(child, roles);
      if (limb.score > 0.8) limbs.emplace_back(child, limb);
    }
    for (std::size_t i = 0; i < limbs.size(); ++i) {
      for (std::size_t k = i + 1; k < limbs.size(); ++k) {
        const Limb &a = limbs[i].second, &b = limbs[k].second;
        if (a.side != NameSide::none && a.side == b.side) continue;
        if ((a.end < 0) != (b.end < 0)) continue;
        double score = a.score + b.score + (a.side != b.side ? 0.5 : 0.0);
        const double length_a = (at(a.lower) - at(a.upper)).norm(), length_b = (at(b.lower) - at(b.upper)).norm();
        const double longer = std::max(length_a, length_b);
        if (longer > 0.0) score -= 2.0 * std::abs(length_a - length_b) / longer;
        pairs.push_back({joint, a, b, limbs[i].first, limbs[k].first, score});
      }
    }
  }
  std::stable_sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) { return a.score > b.score; });
  if (pairs.size() > kMostPairs) pairs.resize(kMostPairs);
  return pairs;
}

/// The joint below the chest that the trunk leads to: named a head, or at the end of the branch that goes on upward.
int PlanSearch::find_head(const Pair& leg, const Pair& arm, int hips, int chest, bool& named) const {
  const auto in_limb = [&](int joint) {
    for (const int branch : {leg.first_branch, leg.second_branch, arm.first_branch, arm.second_branch}) {
      if (is_below(branch, joint)) return true;
    }
    return false;
  };
  int best = -1;
  for (int joint = hips + 1; joint < skeleton_.joint_count(); ++joint) {
    if (!is_below(hips, joint) || in_limb(joint) || affinity(joint, NameRole::head) < 0.5) continue;
    if (best < 0 || affinity(joint, NameRole::head) > affinity(best, NameRole::head)) best = joint;
  }
  named = best >= 0;
  if (named) return best;
  const Vec3 up = at(chest) - at(hips);
  double highest = 0.0;
  int first = -1;
  for (const int branch : skeleton_.children(chest)) {
    if (branch == arm.first_branch || branch == arm.second_branch || name(branch).ignored) continue;
    for (int joint = branch; joint < skeleton_.joint_count(); ++joint) {
      if (!is_below(branch, joint)) continue;
      const double height = (at(joint) - at(chest)).dot(up);
      if (height > highest) {
        highest = height;
        first = branch;
      }
    }
  }
  return first < 0 ? -1 : follow_neck(first);
}

/// Up a neck without a named head: the last joint before the chain forks or ends; what ends a chain of three or more
/// that has no names is taken for the top of the head.
int PlanSearch::follow_neck(int first) const {
  std::vector<int> chain{first};
  for (;;) {
    std::vector<int> next;
    for (const int child : skeleton_.children(chain.back())) {
      if (!name(child).ignored) next.push_back(child);
    }
    if (next.size() != 1) {
      if (next.empty() && chain.size() > 2 && name(chain.back()).says_nothing()) chain.pop_back();
      return chain.back();
    }
    chain.push_back(next.front());
  }
}

/// The trunk stands over the legs, the parts have lengths that a body could have, and left mirrors right.
bool PlanSearch::stands_like_a_human(const BodyPlan& plan) const {
  const Vec3 trunk = at(plan.head) - at(plan.hips);
  const Vec3 hips = at(plan.left_leg.upper) - at(plan.right_leg.upper);
  const Vec3 shoulders = at(plan.left_arm.upper) - at(plan.right_arm.upper);
  if (std::abs(cosine(trunk, hips)) > 0.35 || cosine(hips, shoulders) < 0.7) return false;
  for (const Limb* limb : {&plan.left_leg, &plan.right_leg, &plan.left_arm, &plan.right_arm}) {
    if (limb->end < 0) return false;
  }
  for (const Limb* leg : {&plan.left_leg, &plan.right_leg}) {
    if (cosine(trunk, at(lowest_below(leg->end, trunk)) - at(leg->upper)) > -0.7) return false;
  }
  const double legs = 0.5 * (length_of(plan.left_leg) + length_of(plan.right_leg));
  const double arms = 0.5 * (length_of(plan.left_arm) + length_of(plan.right_arm));
  return is_mirrored(plan.left_leg, plan.right_leg) && is_mirrored(plan.left_arm, plan.right_arm) &&
         trunk.norm() > 0.3 * legs && trunk.norm() < 4.0 * legs && arms > 0.4 * legs && arms < 3.0 * legs;
}

double PlanSearch::length_of(const Limb& limb) const {
  return (at(limb.lower) - at(limb.upper)).norm() + (at(limb.end) - at(limb.lower)).norm();
}

/// The joint under `top` (or itself) that lies farthest against `up`.
int PlanSearch::lowest_below(int top, const Vec3& up) const {
  int lowest = top;
  std::vector<int> open{top};
  while (!open.empty()) {
    const int joint = open.back();
    open.pop_back();
    if (at(joint).dot(up) < at(lowest).dot(up)) lowest = joint;
    open.insert(open.end(), skeleton_.children(joint).begin(), skeleton_.children(joint).end());
  }
  return lowest;
}

/// One limb is the other's image in the plane between their upper joints, within a third of its length.
bool PlanSearch::is_mirrored(const Limb& a, const Limb& b) const {
  const Vec3 across = at(a.upper) - at(b.upper);
  if (across.norm() < 1e-6 * skeleton_.extent()) return false;
  const Vec3 axis = across.normalized();
  const Vec3 reach_a = at(a.end) - at(a.upper), reach_b = at(b.end) - at(b.upper);
  return (reach_a - 2.0 * axis * axis.dot(reach_a) - reach_b).norm() < 0.33 * std::max(length_of(a), length_of(b));
}

/// Fore legs hang beside hind legs, across the trunk.
bool PlanSearch::is_quadruped(const BodyPlan& plan) const {
  const Vec3 trunk = at(plan.head) - at(plan.hips);
  for (const auto& [leg, arm] :
       {std::pair(&plan.left_leg, &plan.left_arm), std::pair(&plan.right_leg, &plan.right_arm)}) {
    if (leg->end < 0 || arm->end < 0) return false;
    const Vec3 down = at(leg->end) - at(leg->upper);
    if (std::abs(cosine(trunk, down)) > 0.6 || cosine(down, at(arm->end) - at(arm->upper)) < 0.6) return false;
  }
  return true;
}

/// Left, where names say nothing: up x front, the front being where feet point, knees bend to and elbows away from.
Vec3 PlanSearch::find_left(const Pair& leg, const Pair& arm, const Vec3& up) const {
  const Vec3 across = at(leg.first.upper) - at(leg.second.upper);
  Vec3 front = across.cross(up);  // of unknown sign
  if (front.norm() < 1e-9 * up.squaredNorm()) return across;
  front.normalize();
  double evidence = 0.0;
  const auto bend = [&](const Limb& limb) -> double {
    if (limb.end < 0) return 0.0;
    const Vec3 whole = at(limb.end) - at(limb.upper), out = at(limb.lower) - at(limb.upper);
    if (whole.norm() < 1e-9) return 0.0;
    const Vec3 off = out - whole * (out.dot(whole) / whole.squaredNorm());
    return std::clamp(off.dot(front) / (0.02 * whole.norm()), -1.0, 1.0);
  };
  for (const Limb* limb : {&leg.first, &leg.second}) {
    evidence += 0.5 * bend(*limb);
    if (limb->end < 0) continue;
    for (const int toe : skeleton_.children(limb->end)) {
      const Vec3 foot = at(toe) - at(limb->end), down = (at(limb->end) - at(limb->upper)).normalized();
      if (foot.norm() > 0.0) evidence += 2.0 * (foot - down * down.dot(foot)).dot(front) / foot.norm();
    }
  }
  for (const Limb* limb : {&arm.first, &arm.second}) evidence -= 0.3 * bend(*limb);
  if (std::abs(evidence) < 0.05) evidence = front.z() + 1e-3 * front.x();
  return up.cross(evidence < 0.0 ? Vec3(-front) : front);
}

/// One body of a pair of legs and a pair of arms; its score, or 0 where they make none.
double PlanSearch::join(const Pair& leg, const Pair& arm, BodyPlan& plan) const {
  const auto path = skeleton_.path(leg.joint, arm.joint);
  plan.hips = *std::min_element(path.begin(), path.end());
  plan.chest = arm.joint;
  // A Biped's legs hang on its first spine bone.
  const int above = skeleton_.parent(plan.hips);
  if (affinity(plan.hips, NameRole::spine) > 0.0 && above >= 0 && affinity(above, NameRole::hips) > 0.5)
    plan.hips = above;
  if (plan.hips == plan.chest || skeleton_.joint(plan.hips).helper) return 0.0;
  for (const int branch : {leg.first_branch, leg.second_branch}) {
    if (is_below(branch, arm.joint)) return 0.0;
  }
  plan.head = find_head(leg, arm, plan.hips, plan.chest, plan.head_named);
  if (plan.head < 0) return 0.0;
  const bool leg_sides = leg.first.side != leg.second.side, arm_sides = arm.first.side != arm.second.side;
  bool swap_legs = leg.first.side == NameSide::right || leg.second.side == NameSide::left;
  bool swap_arms = arm.first.side == NameSide::right || arm.second.side == NameSide::left;
  const Vec3 up = at(plan.head) - at(plan.hips);
  const Vec3 across_legs = at(leg.first.upper) - at(leg.second.upper);
  const Vec3 across_arms = at(arm.first.upper) - at(arm.second.upper);
  const bool same_way = across_legs.dot(across_arms) >= 0.0;
  if (!leg_sides && !arm_sides) swap_legs = across_legs.dot(find_left(leg, arm, up)) < 0.0;
  if (!leg_sides && arm_sides) swap_legs = swap_arms == same_way;
  if (!arm_sides) swap_arms = swap_legs == same_way;
  plan.sides_named = leg_sides || arm_sides;
  plan.left_leg = swap_legs ? leg.second : leg.first;
  plan.right_leg = swap_legs ? leg.first : leg.second;
  plan.left_arm = swap_arms ? arm.second : arm.first;
  plan.right_arm = swap_arms ? arm.first : arm.second;
  for (const Limb* limb : {&plan.left_leg, &plan.right_leg, &plan.left_arm, &plan.right_arm}) {
    plan.names += limb->names / 4.0;
  }
  if (is_quadruped(plan)) return 0.0;
  const bool stands = stands_like_a_human(plan);
  if (!stands && (plan.names < 0.6 || !plan.head_named)) return 0.0;
  const double hips_named = std::max(0.0, affinity(plan.hips, NameRole::hips));
  return leg.score + arm.score + (plan.head_named ? 1.0 : 0.0) + 0.5 * hips_named + (stands ? 1.0 : 0.0);
}

}  // namespace

std::vector<JointName> read_joint_names(const Skeleton& skeleton) {
  std::vector<JointName> names;
  int named = 0;
  for (const Joint& joint : skeleton.joints()) {
    names.push_back(read_joint_name(joint.name));
    named += joint.name.empty() ? 0 : 1;
  }
  if (2 * named < skeleton.joint_count()) return names;
  for (int i = 0; i < skeleton.joint_count(); ++i) {
    if (skeleton.name(i).empty() && skeleton.children(i).empty()) names[static_cast<std::size_t>(i)].ignored = true;
  }
  return names;
}

std::optional<BodyPlan> find_body_plan(const Skeleton& skeleton, const std::vector<JointName>& names) {
  return PlanSearch(skeleton, names).run();
}

}  // namespace croquis
