// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "croquis/posing/line_problem.h"

namespace croquis {

/// A limit that a descent step has to respect: normal . v <= 0 for the turn v of one node.
struct ActiveLimit {
  std::size_t limit = 0;  ///< index in LineProblem::limits
  int column = 0;
  Vec3 normal = Vec3::Zero();
};

/// `limit` widened until it holds the local rotation; true if it had to be.
bool widen_limit(JointLimit& limit, const Quat& local_rotation);

/// Brings every limited joint back inside, parents and children alike; `touched` receives the limits that were crossed
/// and by which way (coordinates before - after).
struct Crossing {
  std::size_t limit = 0;
  Vec3 outward = Vec3::Zero();  ///< in limit coordinates, unit
};
void clamp_to_limits(const LineProblem& problem, LineState& state, std::vector<Crossing>& touched);

/// The limits on whose border the state stands and across which the descent (down `gradient`) would go.
void find_active_limits(const LineProblem& problem, const LineState& state, const Eigen::VectorXd& gradient,
                        std::vector<ActiveLimit>& active);

/// The normal, by the turn v of its node, of a direction in limit coordinates.
[[nodiscard]] Vec3 limit_normal(const LineProblem& problem, const LineState& state, std::size_t limit,
                                const Vec3& outward);

}  // namespace croquis
