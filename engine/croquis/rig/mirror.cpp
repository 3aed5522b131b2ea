// SPDX-License-Identifier: MIT
// Partners by the humanoid map, then by names, then by a walk down the tree from joints whose partners are known: the
// children of two partners, or of a joint of the middle, are matched where one's branch is the other's image in the
// plane of symmetry. That plane comes from the partners known so far, else from the best of a few planes.
#include "croquis/rig/mirror.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "croquis/rig/joint_name.h"

namespace croquis {
namespace {

struct Plane {
  Vec3 normal = Vec3::UnitX();
  double offset = 0.0;

  [[nodiscard]] Vec3 reflect(const Vec3& p) const { return p - 2.0 * (normal.dot(p) - offset) * normal; }
};

class Matching {
 public:
  explicit Matching(const Skeleton& skeleton)
      : skeleton_(skeleton),
        partner_(skeleton.joints().size(), -1),
        fixed_(skeleton.joints().size(), false),
        centre_(skeleton.joints().size(), Vec3::Zero()),
        size_(skeleton.joints().size(), 1),
        length_(skeleton.joints().size(), 0.0) {
    for (int i = skeleton.joint_count() - 1; i >= 0; --i) {
      centre_[at(i)] += skeleton.rest_position(i);
      if (i == 0) break;
      const int parent = skeleton.parent(i);
      length_[at(i)] += (skeleton.rest_position(i) - skeleton.rest_position(parent)).norm();
      centre_[at(parent)] += centre_[at(i)];
      size_[at(parent)] += size_[at(i)];
      length_[at(parent)] += length_[at(i)];
    }
    for (std::size_t i = 0; i < centre_.size(); ++i) centre_[i] /= size_[i];
  }

  void pair(int a, int b) {
    if (a == b || partner_[at(a)] >= 0 || partner_[at(b)] >= 0) return;
    partner_[at(a)] = b;
    partner_[at(b)] = a;
  }
  void pair_by_map(const HumanoidMap& humanoid);
  void pair_by_names();
  [[nodiscard]] std::optional<Plane> plane_of_pairs() const;
  [[nodiscard]] std::vector<Plane> plausible_planes() const;
  /// Matches what is left; returns how much of the tree has its image in it.
  double pair_by_geometry(const Plane& plane);
  /// What is matched so far stays.
  void fix() {
    for (std::size_t i = 0; i < fixed_.size(); ++i) fixed_[i] = partner_[i] >= 0;
  }

  [[nodiscard]] std::vector<int> result() const {
    std::vector<int> map = partner_;
    for (std::size_t i = 0; i < map.size(); ++i) map[i] = map[i] < 0 ? static_cast<int>(i) : map[i];
    return map;
  }

 private:
  [[nodiscard]] static std::size_t at(int joint) { return static_cast<std::size_t>(joint); }
  /// Branches of about as many joints and as much bone.
  [[nodiscard]] bool is_alike(int a, int b, double tolerance) const;
  [[nodiscard]] double distance(const Plane& plane, int a, int b) const;
  void untangle(const Plane& plane, const std::vector<int>& children);

  const Skeleton& skeleton_;
  std::vector<int> partner_;
  std::vector<bool> fixed_;
  std::vector<Vec3> centre_;    ///< of the joints of the branch that begins here
  std::vector<int> size_;       ///< how many they are
  std::vector<double> length_;  ///< of its bones together, the one above it too
};

void Matching::pair_by_map(const HumanoidMap& humanoid) {
  for (int i = 0; i < kHumanoidBoneCount; ++i) {
    const auto bone = static_cast<HumanoidBone>(i);
    // Fingers that were only guessed are found better by their places.
    const bool guessed = bone >= HumanoidBone::leftThumbMetacarpal && humanoid.entries[at(i)].confidence < 0.6;
    if (guessed || !humanoid.has(bone) || !humanoid.has(mirror(bone))) continue;
    pair(humanoid.joint(bone), humanoid.joint(mirror(bone)));
  }
}

void Matching::pair_by_names() {
  std::map<std::string, std::pair<std::vector<int>, std::vector<int>>> groups;
  for (int i = 0; i < skeleton_.joint_count(); ++i) {
    const auto [side, rest] = split_side(skeleton_.name(i));
    if (side == NameSide::left) groups[rest].first.push_back(i);
    if (side == NameSide::right) groups[rest].second.push_back(i);
  }
  for (const auto& [rest, sides] : groups) {
    if (sides.first.size() == 1 && sides.second.size() == 1) pair(sides.first.front(), sides.second.front());
  }
}

std::optional<Plane> Matching::plane_of_pairs() const {
  Vec3 normal = Vec3::Zero(), middle = Vec3::Zero();
  int count = 0;
  for (int a = 0; a < skeleton_.joint_count(); ++a) {
    const int b = partner_[at(a)];
    if (b <= a) continue;
    Vec3 across = skeleton_.rest_position(a) - skeleton_.rest_position(b);
    if (across.dot(normal) < 0.0) across = -across;
    normal += across;
    middle += 0.5 * (skeleton_.rest_position(a) + skeleton_.rest_position(b));
    ++count;
  }
  if (count == 0 || normal.norm() < 1e-6 * skeleton_.extent()) return std::nullopt;
  normal.normalize();
  return Plane{normal, normal.dot(middle) / count};
}

/// Planes across the axes through the root, and between branches of one joint that are alike.
std::vector<Plane> Matching::plausible_planes() const {
  std::vector<Plane> planes;
  int root = 0;
  while (root + 1 < skeleton_.joint_count() && skeleton_.joint(root).helper) ++root;
  for (const Vec3& axis : {Vec3(Vec3::UnitX()), Vec3(Vec3::UnitZ()), Vec3(Vec3::UnitY())}) {
    planes.push_back({axis, axis.dot(skeleton_.rest_position(root))});
  }
  constexpr std::size_t kMostPlanes = 60;
  for (int joint = 0; joint < skeleton_.joint_count(); ++joint) {
    const std::vector<int>& children = skeleton_.children(joint);
    for (std::size_t i = 0; i < children.size() && planes.size() < kMostPlanes; ++i) {
      for (std::size_t k = i + 1; k < children.size() && planes.size() < kMostPlanes; ++k) {
        if (!is_alike(children[i], children[k], 0.2)) continue;
        const Vec3 a = centre_[at(children[i])], b = centre_[at(children[k])];
        if ((a - b).norm() < 0.02 * skeleton_.extent()) continue;
        const Vec3 normal = (a - b).normalized();
        planes.push_back({normal, 0.5 * normal.dot(a + b)});
      }
    }
  }
  return planes;
}

bool Matching::is_alike(int a, int b, double tolerance) const {
  const double shorter = std::min(length_[at(a)], length_[at(b)]), longer = std::max(length_[at(a)], length_[at(b)]);
  const int smaller = std::min(size_[at(a)], size_[at(b)]), larger = std::max(size_[at(a)], size_[at(b)]);
  return shorter >= (1.0 - tolerance) * longer - 1e-6 * skeleton_.extent() && smaller >= (1.0 - tolerance) * larger;
}

/// From the image of one branch to the other, in units of the skeleton's extent. Under two partners the branches are
/// compared where they begin, so that arms in different places have alike fingers.
double Matching::distance(const Plane& plane, int a, int b) const {
  const int above_a = skeleton_.parent(a), above_b = skeleton_.parent(b);
  Vec3 shift = Vec3::Zero();
  if (above_a != above_b) shift = skeleton_.rest_position(above_b) - plane.reflect(skeleton_.rest_position(above_a));
  const Vec3 centres = plane.reflect(centre_[at(a)]) + shift - centre_[at(b)];
  const Vec3 starts = plane.reflect(skeleton_.rest_position(a)) + shift - skeleton_.rest_position(b);
  return (centres.norm() + starts.norm()) / skeleton_.extent();
}

/// The nearest first is greedy: two pairs change partners where that brings the four nearer (in squares) together.
void Matching::untangle(const Plane& plane, const std::vector<int>& children) {
  const auto square = [&](int a, int b) { return distance(plane, a, b) * distance(plane, a, b); };
  bool changed = true;
  for (int round = 0; changed && round < 100; ++round) {
    changed = false;
    for (const int a : children) {
      for (const int c : children) {
        const int b = partner_[at(a)], d = partner_[at(c)];
        if (c <= a || b < 0 || d < 0 || fixed_[at(a)] || fixed_[at(c)]) continue;
        if (skeleton_.parent(b) != skeleton_.parent(d) || !is_alike(a, d, 0.5) || !is_alike(c, b, 0.5)) continue;
        if (square(a, d) + square(c, b) > 0.999 * (square(a, b) + square(c, d)) - 1e-12) continue;
        partner_[at(a)] = d;
        partner_[at(d)] = a;
        partner_[at(c)] = b;
        partner_[at(b)] = c;
        changed = true;
      }
    }
  }
}

double Matching::pair_by_geometry(const Plane& plane) {
  constexpr double kFarthest = 0.3;
  constexpr std::size_t kMostChildren = 200;  // more than that under one joint are no body parts
  struct Candidate {
    double distance;
    int a, b;
  };
  double image = 0.0;
  for (int joint = 0; joint < skeleton_.joint_count(); ++joint) {
    const int other = partner_[at(joint)] < 0 ? joint : partner_[at(joint)];
    if (other < joint || skeleton_.children(joint).size() > kMostChildren) continue;
    std::vector<Candidate> candidates;
    for (const int a : skeleton_.children(joint)) {
      for (const int b : skeleton_.children(other)) {
        if (partner_[at(a)] >= 0 || partner_[at(b)] >= 0 || (joint == other && b <= a)) continue;
        if (!is_alike(a, b, joint == other ? 0.2 : 0.5)) continue;
        const double apart = distance(plane, a, b);
        // What lies in the plane is its own image and nobody's partner.
        const double own = joint == other ? std::min(distance(plane, a, a), distance(plane, b, b)) : 1e9;
        if (apart < kFarthest && apart < 0.5 * own) candidates.push_back({apart, a, b});
      }
    }
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate& x, const Candidate& y) { return x.distance < y.distance; });
    for (const Candidate& c : candidates) pair(c.a, c.b);
    if (other != joint) untangle(plane, skeleton_.children(joint));
  }
  for (int a = 0; a < skeleton_.joint_count(); ++a) {
    const int b = partner_[at(a)] < 0 ? a : partner_[at(a)];
    const Vec3 away = plane.reflect(skeleton_.rest_position(a)) - skeleton_.rest_position(b);
    image += std::max(0.0, 1.0 - 20.0 * away.norm() / skeleton_.extent());
  }
  return image;
}

}  // namespace

std::vector<int> compute_mirror_map(const Skeleton& skeleton, const HumanoidMap& humanoid) {
  Matching known(skeleton);
  known.pair_by_map(humanoid);
  known.pair_by_names();
  known.fix();
  if (const std::optional<Plane> plane = known.plane_of_pairs()) {
    known.pair_by_geometry(*plane);
    return known.result();
  }
  std::vector<int> best = known.result();
  double best_image = -1.0;
  for (const Plane& plane : known.plausible_planes()) {
    Matching tried = known;
    const double image = tried.pair_by_geometry(plane);
    if (image > best_image + 1e-6 * skeleton.joint_count()) {
      best_image = image;
      best = tried.result();
    }
  }
  return best;
}

}  // namespace croquis
