// SPDX-License-Identifier: MIT
#pragma once

#include "loa/draws.h"
#include <functional>
#include <string>
#include <vector>

#include "croquis/posing/line_solver.h"

namespace croquis::loa {

/// A way of answering a draw.
struct Method {
  std::string name;
  std::function<Pose(const Draw&)> answer;
};

/// start, near, curvilinear, rotation by index, rotation by arc length, the line solver, the same with anatomical
/// limits, and the solver told the true correspondence or the true depths. `direction_known`: they are told where the
/// stroke starts.
[[nodiscard]] std::vector<Method> all_methods(bool direction_known);

/// What the benchmark asks the solver with; `limits` by a preset from the clip's neutral pose.
[[nodiscard]] LineSolverOptions solver_options(const Draw& draw, LimitPreset limits);
[[nodiscard]] LineSolverResult solve_draw(const Draw& draw, bool direction_known, const LineSolverOptions& options);

}  // namespace croquis::loa
