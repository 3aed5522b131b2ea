// SPDX-License-Identifier: MIT
#pragma once

#include "loa/draws.h"
#include <vector>

namespace croquis::loa {

/// How far one answer lies from the truth.
struct Measure {
  double e2d = 0.0;      ///< mean distance in the picture between joints and where they truly are, % of H
  double tangent = 0.0;  ///< mean angle between projected bones and the true ones, degrees
  double e3d = 0.0;      ///< mean distance in space, chains centred, % of H
  double fit = 0.0;      ///< mean distance from the projected bones to the stroke and back, % of H
  double drift = 0.0;    ///< relative change of bone lengths
};

[[nodiscard]] Measure measure(const Draw& draw, const Pose& answer);

struct Summary {
  double mean = 0.0, median = 0.0, p90 = 0.0, p95 = 0.0;
};
[[nodiscard]] Summary summarise(std::vector<double> values);

}  // namespace croquis::loa
