// SPDX-License-Identifier: MIT
// C. H. Reinsch, Smoothing by Spline Functions (1967); E. T. Whittaker, On a New Method of Graduation (1923). How much
// to smooth is Reinsch's own rule: as much as the noise is. Estimating the noise from fourth differences keeps a sparse
// but smooth stroke, whose lower differences are large for honest reasons, from being flattened.
#include "croquis/sketch/smoothing.h"

#include <algorithm>
#include <cmath>

#include "croquis/math/polyline.h"

namespace croquis {
namespace {

/// Solves (I + lambda D'D) p = y for the inner points, D the second difference, both ends held: a symmetric banded
/// system (two sub-diagonals), LDL' in one sweep.
void whittaker(const std::vector<Vec2>& y, std::size_t first, std::size_t last, double lambda, std::vector<Vec2>& p) {
  const std::size_t n = last - first - 1;  // unknowns first+1 .. last-1
  p[first] = y[first];
  p[last] = y[last];
  if (last - first < 2) return;
  std::vector<double> d(n), l1(n, 0.0), l2(n, 0.0);
  std::vector<Vec2> z(n);
  for (std::size_t i = 0; i < n; ++i) {
    // Rows of D are centred on points first+1 .. last-1; unknown i is in the rows centred on itself and its neighbours.
    const bool edge = i == 0 || i + 1 == n;
    double a = 1.0 + lambda * (n == 1 ? 4.0 : (edge ? 5.0 : 6.0));
    double b = i >= 1 ? -4.0 * lambda : 0.0;
    const double c = i >= 2 ? lambda : 0.0;
    Vec2 rhs = y[first + 1 + i];
    if (i == 0) rhs += 2.0 * lambda * y[first];
    if (i == 1) rhs -= lambda * y[first];
    if (i + 1 == n) rhs += 2.0 * lambda * y[last];
    if (i + 2 == n) rhs -= lambda * y[last];
    if (i >= 2) {
      l2[i] = c / d[i - 2];
      b -= l2[i] * d[i - 2] * l1[i - 1];
      a -= l2[i] * l2[i] * d[i - 2];
      rhs -= l2[i] * z[i - 2];
    }
    if (i >= 1) {
      l1[i] = b / d[i - 1];
      a -= l1[i] * l1[i] * d[i - 1];
      rhs -= l1[i] * z[i - 1];
    }
    d[i] = a;
    z[i] = rhs;
  }
  for (std::size_t i = n; i-- > 0;) {
    Vec2 value = z[i] / d[i];
    if (i + 1 < n) value -= l1[i + 1] * p[first + 2 + i];
    if (i + 2 < n) value -= l2[i + 2] * p[first + 3 + i];
    p[first + 1 + i] = value;
  }
}

/// The direction of the points from a to b (either order) by a straight-line fit over their index.
Vec2 fitted_direction(const std::vector<Vec2>& points, std::size_t a, std::size_t b) {
  const double middle = 0.5 * static_cast<double>(b - a);
  Vec2 slope = Vec2::Zero();
  for (std::size_t i = a; i <= b; ++i) slope += (static_cast<double>(i - a) - middle) * points[i];
  const double norm = slope.norm();
  return norm > 0.0 ? Vec2(slope / norm) : Vec2::Zero();
}

/// Indices of corners, ends included.
std::vector<std::size_t> find_corners(const std::vector<Vec2>& points, double step, const SmoothingOptions& options) {
  const auto window = std::max<std::size_t>(2, static_cast<std::size_t>(std::lround(options.corner_reach / step)));
  const std::size_t last = points.size() - 1;
  std::vector<std::size_t> corners{0};
  std::vector<double> turn(points.size(), 0.0);
  for (std::size_t i = window; i + window <= last; ++i) {
    const Vec2 before = fitted_direction(points, i - window, i), after = fitted_direction(points, i, i + window);
    turn[i] = std::acos(std::clamp(before.dot(after), -1.0, 1.0));
  }
  for (std::size_t i = window; i + window <= last; ++i) {
    if (turn[i] <= options.corner_degrees * kDegree) continue;
    const auto from = turn.begin() + static_cast<std::ptrdiff_t>(i - window);
    const auto to = turn.begin() + static_cast<std::ptrdiff_t>(i + window + 1);
    const bool sharpest = std::max_element(from, to) == turn.begin() + static_cast<std::ptrdiff_t>(i);
    if (sharpest) corners.push_back(i);
  }
  corners.push_back(last);
  return corners;
}

}  // namespace

double estimate_jitter(const std::vector<Vec2>& points) {
  if (points.size() < 7) return 0.0;
  std::vector<double> differences;
  for (std::size_t i = 2; i + 2 < points.size(); ++i) {
    const Vec2 along = points[i + 2] - points[i - 2];
    if (!(along.norm() > 0.0)) continue;
    const Vec2 fourth = points[i - 2] - 4.0 * points[i - 1] + 6.0 * points[i] - 4.0 * points[i + 1] + points[i + 2];
    differences.push_back(std::abs(along.x() * fourth.y() - along.y() * fourth.x()) / along.norm());
  }
  if (differences.empty()) return 0.0;
  const auto middle = differences.begin() + std::ssize(differences) / 2;
  std::nth_element(differences.begin(), middle, differences.end());
  return *middle / (0.6745 * std::sqrt(70.0));  // median of a normal's size; 70 = 1 + 16 + 36 + 16 + 1
}

std::vector<Vec2> smooth_curve(const std::vector<Vec2>& points, const SmoothingOptions& options) {
  const double most = std::min(options.most_removed, estimate_jitter(points));
  if (!(most > 0.0) || points.size() < 5) return points;
  const Polyline2 line(points);
  const int count = std::clamp(static_cast<int>(points.size()), 64, 4096);
  const std::vector<Vec2> y = line.resampled(count);
  const std::vector<std::size_t> corners = find_corners(y, line.length() / (count - 1), options);

  std::vector<Vec2> best = y, trial = y;
  double low = -4.0, high = 14.0;  // log10 of lambda
  for (int round = 0; round < 24; ++round) {
    const double middle = 0.5 * (low + high);
    for (std::size_t k = 0; k + 1 < corners.size(); ++k) {
      whittaker(y, corners[k], corners[k + 1], std::pow(10.0, middle), trial);
    }
    double moved = 0.0;
    for (std::size_t i = 0; i < y.size(); ++i) moved += (trial[i] - y[i]).squaredNorm();
    if (std::sqrt(moved / static_cast<double>(y.size())) <= most) {
      best = trial;
      low = middle;
    } else {
      high = middle;
    }
  }
  return best;
}

}  // namespace croquis
