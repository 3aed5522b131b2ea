// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

#include "croquis/sketch/stroke.h"

namespace croquis {

/// The strokes of an SVG in the pixels of a picture of the given size: each <path>, <polyline> and <line> is one stroke
/// (a path of several subpaths: one per subpath), curves flattened to a tenth of a pixel, transforms applied, the
/// viewBox fitted as `xMidYMid meet`. Throws Error{bad_file} with line or element; a file without a stroke is an error.
[[nodiscard]] std::vector<Stroke> read_svg_strokes(std::span<const std::byte> bytes, int width_px, int height_px);

/// The strokes as an SVG of that size, one <path> each with its name as id; raw samples (x y time pressure) stand in
/// a data attribute so that reading gives them back.
[[nodiscard]] std::string write_svg_strokes(const std::vector<Stroke>& strokes, int width_px, int height_px);

}  // namespace croquis
