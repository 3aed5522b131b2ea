// SPDX-License-Identifier: MIT
#include "croquis/math/polyline.h"

#include <algorithm>
#include <limits>
#include <string>

#include "croquis/base/error.h"

namespace croquis {

template <class Point>
Polyline<Point>::Polyline(std::vector<Point> points) : points_(std::move(points)) {
  if (points_.empty()) throw_invalid_argument("Polyline: got no point, wanted at least one");
  arc_.reserve(points_.size());
  arc_.push_back(0.0);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (!points_[i].allFinite()) throw_invalid_argument("Polyline: point " + std::to_string(i) + " is not finite");
    if (i > 0) arc_.push_back(arc_.back() + (points_[i] - points_[i - 1]).norm());
  }
}

template <class Point>
int Polyline<Point>::segment_at(double s) const {
  const auto after = std::upper_bound(arc_.begin() + 1, arc_.end() - 1, s);
  return static_cast<int>(after - arc_.begin()) - 1;
}

template <class Point>
Point Polyline<Point>::at(double s) const {
  if (points_.size() == 1 || s <= 0.0) return points_.front();
  if (s >= length()) return points_.back();
  const auto i = static_cast<std::size_t>(segment_at(s));
  const double span = arc_[i + 1] - arc_[i];
  const double t = span > 0.0 ? (s - arc_[i]) / span : 0.0;
  return points_[i] + t * (points_[i + 1] - points_[i]);
}

template <class Point>
Point Polyline<Point>::tangent(double s) const {
  if (!(length() > 0.0)) return Point::Zero();
  s = std::clamp(s, 0.0, length());
  auto i = static_cast<std::size_t>(segment_at(s));
  // Step over repeated points, forward first.
  std::size_t j = i;
  while (j + 2 < points_.size() && !(arc_[j + 1] > arc_[j])) ++j;
  while (j > 0 && !(arc_[j + 1] > arc_[j])) --j;
  return (points_[j + 1] - points_[j]).normalized();
}

template <class Point>
double Polyline<Point>::nearest(const Point& point) const {
  double best = std::numeric_limits<double>::infinity();
  double best_s = 0.0;
  for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
    const Point edge = points_[i + 1] - points_[i];
    const double span = edge.squaredNorm();
    const double t = span > 0.0 ? std::clamp((point - points_[i]).dot(edge) / span, 0.0, 1.0) : 0.0;
    const double distance = (points_[i] + t * edge - point).squaredNorm();
    if (distance < best) {
      best = distance;
      best_s = arc_[i] + t * (arc_[i + 1] - arc_[i]);
    }
  }
  return best_s;
}

template <class Point>
std::vector<Point> Polyline<Point>::resampled(int count) const {
  if (count < 2)
    throw_invalid_argument("Polyline::resampled: count is " + std::to_string(count) + ", wanted 2 or more");
  std::vector<Point> result;
  result.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) result.push_back(at(length() * i / (count - 1)));
  return result;
}

template class Polyline<Vec2>;
template class Polyline<Vec3>;

}  // namespace croquis
