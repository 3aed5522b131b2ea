// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "croquis/project/project.h"

namespace croquis {

/// A way to read a stroke: settings in which body line and direction are said.
struct StrokeReading {
  std::string label;  ///< the line's name, and "(backward)" where the stroke starts at its last joint
  StrokeSettings settings;
};

/// What a stroke drawn over `pose` may mean, likeliest first, at most six: the body lines that it may be meant for
/// (where its settings say body_line "auto" and name no joints), each from both ends (where they say direction "auto").
/// Ranked by how near the stroke's ends and length come to the line's in the picture. A stroke that starts at the feet
/// or at the root is likelier than one that ends there.
[[nodiscard]] std::vector<StrokeReading> readings_of(const Character& character, const Pose& pose,
                                                     const PlacedStroke& stroke);

}  // namespace croquis
