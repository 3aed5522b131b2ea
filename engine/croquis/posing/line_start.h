// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "croquis/posing/correspondence.h"
#include "croquis/posing/line_problem.h"

namespace croquis {

/// What the correspondence needs to know of a path's bones, from the start pose.
void measure_bones(const LineProblem& problem, const LinePath& path, std::vector<BoneSpan>& bones);

/// Lays every path on its stroke in closed form: the topmost joint goes to its point (if the body moves), and each bone
/// in turn is turned to its chord of the stroke, its depth +-sqrt(L^2 - chord^2) by `depth_sign` (per path and bone; +1
/// toward the viewer, 0: as in the start pose). Arc lengths `state.along` are taken as given.
void lay_on_chords(const LineProblem& problem, std::span<const std::vector<int>> depth_sign, LineState& state);

/// Bends straight limbs between a line and a pin by `bend` radians, the way they can: lengthwise nothing pulls a
/// straight knee to either side.
void bend_pinned_hinges(const LineProblem& problem, LineState& state, double bend);

}  // namespace croquis
