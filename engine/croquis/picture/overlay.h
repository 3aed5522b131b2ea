// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "croquis/picture/canvas.h"
#include "croquis/picture/picture.h"

namespace croquis {

/// The discs that a brush pen leaves along a stroke, in the picture's pixels: thicker under pressure, tapered at both
/// ends, through the samples by a curve where a hand drew them and straight from one to the next where a program did.
/// `size` is the radius at pressure 0.5.
[[nodiscard]] std::vector<Disc> make_ink_path(const Stroke& stroke, double size);

/// Strokes as ink: the first in sanguine, further ones in blue.
void paint_strokes(Canvas& canvas, const std::vector<Stroke>& strokes, const Camera& camera);

/// The bones of the actors as tapered kites with a dot at each joint, those farther away first. Helpers are left out.
void paint_skeletons(Canvas& canvas, const std::vector<PictureActor>& actors, const Camera& camera);

}  // namespace croquis
