// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "croquis/posing/line_matching.h"
#include "croquis/posing/line_solver.h"
#include "croquis/project/project.h"

namespace croquis {

/// The joints that a comma-separated list means: names, or "#index" for what has no name of its own or a comma in it.
/// Throws invalid_argument that names the entry.
[[nodiscard]] std::vector<int> parse_joint_list(const Skeleton& skeleton, std::string_view list);
/// The list that parse_joint_list reads back.
[[nodiscard]] std::string format_joint_list(const Skeleton& skeleton, const std::vector<int>& joints);

/// What a stroke is matched with.
struct LineChoice {
  BodyLine line;  ///< its name or list of joints; `joints` empty for a selection that is no path
  std::vector<SkeletonSegment> segments;  ///< at least one
};

/// The joints that a stroke's settings choose: the standard line `body_line`; or `joints` as a path in their order; or,
/// where they are no path, as a selection (segments_of_selection); or, with neither, the character's default line.
/// Throws invalid_argument that names what is not there or the joint that makes the selection invalid.
[[nodiscard]] LineChoice choose_line(const Character& character, const StrokeSettings& settings);

/// Whether the settings ask for the line solver; otherwise they ask for one of the matching methods.
[[nodiscard]] bool is_line_method(const StrokeSettings& settings);

/// The options that the settings spell, for a matching method and for the line solver. A root that is "tangent" for the
/// one is "free" for the other, and the other way round. Throw invalid_argument that names the word and the words there
/// are.
[[nodiscard]] MatchOptions match_options(const StrokeSettings& settings);
[[nodiscard]] LineSolverOptions solver_options(const StrokeSettings& settings);
[[nodiscard]] LineInput::Direction solver_direction(const StrokeSettings& settings);

/// Throws invalid_argument if a word in the settings is none, or a factor out of its range.
void check_words(const StrokeSettings& settings);

}  // namespace croquis
