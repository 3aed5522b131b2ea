// SPDX-License-Identifier: MIT
#include "croquis/body/tree.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "croquis/base/random.h"
#include "croquis/body/forms.h"
#include "croquis/body/sculpture.h"

namespace croquis {
namespace {

constexpr int kTrunkJoints = 6;
constexpr int kBoughJoints = 3;
constexpr double kThinnestTwig = 0.019;  // metres; the mesh has edges of 0.026 there

struct Bough {
  double height;          // on the trunk, 0..1
  double azimuth, rise;   // degrees; rise from the horizontal at its root
  double length, radius;  // metres
};

constexpr Bough kBoughs[] = {
    {0.46, 20.0, 32.0, 1.05, 0.075}, {0.53, 155.0, 36.0, 1.00, 0.072}, {0.60, 268.0, 38.0, 0.95, 0.066},
    {0.68, 85.0, 42.0, 0.85, 0.060}, {0.74, 205.0, 46.0, 0.80, 0.056}, {0.82, 325.0, 50.0, 0.70, 0.050},
};

Vec3 trunk_point(double t) {  // gently leaning to and fro
  return {0.10 * std::sin(2.6 * t), 2.35 * t, 0.07 * std::sin(4.0 * t + 0.5) - 0.034};
}

double trunk_radius(double t, double thick) { return thick * (0.165 - 0.105 * t + 0.10 * std::exp(-9.0 * t)); }

struct TreePlan {
  Armature armature;
  std::vector<int> trunk;
  std::vector<std::vector<int>> boughs;  ///< each with the trunk's joint first
  std::vector<std::vector<Vec3>> paths;  ///< points along each bough, its tip last
};

TreePlan plan_tree(const Proportions& p) {
  TreePlan plan;
  for (int i = 0; i < kTrunkJoints; ++i) {
    const int parent = i == 0 ? -1 : plan.trunk.back();
    plan.trunk.push_back(plan.armature.add("trunk_" + std::to_string(i + 1), parent,
                                           trunk_point(i / static_cast<double>(kTrunkJoints))));
  }
  int number = 0;
  for (const Bough& bough : kBoughs) {
    const int holder = plan.trunk[static_cast<std::size_t>(bough.height * kTrunkJoints)];
    std::vector<Vec3> path{trunk_point(bough.height)};
    std::vector<int> joints{holder};
    const double azimuth = bough.azimuth * kDegree, step = bough.length * p.limbs / kBoughJoints;
    ++number;
    for (int i = 0; i < kBoughJoints; ++i) {
      const std::string name = "branch_" + std::to_string(number) + "_" + std::to_string(i + 1);
      joints.push_back(plan.armature.add(name, joints.back(), path.back()));
      const double rise = (bough.rise + 9.0 * i) * kDegree, turn = azimuth + 0.14 * i;
      path.emplace_back(path.back() +
                        step * Vec3(std::cos(rise) * std::cos(turn), std::sin(rise), std::cos(rise) * std::sin(turn)));
    }
    plan.boughs.push_back(joints);
    plan.paths.push_back(path);
  }
  return plan;
}

Sculpture make_wood(const TreePlan& plan, const Proportions& p) {
  const double thick = std::pow(p.muscle, 0.8);
  const Vec3 x = Vec3::UnitX(), z = Vec3::UnitZ();
  Sculpture wood;
  wood.name = "wood";
  wood.color = Vec4f(0.30F, 0.20F, 0.13F, 1.0F);
  std::vector<Section> sections;
  for (int i = 0; i <= 8; ++i)
    sections.push_back(round_section(trunk_point(std::max(i / 8.0, 0.03)), trunk_radius(i / 8.0, thick)));
  wood.root.forms.push_back(make_form(Loft(std::move(sections), x, z, 0.066, 0.06), {plan.trunk, 0.0, 0.042, 0.8}));
  for (int i = 0; i < 6; ++i) {  // roots
    const double turn = (60.0 * i + 17.0 * (i % 2)) * kDegree, reach = (0.40 + 0.07 * (i % 3)) * thick;
    const Vec3 out(std::cos(turn), 0.0, std::sin(turn));
    const Vec3 foot = trunk_point(0.0);
    const double tip = std::max(0.026 * thick, 0.022);
    wood.root.forms.push_back(
        make_form(Loft({round_section(foot + Vec3(0, 0.26, 0) + 0.10 * thick * out, 0.055 * thick),
                        round_section(foot + Vec3(0, 0.055 * thick, 0) + 0.6 * reach * out, 0.055 * thick),
                        round_section(foot + Vec3(0, tip, 0) + reach * out, tip)},
                       out.cross(Vec3::UnitY()), Vec3::UnitY()),
                  {{plan.trunk[0]}, 0.12 * thick, 0.034}));
  }
  for (std::size_t b = 0; b < plan.boughs.size(); ++b) {
    const double r = kBoughs[b].radius * thick;
    const std::vector<Vec3>& path = plan.paths[b];
    std::vector<Section> along;
    for (std::size_t i = 0; i < path.size(); ++i) {
      along.push_back(
          round_section(path[i], std::max(r * (1.0 - 0.62 * static_cast<double>(i) / kBoughJoints), kThinnestTwig)));
    }
    Limb bough{{make_form(Loft(std::move(along), x, z), {plan.boughs[b], 0.0, 0.026, 1.0})}, 0.10 * thick};
    wood.root.limbs.push_back(bough);
  }
  return wood;
}

Sculpture make_crown(const TreePlan& plan, const Proportions& p) {
  Sculpture crown;
  crown.name = "leaves";
  crown.color = Vec4f(0.20F, 0.36F, 0.12F, 1.0F);
  crown.weights.spread = 0.5;
  Random random(20);
  const auto add_clump = [&](const Vec3& center, double radius, int joint) {
    radius *= p.head;
    crown.root.forms.push_back(
        make_form(Ellipsoid(center, Vec3(radius, 0.82 * radius, radius)), {{joint}, 0.10, 0.055}));
    for (int i = 0; i < 9; ++i) {  // smaller heaps around it, so that the outline is of leaves, not of a ball
      const double turn = random.uniform(0.0, 2.0 * kPi), up = random.uniform(-0.35, 0.9),
                   r = radius * random.uniform(0.36, 0.52);
      const double flat = std::sqrt(1.0 - up * up);
      const Vec3 out(flat * std::cos(turn), 0.82 * up, flat * std::sin(turn));
      crown.root.forms.push_back(
          make_form(Ellipsoid(center + 0.88 * radius * out, Vec3(r, 0.85 * r, r)), {{joint}, 0.07, 0.055}));
    }
  };
  for (std::size_t b = 0; b < plan.paths.size(); ++b) {
    add_clump(plan.paths[b].back() + Vec3(0, 0.10, 0), 0.40 - 0.02 * static_cast<double>(b), plan.boughs[b].back());
  }
  add_clump(trunk_point(1.0) + Vec3(0, 0.22, 0), 0.46, plan.trunk.back());
  add_clump(trunk_point(0.86) + Vec3(0, 0.05, 0), 0.52, plan.trunk.back());
  return crown;
}

}  // namespace

Character make_tree(const Proportions& proportions) {
  const TreePlan plan = plan_tree(proportions);
  Character tree = assemble("tree", plan.armature, make_wood(plan, proportions));
  tree.parts.push_back(build_part(make_crown(plan, proportions), plan.armature));
  return tree;
}

}  // namespace croquis
