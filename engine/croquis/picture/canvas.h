// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "croquis/math/types.h"

namespace croquis {

/// A rectangle of a picture in premultiplied linear light, float RGBA, that antialiased shapes are painted on. Shapes
/// are in the pixels of the whole picture: x right, y down, pixel (i, j) covers [i, i + 1) x [j, j + 1).
struct Canvas {
  int left = 0;  ///< of the rectangle in the picture
  int top = 0;
  int width = 0;
  int height = 0;
  std::vector<Vec4f> pixels;

  Canvas(int left_px, int top_px, int width_px, int height_px)
      : left(left_px),
        top(top_px),
        width(width_px),
        height(height_px),
        pixels(static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px), Vec4f(Vec4f::Zero())) {}

  [[nodiscard]] Vec4f& at(int x, int y) {
    return pixels[static_cast<std::size_t>(y - top) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x - left)];
  }
};

/// Linear light and how much of it covers what lies under it, 0..1.
struct Paint {
  Vec3f color = Vec3f::Zero();
  float opacity = 1.0F;
};

/// 0xRRGGBB in sRGB.
[[nodiscard]] Paint make_paint(unsigned rgb, float opacity = 1.0F);

struct Disc {
  Vec2 centre = Vec2::Zero();
  double radius = 1.0;
};

/// The area that a disc covers as it runs from each disc to the next, changing its radius evenly, painted once: where
/// the path crosses itself it is no darker.
void paint_sweep(Canvas& canvas, std::span<const Disc> path, const Paint& paint);

/// A polygon (any simple one), filled, and its outline of the given width.
void paint_polygon(Canvas& canvas, std::span<const Vec2> corners, const Paint& fill, const Paint& line, double width);

}  // namespace croquis
