// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "croquis/math/types.h"
#include "croquis/rig/humanoid.h"

namespace croquis {

/// A point that a node of a LineProblem carries: an end of a bone, the middle of a mass.
struct BodyPoint {
  int node = -1;
  Vec3 offset = Vec3::Zero();  ///< from the node, in the start pose
};

/// What the body is beside its lines, in problem units: what must stay above the floor, what must not pass through
/// each other, what must stay in balance.
struct BodyPoints {
  struct FloorPoint {
    BodyPoint at;
    double height = 0.0;  ///< along `up`; no lower
  };
  struct Capsule {
    BodyPoint from, to;
    double radius = 0.0;
  };
  struct Pair {
    int a = -1, b = -1;  ///< capsules
    double apart = 0.0;  ///< the axes keep this distance: both radii, or what they had at the start if that is less
  };
  struct Mass {
    BodyPoint at;
    double part = 0.0;  ///< of the whole; they sum to 1
  };

  Vec3 up = Vec3::UnitY();
  std::vector<FloorPoint> floor;
  std::vector<Capsule> capsules;
  std::vector<Pair> pairs;
  std::vector<Mass> masses;
  std::vector<BodyPoint> support;  ///< one or two feet; without any there is no balance to keep
  double support_radius = 0.0;     ///< the middle of the mass stays within this of them, or of the line between them
};

/// The way from a skeleton in model space to the nodes of a problem.
struct NodeMap {
  std::vector<int> carrier;  ///< per joint: the node that it moves with, -1: none does
  std::vector<Vec3> start;   ///< per node, problem units
  Affine view = Affine::Identity();
  double unit = 1.0;
};

/// What to keep of a body in the pose with these joint positions (model space).
struct BodyTerms {
  std::optional<double> floor;  ///< height in model space
  bool balance = false, overlap = false;
};
[[nodiscard]] BodyPoints make_body_points(const Skeleton& skeleton, const HumanoidMap& humanoid,
                                          std::span<const Vec3> positions, const NodeMap& nodes,
                                          const BodyTerms& terms);

/// The feet (a humanoid's; of other bodies that are held up by legs, the ends of these) that stand on the floor.
[[nodiscard]] std::vector<int> find_standing_feet(const Skeleton& skeleton, const HumanoidMap& humanoid,
                                                  std::span<const Vec3> positions, double floor);

}  // namespace croquis
