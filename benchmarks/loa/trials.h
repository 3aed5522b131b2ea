// SPDX-License-Identifier: MIT
#pragma once

#include "loa/draws.h"
#include <vector>

#include <nlohmann/json.hpp>

#include "croquis/rig/joint_limits.h"

namespace croquis::loa {

/// The joints of the draw's line that a pose turns beyond a preset's limits, those left out that the start exceeds.
[[nodiscard]] std::vector<int> broken_limits(const Draw& draw, LimitPreset preset, const Pose& pose);

/// How many of the true poses exceed each preset.
void print_truths(const DrawSet& set, nlohmann::ordered_json& report);
/// How far the people of the clips turn their joints, as TurnPrior states it: left and right together, root mean square
/// over the poses of a clip, mean over the clips.
void print_spreads(const DrawSet& set, nlohmann::ordered_json& report);
/// How often the body line that a stroke is meant for is found.
void print_line_trial(const DrawSet& set, nlohmann::ordered_json& report);
/// The stroke drawn point by point: how far joints turn per pixel of the pen, how long an update takes, and how near
/// the pose at the end comes.
void print_live_trial(const DrawSet& set, nlohmann::ordered_json& report);

}  // namespace croquis::loa
