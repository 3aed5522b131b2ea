// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "croquis/edit/commands.h"
#include "croquis/edit/readings.h"

namespace croquis::cli {

/// What `pose` says of what it did.
struct PoseReport {
  std::vector<LineReport> lines;                         ///< one per stroke; none without a line
  std::vector<std::vector<StrokeReading>> alternatives;  ///< per stroke, or empty
  std::vector<std::string> notices;
  std::vector<std::string> outputs;
};

/// One JSON object: the first line's report, all of them under "lines" where there are several; without a line nothing
/// but "ok".
[[nodiscard]] std::string to_json(const PoseReport& report, const Skeleton& skeleton);
/// The same for people.
[[nodiscard]] std::string to_text(const PoseReport& report, const Skeleton& skeleton);

}  // namespace croquis::cli
