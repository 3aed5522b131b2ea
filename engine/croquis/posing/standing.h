// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "croquis/posing/line_solver.h"

namespace croquis {

/// Pins for the feet that stand on options.floor in the start pose, that a line or a moving body would carry off, and
/// that nothing else (a line, a pin) says what to do with. Empty without a floor, or if options.stand is off.
[[nodiscard]] std::vector<PosePin> pin_standing_feet(const Skeleton& skeleton, const HumanoidMap& humanoid,
                                                     const Pose& start, const std::vector<LineInput>& inputs,
                                                     const LineSolverOptions& options);

}  // namespace croquis
