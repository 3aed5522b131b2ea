// SPDX-License-Identifier: MIT
#include "croquis/sketch/stroke.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "croquis/base/error.h"
#include "croquis/base/text.h"
#include "croquis/sketch/smoothing.h"

namespace croquis {
namespace {

/// The least horizontal part of a unit direction of view from which an upright plane can be drawn on.
constexpr double kSteepest = 0.02;

std::string stroke_name(const Stroke& stroke) {
  return stroke.name.empty() ? std::string("stroke") : "stroke \"" + printable(stroke.name) + "\"";
}

/// Positions of the samples without those nearer than `least` to the last one kept; both ends stay.
std::vector<Vec2> distinct_positions(const Stroke& stroke, double least) {
  std::vector<Vec2> points;
  points.reserve(stroke.samples.size());
  for (const StrokeSample& sample : stroke.samples) {
    if (points.empty() || (sample.position - points.back()).norm() > least) points.push_back(sample.position);
  }
  const Vec2 last = stroke.samples.back().position;
  if (points.back() != last) {
    if (points.size() > 1) {
      points.back() = last;
    } else {
      points.push_back(last);
    }
  }
  return points;
}

/// How many points to cut off the front: a hook turns back by more than `degrees` within `reach` of the end.
std::size_t hook_end(const std::vector<Vec2>& points, double reach, double degrees) {
  double arc = 0.0;
  std::size_t cut = 0;
  double sharpest = std::cos(degrees * kDegree);
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    arc += (points[i] - points[i - 1]).norm();
    if (arc >= reach) break;
    const Vec2 before = points[i] - points.front();
    std::size_t ahead = i + 1;  // as far ahead as the hook is long, so that its own jitter does not decide
    while (ahead + 1 < points.size() && (points[ahead] - points[i]).norm() < arc) ++ahead;
    const Vec2 after = points[ahead] - points[i];
    const double norms = before.norm() * after.norm();
    if (!(norms > 0.0)) continue;
    if (before.dot(after) / norms < sharpest) {
      sharpest = before.dot(after) / norms;
      cut = i;
    }
  }
  return cut;
}

void remove_hooks(std::vector<Vec2>& points, const CleanStrokeOptions& options) {
  for (int end = 0; end < 2; ++end) {
    const double reach = options.hook_length * Polyline2(points).length();
    const auto cut = static_cast<std::ptrdiff_t>(hook_end(points, reach, options.hook_degrees));
    points.erase(points.begin(), points.begin() + cut);
    std::reverse(points.begin(), points.end());
  }
}

}  // namespace

void check_stroke(const Stroke& stroke, const Camera& camera) {
  const double margin_x = camera.width_px, margin_y = camera.height_px;
  bool distinct = false;
  for (std::size_t i = 0; i < stroke.samples.size(); ++i) {
    const Vec2& p = stroke.samples[i].position;
    const std::string place = stroke_name(stroke) + ": point " + std::to_string(i);
    if (!p.allFinite()) throw_invalid_argument(place + " is not finite");
    if (!std::isfinite(stroke.samples[i].time) || !std::isfinite(stroke.samples[i].pressure)) {
      throw_invalid_argument(place + " has a time or pressure that is not finite");
    }
    if (p.x() < -margin_x || p.x() > camera.width_px + margin_x || p.y() < -margin_y ||
        p.y() > camera.height_px + margin_y) {
      throw_invalid_argument(place + " at (" + format_double(p.x()) + ", " + format_double(p.y()) +
                             ") lies outside the view of " + std::to_string(camera.width_px) + " x " +
                             std::to_string(camera.height_px) + " pixels by more than its size");
    }
    distinct = distinct || (p - stroke.samples.front().position).norm() > 1e-6;
  }
  if (!distinct) throw_invalid_argument(stroke_name(stroke) + ": wanted at least two distinct points");
}

Polyline2 clean_stroke(const Stroke& stroke, const CleanStrokeOptions& options) {
  if (stroke.samples.empty()) throw_invalid_argument(stroke_name(stroke) + ": wanted at least two distinct points");
  if (options.points < 2) {
    throw_invalid_argument("clean_stroke: points is " + std::to_string(options.points) + ", wanted 2 or more");
  }
  const bool smooth = stroke.raw_pen && options.smoothing_px > 0.0;
  std::vector<Vec2> points = distinct_positions(stroke, smooth ? 0.5 * options.smoothing_px : 0.0);
  if (stroke.raw_pen && points.size() > 2) remove_hooks(points, options);
  if (smooth && points.size() > 2) {
    SmoothingOptions smoothing;
    smoothing.most_removed = options.smoothing_px;
    smoothing.corner_reach = 8.0 * options.smoothing_px;
    smoothing.corner_degrees = options.corner_degrees;
    points = smooth_curve(points, smoothing);
  }
  return Polyline2(Polyline2(std::move(points)).resampled(options.points));
}

Vec3 drawing_plane_normal(DrawingPlane plane, const Camera& camera) {
  const Vec3 toward_camera = -camera.forward();
  if (plane == DrawingPlane::free) return toward_camera;
  const Vec3 level(toward_camera.x(), 0.0, toward_camera.z());
  if (level.norm() < kSteepest) {
    throw_invalid_argument("drawing plane: an upright plane cannot be drawn on from straight above or below");
  }
  return level.normalized();
}

std::vector<Vec3> unproject_stroke(const std::vector<Vec2>& pixels, const Camera& camera, DrawingPlane plane,
                                   const Vec3& centre) {
  const Vec3 normal = drawing_plane_normal(plane, camera);
  std::vector<Vec3> points;
  points.reserve(pixels.size());
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const std::optional<Vec3> point = camera.unproject(pixels[i], centre, normal);
    if (!point) {
      throw_invalid_argument("stroke: point " + std::to_string(i) + " does not meet the drawing plane in this view");
    }
    points.push_back(*point);
  }
  return points;
}

}  // namespace croquis
