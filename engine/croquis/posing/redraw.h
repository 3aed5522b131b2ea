// SPDX-License-Identifier: MIT
#pragma once

#include "croquis/posing/line_problem.h"

namespace croquis {

/// How much of a solution a stroke asks for, 0..1: 0 where every stroke is, to 0.15 % of the line's length, the line
/// that the start pose already has (its joints joined by straight pieces, or by
/// the curve that extract_line draws), 1 where one differs from it by more than
/// 0.6 %; smooth between. Without this the solver would improve on a pose that was merely read off and drawn again.
[[nodiscard]] double redraw_share(const LineProblem& problem);

/// Takes that share of the turns and shifts of a solution.
void take_share(const LineProblem& problem, double share, LineState& state);

}  // namespace croquis
