// SPDX-License-Identifier: MIT
// Shapes are painted from their signed distances: a pixel is covered by 1/2 - distance, clamped, which for edges that
// are straight at the scale of a pixel is within a few percent of the exact area.
#include "croquis/picture/canvas.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "croquis/picture/image.h"

namespace croquis {
namespace {

/// Pixels of the canvas that a box of the picture touches.
struct Region {
  int left, top, right, bottom;  // right and bottom are not in it
  [[nodiscard]] bool is_empty() const { return left >= right || top >= bottom; }
};

Region clip(const Canvas& canvas, const Eigen::AlignedBox2d& box) {
  const auto cell = [](double value, int low, int high) {
    return static_cast<int>(std::floor(std::clamp(value, static_cast<double>(low), static_cast<double>(high))));
  };
  return {cell(box.min().x() - 1, canvas.left, canvas.left + canvas.width),
          cell(box.min().y() - 1, canvas.top, canvas.top + canvas.height),
          cell(box.max().x() + 2, canvas.left, canvas.left + canvas.width),
          cell(box.max().y() + 2, canvas.top, canvas.top + canvas.height)};
}

Eigen::AlignedBox2d box_around(std::span<const Disc> discs) {
  Eigen::AlignedBox2d box;
  for (const Disc& disc : discs) {
    box.extend(Vec2(disc.centre.array() - disc.radius));
    box.extend(Vec2(disc.centre.array() + disc.radius));
  }
  return box;
}

void put(Vec4f& pixel, const Paint& paint, float coverage) {
  const float alpha = paint.opacity * coverage;
  pixel *= 1.0F - alpha;
  pixel.head<3>() += alpha * paint.color;
  pixel.w() += alpha;
}

float coverage_of(double distance) { return static_cast<float>(std::clamp(0.5 - distance, 0.0, 1.0)); }

/// Distance to the hull of two discs, negative inside: the distance to the one disc between them whose edge is nearest.
double distance_to_hull(const Vec2& p, const Disc& a, const Disc& b) {
  const Vec2 axis = b.centre - a.centre;
  const double length = axis.norm();
  const double shrink = a.radius - b.radius;
  if (length <= std::abs(shrink)) {  // one disc holds the other
    const Disc& larger = shrink > 0.0 ? a : b;
    return (p - larger.centre).norm() - larger.radius;
  }
  const Vec2 u = axis / length;
  const Vec2 q = p - a.centre;
  const double along = q.dot(u);
  const double across = std::abs(u.x() * q.y() - u.y() * q.x());
  // The foot lies up the path from the point's own foot because the outline leans towards the smaller disc.
  const double lean = shrink / std::sqrt(length * length - shrink * shrink);
  const double t = std::clamp((along - across * lean) / length, 0.0, 1.0);
  return (p - a.centre - t * axis).norm() - (a.radius - t * shrink);
}

}  // namespace

Paint make_paint(unsigned rgb, float opacity) {
  Paint paint;
  for (int c = 0; c < 3; ++c) paint.color[c] = srgb_to_linear(static_cast<std::uint8_t>(rgb >> (16 - 8 * c)));
  paint.opacity = opacity;
  return paint;
}

void paint_sweep(Canvas& canvas, std::span<const Disc> path, const Paint& paint) {
  if (path.empty()) return;
  const Region all = clip(canvas, box_around(path));
  if (all.is_empty()) return;
  const int width = all.right - all.left;
  std::vector<float> mask(static_cast<std::size_t>(width) * static_cast<std::size_t>(all.bottom - all.top), 0.0F);
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Disc& a = path[i];
    const Disc& b = path[std::min(i + 1, path.size() - 1)];
    const Region region = clip(canvas, box_around(path.subspan(i, i + 1 < path.size() ? 2 : 1)));
    for (int y = region.top; y < region.bottom; ++y) {
      for (int x = region.left; x < region.right; ++x) {
        float& covered = mask[static_cast<std::size_t>((y - all.top) * width + x - all.left)];
        if (covered < 1.0F) covered = std::max(covered, coverage_of(distance_to_hull(Vec2(x + 0.5, y + 0.5), a, b)));
      }
    }
  }
  for (int y = all.top; y < all.bottom; ++y) {
    for (int x = all.left; x < all.right; ++x) {
      const float covered = mask[static_cast<std::size_t>((y - all.top) * width + x - all.left)];
      if (covered > 0.0F) put(canvas.at(x, y), paint, covered);
    }
  }
}

void paint_polygon(Canvas& canvas, std::span<const Vec2> corners, const Paint& fill, const Paint& line, double width) {
  if (corners.size() < 2) return;
  Eigen::AlignedBox2d box;
  for (const Vec2& corner : corners) box.extend(corner);
  box.min().array() -= 0.5 * width;
  box.max().array() += 0.5 * width;
  const Region region = clip(canvas, box);
  for (int y = region.top; y < region.bottom; ++y) {
    for (int x = region.left; x < region.right; ++x) {
      const Vec2 p(x + 0.5, y + 0.5);
      double nearest = std::numeric_limits<double>::max();
      bool inside = false;
      for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
        const Vec2 edge = corners[j] - corners[i];
        const Vec2 offset = p - corners[i];
        const double t = std::clamp(offset.dot(edge) / std::max(edge.squaredNorm(), 1e-12), 0.0, 1.0);
        nearest = std::min(nearest, (offset - t * edge).squaredNorm());
        const bool crosses = (corners[i].y() > p.y()) != (corners[j].y() > p.y());
        if (crosses && offset.x() < edge.x() * offset.y() / edge.y()) inside = !inside;
      }
      const double distance = std::sqrt(nearest);
      const float filled = coverage_of(inside ? -distance : distance);
      const float lined = coverage_of(distance - 0.5 * width);
      Vec4f& pixel = canvas.at(x, y);
      if (filled > 0.0F && fill.opacity > 0.0F) put(pixel, fill, filled);
      if (lined > 0.0F && line.opacity > 0.0F) put(pixel, line, lined);
    }
  }
}

}  // namespace croquis
