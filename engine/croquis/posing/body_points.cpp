// SPDX-License-Identifier: MIT
#include "croquis/posing/body_points.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "croquis/posing/body_shape.h"
#include "croquis/posing/joint_roles.h"

namespace croquis {
namespace {

/// Joints below which (the joint itself counted) nothing is lower.
int lowest_below(const Skeleton& skeleton, int top, std::span<const Vec3> positions) {
  int lowest = top;
  for (int joint = top; joint < skeleton.joint_count(); ++joint) {
    if (!skeleton.is_ancestor(top, joint)) continue;
    if (positions[static_cast<std::size_t>(joint)].y() < positions[static_cast<std::size_t>(lowest)].y()) {
      lowest = joint;
    }
  }
  return lowest;
}

BodyPoint carry(const NodeMap& nodes, int joint, const Vec3& at) {
  const int node = nodes.carrier[static_cast<std::size_t>(joint)];
  return {node, Vec3(nodes.view * at / nodes.unit - nodes.start[static_cast<std::size_t>(node)])};
}

/// Ways along the tree, in model units.
class TreeWays {
 public:
  TreeWays(const Skeleton& skeleton, std::span<const Vec3> positions) : skeleton_(skeleton), below_root_(1, 0.0) {
    for (int joint = 1; joint < skeleton.joint_count(); ++joint) {
      const auto parent = static_cast<std::size_t>(skeleton.parent(joint));
      below_root_.push_back(below_root_[parent] +
                            (positions[static_cast<std::size_t>(joint)] - positions[parent]).norm());
    }
  }
  /// Between the nearer ends of two bones; 0 if they share a joint.
  [[nodiscard]] double between(const BoneCapsule& a, const BoneCapsule& b) const {
    return std::min(std::min(between(a.parent, b.parent), between(a.parent, b.joint)),
                    std::min(between(a.joint, b.parent), between(a.joint, b.joint)));
  }

 private:
  [[nodiscard]] double between(int a, int b) const {
    const double sum = below_root_[static_cast<std::size_t>(a)] + below_root_[static_cast<std::size_t>(b)];
    while (a != b) (a > b ? a : b) = skeleton_.parent(std::max(a, b));
    return sum - 2.0 * below_root_[static_cast<std::size_t>(a)];
  }
  const Skeleton& skeleton_;
  std::vector<double> below_root_;
};

void add_capsules(const Skeleton& skeleton, std::span<const Vec3> positions, const NodeMap& nodes,
                  const std::vector<BoneCapsule>& capsules, BodyPoints& body) {
  std::vector<std::size_t> from;  // which capsule each of the body's came from
  for (std::size_t i = 0; i < capsules.size(); ++i) {
    const BoneCapsule& capsule = capsules[i];
    if (nodes.carrier[static_cast<std::size_t>(capsule.parent)] < 0) continue;
    body.capsules.push_back({carry(nodes, capsule.parent, capsule.from), carry(nodes, capsule.parent, capsule.to),
                             capsule.radius / nodes.unit});
    from.push_back(i);
  }
  const TreeWays ways(skeleton, positions);
  for (std::size_t a = 0; a < from.size(); ++a) {
    for (std::size_t b = a + 1; b < from.size(); ++b) {
      if (body.capsules[a].from.node == body.capsules[b].from.node) continue;  // do not move against each other
      const BoneCapsule &first = capsules[from[a]], &second = capsules[from[b]];
      const double radii = first.radius + second.radius;
      // Neighbours touch wherever they bend.
      if (ways.between(first, second) < 2.0 * radii) continue;
      const double now = nearest_points(first.from, first.to, second.from, second.to).distance;
      body.pairs.push_back({static_cast<int>(a), static_cast<int>(b), std::min(radii, now) / nodes.unit});
    }
  }
}

void add_masses(const NodeMap& nodes, const std::vector<BoneCapsule>& capsules, BodyPoints& body) {
  std::vector<double> mass(nodes.start.size(), 0.0);
  std::vector<Vec3> moment(nodes.start.size(), Vec3::Zero());
  double whole = 0.0;
  for (const BoneCapsule& capsule : capsules) {
    const int node = nodes.carrier[static_cast<std::size_t>(capsule.parent)];
    if (node < 0) continue;
    const double volume = capsule.radius * capsule.radius * ((capsule.to - capsule.from).norm() + 1.3 * capsule.radius);
    mass[static_cast<std::size_t>(node)] += volume;
    moment[static_cast<std::size_t>(node)] +=
        volume * carry(nodes, capsule.parent, 0.5 * (capsule.from + capsule.to)).offset;
    whole += volume;
  }
  for (std::size_t i = 0; i < mass.size(); ++i) {
    if (mass[i] > 0.0) body.masses.push_back({{static_cast<int>(i), moment[i] / mass[i]}, mass[i] / whole});
  }
}

void add_support(const Skeleton& skeleton, std::span<const Vec3> positions, const NodeMap& nodes,
                 const std::vector<int>& feet, BodyPoints& body) {
  std::vector<Vec3> middles;
  for (const int foot : feet) {
    if (nodes.carrier[static_cast<std::size_t>(foot)] < 0) continue;
    const int toe = lowest_below(skeleton, foot, positions);
    const Vec3 middle = 0.5 * (positions[static_cast<std::size_t>(foot)] + positions[static_cast<std::size_t>(toe)]);
    body.support.push_back(carry(nodes, foot, middle));
    middles.push_back(middle);
  }
  if (body.support.size() <= 2) return;
  // Of many feet the two that are farthest apart span the support.
  std::size_t a = 0, b = 1;
  for (std::size_t i = 0; i < middles.size(); ++i) {
    for (std::size_t j = i + 1; j < middles.size(); ++j) {
      if ((middles[i] - middles[j]).norm() > (middles[a] - middles[b]).norm()) a = i, b = j;
    }
  }
  body.support = {body.support[a], body.support[b]};
}

}  // namespace

std::vector<int> find_standing_feet(const Skeleton& skeleton, const HumanoidMap& humanoid,
                                    std::span<const Vec3> positions, double floor) {
  const double size = skeleton.extent();
  std::vector<int> feet;
  if (humanoid.is_humanoid()) {
    for (const HumanoidBone bone : {HumanoidBone::leftFoot, HumanoidBone::rightFoot}) {
      if (!humanoid.has(bone)) continue;
      const int foot = humanoid.joint(bone);
      const int toe = lowest_below(skeleton, foot, positions);
      // An ankle without toes below it stands as high as an ankle does.
      const double high = toe == foot ? 0.06 : 0.03;
      if (std::abs(positions[static_cast<std::size_t>(toe)].y() - floor) < high * size) feet.push_back(foot);
    }
    return feet;
  }
  const int root = find_body_root(skeleton, humanoid);
  if (positions[static_cast<std::size_t>(root)].y() - floor < 0.15 * size) return feet;  // it lies
  for (int joint = 1; joint < skeleton.joint_count(); ++joint) {
    if (!skeleton.children(joint).empty()) continue;
    if (std::abs(positions[static_cast<std::size_t>(joint)].y() - floor) < 0.02 * size) feet.push_back(joint);
  }
  return feet;
}

BodyPoints make_body_points(const Skeleton& skeleton, const HumanoidMap& humanoid, std::span<const Vec3> positions,
                            const NodeMap& nodes, const BodyTerms& terms) {
  BodyPoints body;
  body.up = nodes.view.linear() * Vec3::UnitY();
  if (terms.floor) {
    const double origin = nodes.view.inverse().translation().y();
    for (int joint = 0; joint < skeleton.joint_count(); ++joint) {
      if (skeleton.joint(joint).helper || nodes.carrier[static_cast<std::size_t>(joint)] < 0) continue;
      const Vec3& x = positions[static_cast<std::size_t>(joint)];
      body.floor.push_back({carry(nodes, joint, x), (std::min(*terms.floor, x.y()) - origin) / nodes.unit});
    }
  }
  if (!terms.overlap && !(terms.balance && terms.floor)) return body;
  const std::vector<BoneCapsule> capsules = make_bone_capsules(skeleton, humanoid, positions);
  if (terms.overlap) add_capsules(skeleton, positions, nodes, capsules, body);
  if (terms.balance && terms.floor) {
    add_masses(nodes, capsules, body);
    add_support(skeleton, positions, nodes, find_standing_feet(skeleton, humanoid, positions, *terms.floor), body);
    body.support_radius = 0.05 * skeleton.extent() / nodes.unit;
  }
  return body;
}

}  // namespace croquis
