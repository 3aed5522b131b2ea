// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "croquis/posing/line_solver.h"

namespace croquis {

/// A body line that a stroke may be meant for, and the pose that comes of it.
struct LineCandidate {
  BodyLine line;
  bool forward = true;
  double cost = 0.0;  ///< how implausible, the least first: what it asks of the body, how far it is from the stroke
  LineSolverResult result;
};

struct LineRankingOptions {
  int solved = 5;  ///< so many candidates of the screening are solved
  LineSolverOptions solver = {};
};

/// Finds the body line that a stroke is meant for. Every line of `lines` (standard_body_lines, say) is screened both
/// ways round in closed form against the line that the start pose has; the best few, each the way round that is nearer,
/// are solved and ranked by how much the pose must turn and move, how well it fits and how much longer or shorter the
/// line becomes. Candidates come best first; what ties is returned in the order of `lines`. A stroke far from the body
/// does not tell left from right: expect the partner among the first. Throws as solve_lines does.
[[nodiscard]] std::vector<LineCandidate> rank_body_lines(const Skeleton& skeleton, const HumanoidMap& humanoid,
                                                         const Pose& start, const std::vector<BodyLine>& lines,
                                                         const Polyline2& stroke, const Camera& camera,
                                                         const LineRankingOptions& options = {});

}  // namespace croquis
