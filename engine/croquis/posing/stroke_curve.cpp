// SPDX-License-Identifier: MIT
#include "croquis/posing/stroke_curve.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "croquis/base/error.h"

namespace croquis {
namespace {

// Between samples nearer than this part of a stroke's length it is the smooth curve through them that was drawn:
// straight pieces would cut corners, and how many would depend on how often the pen was asked. Farther apart they are
// meant.
constexpr double kDense = 1.0 / 24.0;

/// The cubic from a to b with directions `in` and `out`, `span` apart in arc length, at t in [0, 1].
Vec2 hermite(const Vec2& a, const Vec2& in, const Vec2& b, const Vec2& out, double span, double t) {
  const double t2 = t * t, t3 = t2 * t;
  return (2 * t3 - 3 * t2 + 1) * a + (t3 - 2 * t2 + t) * span * in + (3 * t2 - 2 * t3) * b + (t3 - t2) * span * out;
}

/// The direction of a curve at b, between a and c.
Vec2 direction_at(const Vec2& a, const Vec2& b, const Vec2& c) {
  const double before = (b - a).norm(), after = (c - b).norm();
  if (!(before > 0.0 && after > 0.0)) return (c - a) / std::max(before + after, 1e-300);
  return ((b - a) * (after / before) + (c - b) * (before / after)) / (before + after);
}

}  // namespace

StrokeCurve::StrokeCurve() {
  knots_.resize(kKnots, Vec2::Zero());
  slopes_.resize(kKnots, Vec2::Zero());
  sums_.resize(kKnots + 1);
}

void StrokeCurve::assign(std::span<const Vec2> points, const Vec2& scale, const Vec2& offset, bool reversed) {
  const auto at_index = [&](std::size_t i) {
    return Vec2(scale.cwiseProduct(points[reversed ? points.size() - 1 - i : i]) + offset);
  };
  length_ = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) length_ += (at_index(i) - at_index(i - 1)).norm();
  if (!(length_ > 0.0) || !std::isfinite(length_)) throw_invalid_argument("line solver: the stroke has no length");
  step_ = length_ / (kKnots - 1);
  std::size_t segment = 1;
  double before = 0.0, span = (at_index(1) - at_index(0)).norm();
  for (int k = 0; k < kKnots; ++k) {
    const double s = step_ * k;
    while (segment + 1 < points.size() && before + span < s) {
      before += span;
      ++segment;
      span = (at_index(segment) - at_index(segment - 1)).norm();
    }
    if (!(span > 0.0)) {
      knots_[static_cast<std::size_t>(k)] = at_index(segment);
      continue;
    }
    const double t = std::clamp((s - before) / span, 0.0, 1.0);
    const Vec2 a = at_index(segment - 1), b = at_index(segment);
    const bool dense = span < kDense * length_;
    const Vec2 in = dense && segment > 1 ? direction_at(at_index(segment - 2), a, b) : Vec2((b - a) / span);
    const Vec2 out =
        dense && segment + 1 < points.size() ? direction_at(a, b, at_index(segment + 1)) : Vec2((b - a) / span);
    knots_[static_cast<std::size_t>(k)] = hermite(a, in, b, out, span, t);
  }
  finish();
}

void StrokeCurve::finish() {
  const auto last = static_cast<std::size_t>(kKnots - 1);
  for (std::size_t k = 1; k < last; ++k) slopes_[k] = (knots_[k + 1] - knots_[k - 1]) / (2.0 * step_);
  slopes_[0] = 2.0 * (knots_[1] - knots_[0]) / step_ - slopes_[1];
  slopes_[last] = 2.0 * (knots_[last] - knots_[last - 1]) / step_ - slopes_[last - 1];
  for (const std::size_t end : {std::size_t{0}, last}) {
    const double norm = slopes_[end].norm();
    slopes_[end] = norm > 1e-9 ? Vec2(slopes_[end] / norm) : Vec2(Vec2::UnitX());
  }
  for (std::size_t k = 0; k <= last; ++k) {
    const Vec2& p = knots_[k];
    const Moments& m = sums_[k];
    sums_[k + 1] = {m.x + p.x(), m.y + p.y(), m.xx + p.x() * p.x(), m.xy + p.x() * p.y(), m.yy + p.y() * p.y()};
  }
}

Vec2 StrokeCurve::at(double s) const {
  if (s <= 0.0) return knots_.front() + s * slopes_.front();
  if (s >= length_) return knots_.back() + (s - length_) * slopes_.back();
  const double u = s / step_;
  const auto k = std::min(static_cast<std::size_t>(u), static_cast<std::size_t>(kKnots - 2));
  return hermite(knots_[k], slopes_[k], knots_[k + 1], slopes_[k + 1], step_, u - static_cast<double>(k));
}

Vec2 StrokeCurve::derivative(double s) const {
  if (s <= 0.0) return slopes_.front();
  if (s >= length_) return slopes_.back();
  const double u = s / step_;
  const auto k = std::min(static_cast<std::size_t>(u), static_cast<std::size_t>(kKnots - 2));
  const double t = u - static_cast<double>(k), t2 = t * t;
  return ((6 * t2 - 6 * t) * knots_[k] + (6 * t - 6 * t2) * knots_[k + 1]) / step_ + (3 * t2 - 4 * t + 1) * slopes_[k] +
         (3 * t2 - 2 * t) * slopes_[k + 1];
}

double StrokeCurve::unevenness(double a, double b) const {
  const auto first = static_cast<std::size_t>(std::clamp(std::ceil(a / step_), 0.0, kKnots - 1.0));
  const auto last = static_cast<std::size_t>(std::clamp(std::floor(b / step_), 0.0, kKnots - 1.0));
  if (last < first + 1) return 0.0;
  const Vec2 from = at(a), chord = at(b) - from;
  const double span = chord.squaredNorm();
  const double n = static_cast<double>(last - first + 1);
  const Moments& hi = sums_[last + 1];
  const Moments& lo = sums_[first];
  const double x = (hi.x - lo.x) / n - from.x(), y = (hi.y - lo.y) / n - from.y();
  const double mx = (hi.x - lo.x) / n, my = (hi.y - lo.y) / n;
  const double xx = (hi.xx - lo.xx) / n - mx * mx + x * x, yy = (hi.yy - lo.yy) / n - my * my + y * y;
  const double xy = (hi.xy - lo.xy) / n - mx * my + x * y;
  if (!(span > 1e-18)) return xx + yy;
  const double nx = -chord.y(), ny = chord.x();
  return std::max(0.0, (nx * nx * xx + 2.0 * nx * ny * xy + ny * ny * yy) / span);
}

double StrokeCurve::nearest(const Vec2& point) const {
  double best = std::numeric_limits<double>::infinity();
  std::size_t at_knot = 0;
  for (std::size_t k = 0; k < knots_.size(); ++k) {
    const double distance = (knots_[k] - point).squaredNorm();
    if (distance < best) {
      best = distance;
      at_knot = k;
    }
  }
  return step_ * static_cast<double>(at_knot);
}

void StrokeCurve::scale_about(const Vec2& centre, double factor) {
  for (Vec2& knot : knots_) knot = centre + factor * (knot - centre);
  length_ *= factor;
  step_ *= factor;
  finish();
}

void StrokeCurve::shift(const Vec2& offset) {
  for (Vec2& knot : knots_) knot += offset;
  finish();
}

}  // namespace croquis
