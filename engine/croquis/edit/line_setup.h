// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "croquis/posing/line_solver.h"
#include "croquis/project/project.h"

namespace croquis {

/// Throws invalid_argument for a word that is no preset of limits.
void check_limits(const std::string& preset);

/// The joint limits that hold for a character under a table's settings; none for what is no humanoid. Throws
/// as check_limits does.
[[nodiscard]] std::vector<JointLimit> limits_of(const TableSettings& settings, const Character& character);

/// The height (model y) below which no joint of an actor goes on the floor: that of the lowest joint as the character
/// opens, if it opens standing near y = 0, else of the lowest as it stands now.
[[nodiscard]] double floor_under(const Actor& actor);

/// The pin that "JOINT" (where it is in the actor's pose) or "JOINT=x,y,z" means. Throws invalid_argument.
[[nodiscard]] Pin parse_pin(const Actor& actor, std::string_view text);

/// What the line solver is to keep to: what the stroke's settings say, and what holds on the table (limits, floor, feet
/// that stand, balance, the actor's pins).
[[nodiscard]] LineSolverOptions make_solver_options(const Project& project, const Actor& actor,
                                                    const StrokeSettings& settings);

/// A stroke as the line solver wants it: cleaned, with its settings' curvature, direction and weight, and the pen's
/// pressure where there was one. A line across the shoulders or the hips is held by its ends alone: it tilts and turns
/// them, and what lies between follows.
[[nodiscard]] LineInput make_line_input(const PlacedStroke& stroke, const BodyLine& line);

/// Where a line's direction is open and the stroke starts much nearer to one end of it than to the other, it starts
/// there: people put the pen down where they mean. Else the solver finds out.
void settle_direction(LineInput& input, const Skeleton& skeleton, const Pose& pose, const Camera& camera);

}  // namespace croquis
