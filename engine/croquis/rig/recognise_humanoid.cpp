// SPDX-License-Identifier: MIT
// Names find most bones of most rigs; hierarchy and geometry settle what names leave open (a LeftLeg is a shin in one
// file and a thigh in another) and find the body where joints are called joint_7. See body_plan.h for the search; here
// the plan is filled in: spine, neck, shoulders, toes, fingers, eyes and jaw.
#include <algorithm>
#include <map>

#include "croquis/rig/body_plan.h"
#include "croquis/rig/humanoid.h"

namespace croquis {
namespace {

enum Finger { kThumb, kIndex, kMiddle, kRing, kLittle, kFingerCount };
constexpr NameRole kFingerRoles[kFingerCount] = {NameRole::thumb, NameRole::index, NameRole::middle, NameRole::ring,
                                                 NameRole::little};
using Chains = std::array<std::vector<int>, kFingerCount>;

HumanoidBone offset(HumanoidBone bone, int by) { return static_cast<HumanoidBone>(static_cast<int>(bone) + by); }

class Filling {
 public:
  Filling(const Skeleton& skeleton, const std::vector<JointName>& names, const BodyPlan& plan)
      : skeleton_(skeleton), names_(names), plan_(plan) {}

  [[nodiscard]] HumanoidMap run() {
    using enum HumanoidBone;
    map_.set(hips, plan_.hips, confidence(plan_.hips, NameRole::hips));
    map_.set(head, plan_.head, confidence(plan_.head, NameRole::head));
    fill_spine();
    fill_face();
    fill_leg(plan_.left_leg, leftUpperLeg);
    fill_leg(plan_.right_leg, rightUpperLeg);
    fill_arm(plan_.left_arm, leftShoulder, leftThumbMetacarpal);
    fill_arm(plan_.right_arm, rightShoulder, rightThumbMetacarpal);
    return map_;
  }

 private:
  [[nodiscard]] const JointName& name(int joint) const { return names_[static_cast<std::size_t>(joint)]; }

  /// 1 where the name says it plainly, 0.5 where only geometry does.
  [[nodiscard]] double confidence(int joint, NameRole role) const {
    return 0.5 + 0.5 * std::max(0.0, name(joint).affinity(role));
  }
  void set_sided(HumanoidBone bone, int joint, NameRole role) {
    const double sure = confidence(joint, role);
    map_.set(bone, joint, plan_.sides_named ? sure : 0.8 * sure);
  }

  /// The joints below `top`, nearest first.
  [[nodiscard]] std::vector<int> below(int top) const {
    std::vector<int> found = skeleton_.children(top);
    for (std::size_t i = 0; i < found.size(); ++i) {
      for (const int child : skeleton_.children(found[i])) found.push_back(child);
    }
    return found;
  }

  void fill_spine();
  void fill_face();
  void fill_leg(const Limb& leg, HumanoidBone upper);
  void fill_arm(const Limb& arm, HumanoidBone shoulder, HumanoidBone thumb);
  void fill_finger(std::vector<int> chain, Finger finger, HumanoidBone thumb);
  [[nodiscard]] Chains named_fingers(int hand) const;
  [[nodiscard]] Chains numbered_fingers(int hand) const;
  [[nodiscard]] Chains unnamed_fingers(int hand) const;

  const Skeleton& skeleton_;
  const std::vector<JointName>& names_;
  const BodyPlan& plan_;
  HumanoidMap map_;
};

/// Of a spine of more than three joints: the lowest, the one that carries the arms, and the middle one (the upper of
/// two).
void Filling::fill_spine() {
  using enum HumanoidBone;
  std::vector<int> spines, necks;
  const std::vector<int> trunk = skeleton_.path(plan_.hips, plan_.chest);
  for (std::size_t i = 1; i < trunk.size(); ++i) {
    const JointName& read = name(trunk[i]);
    if (read.ignored || read.affinity(NameRole::hips) > 0.0) continue;
    (read.affinity(NameRole::neck) > 0.0 ? necks : spines).push_back(trunk[i]);
  }
  for (const int joint : skeleton_.path(plan_.chest, plan_.head)) {
    const bool above = joint != plan_.head && !skeleton_.is_ancestor(joint, plan_.chest);
    if (above && !name(joint).ignored) necks.push_back(joint);
  }
  const auto set = [&](HumanoidBone bone, std::size_t at) {
    map_.set(bone, spines[at], confidence(spines[at], NameRole::spine));
  };
  const std::size_t count = spines.size();
  if (count > 0) set(spine, 0);
  if (count == 2) set(chest, 1);
  if (count > 2) {
    set(chest, count / 2);
    set(upperChest, count - 1);
  }
  if (!necks.empty()) map_.set(neck, necks.front(), confidence(necks.front(), NameRole::neck));
}

void Filling::fill_face() {
  using enum HumanoidBone;
  for (const int joint : below(plan_.head)) {
    const JointName& read = name(joint);
    const auto take = [&](HumanoidBone bone, NameRole role) {
      if (read.affinity(role) > 0.5 && !map_.has(bone)) map_.set(bone, joint, confidence(joint, role));
    };
    take(jaw, NameRole::jaw);
    if (read.side == NameSide::left) take(leftEye, NameRole::eye);
    if (read.side == NameSide::right) take(rightEye, NameRole::eye);
  }
}

void Filling::fill_leg(const Limb& leg, HumanoidBone upper) {
  set_sided(upper, leg.upper, NameRole::upper_leg);
  set_sided(offset(upper, 1), leg.lower, NameRole::lower_leg);
  if (leg.end < 0) return;
  set_sided(offset(upper, 2), leg.end, NameRole::foot);
  std::vector<int> named, plain;
  double surest = 0.0;
  for (const int joint : below(leg.end)) {
    const double says = name(joint).affinity(NameRole::toes);
    const int parent = skeleton_.parent(joint);
    if (says > surest) named.clear();
    surest = std::max(surest, says);
    const bool first = std::find(named.begin(), named.end(), parent) == named.end();
    if (says > 0.0 && says == surest && first) named.push_back(joint);
    if (parent == leg.end && name(joint).says_nothing()) plain.push_back(joint);
  }
  if (named.size() == 1) set_sided(offset(upper, 3), named.front(), NameRole::toes);  // five toes are no one bone
  if (named.empty() && plain.size() == 1) set_sided(offset(upper, 3), plain.front(), NameRole::toes);
}

void Filling::fill_arm(const Limb& arm, HumanoidBone shoulder, HumanoidBone thumb) {
  set_sided(offset(shoulder, 1), arm.upper, NameRole::upper_arm);
  set_sided(offset(shoulder, 2), arm.lower, NameRole::lower_arm);
  int clavicle = -1;
  const std::vector<int> path = skeleton_.path(plan_.chest, arm.upper);
  for (std::size_t i = 1; i + 1 < path.size(); ++i) {
    const double says = name(path[i]).affinity(NameRole::shoulder);
    if (says >= 0.0 && (clavicle < 0 || says > name(clavicle).affinity(NameRole::shoulder))) clavicle = path[i];
  }
  if (clavicle >= 0) set_sided(shoulder, clavicle, NameRole::shoulder);
  if (arm.end < 0) return;
  set_sided(offset(shoulder, 3), arm.end, NameRole::hand);
  Chains chains = named_fingers(arm.lower);
  const auto empty = [](const Chains& c) {
    return std::all_of(c.begin(), c.end(), [](const auto& v) { return v.empty(); });
  };
  if (empty(chains)) chains = numbered_fingers(arm.end);
  if (empty(chains)) chains = unnamed_fingers(arm.end);
  for (int finger = 0; finger < kFingerCount; ++finger) {
    fill_finger(chains[static_cast<std::size_t>(finger)], static_cast<Finger>(finger), thumb);
  }
}

/// Three joints of a chain that may begin with a bone of the palm and end with a tip.
void Filling::fill_finger(std::vector<int> chain, Finger finger, HumanoidBone thumb) {
  if (chain.empty()) return;
  const int number = name(chain.front()).number();
  if (chain.size() > 3 && finger != kThumb && number <= 0) chain.erase(chain.begin());
  // A thumb that is numbered from 2 has no metacarpal.
  const int from = finger == kThumb && number == 2 && chain.size() <= 2 ? 1 : 0;
  for (int i = 0; i < 3 - from && i < std::ssize(chain); ++i) {
    set_sided(offset(thumb, 3 * finger + from + i), chain[static_cast<std::size_t>(i)], kFingerRoles[finger]);
  }
}

Chains Filling::named_fingers(int hand) const {
  Chains chains;
  for (const int joint : below(hand)) {
    for (std::size_t finger = 0; finger < kFingerCount; ++finger) {
      std::vector<int>& chain = chains[finger];
      if (name(joint).affinity(kFingerRoles[finger]) < 0.5) continue;
      if (chain.empty() || skeleton_.is_ancestor(chain.back(), joint)) chain.push_back(joint);
    }
  }
  return chains;
}

/// "Finger0", "Finger01", ... (Biped) and "finger1-1", "finger1-2", ... (MakeHuman): the first digit counts from the
/// thumb.
Chains Filling::numbered_fingers(int hand) const {
  std::map<char, std::vector<int>> groups;
  for (const int joint : below(hand)) {
    if (name(joint).affinity(NameRole::finger) < 0.9 || name(joint).numbers.empty()) continue;
    groups[name(joint).numbers.front().front()].push_back(joint);
  }
  Chains chains;
  for (const auto& [digit, joints] : groups) {
    const int finger = digit - (groups.begin()->first == '0' ? '0' : '1');
    if (finger >= 0 && finger < kFingerCount) chains[static_cast<std::size_t>(finger)] = joints;
  }
  return chains;
}

/// Five chains without names: the thumb begins nearest to the wrist, the others lie the farther from it the later.
Chains Filling::unnamed_fingers(int hand) const {
  std::vector<std::vector<int>> found;
  for (const int child : skeleton_.children(hand)) {
    if (!name(child).says_nothing() || skeleton_.children(child).empty()) continue;
    std::vector<int> chain{child};
    while (skeleton_.children(chain.back()).size() == 1) chain.push_back(skeleton_.children(chain.back()).front());
    found.push_back(chain);
  }
  Chains chains;
  if (found.size() != kFingerCount) return chains;
  const auto at = [&](const std::vector<int>& chain) { return skeleton_.rest_position(chain.front()); };
  const auto by_distance = [&](const Vec3& from) {
    return [&, from](const auto& a, const auto& b) { return (at(a) - from).norm() < (at(b) - from).norm(); };
  };
  std::sort(found.begin(), found.end(), by_distance(skeleton_.rest_position(hand)));
  std::sort(found.begin() + 1, found.end(), by_distance(at(found.front())));
  std::copy(found.begin(), found.end(), chains.begin());
  return chains;
}

}  // namespace

HumanoidMap recognise_humanoid(const Skeleton& skeleton) {
  const std::vector<JointName> names = read_joint_names(skeleton);
  const std::optional<BodyPlan> plan = find_body_plan(skeleton, names);
  return plan ? Filling(skeleton, names, *plan).run() : HumanoidMap{};
}

}  // namespace croquis
