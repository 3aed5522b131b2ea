// SPDX-License-Identifier: MIT
// Distances are f / |grad f| with f = (length in the shape's own unit) - 1: Taubin's first-order distance (taubin1994).
// Far from a thin shape it may be off by the ratio of its radii, which is why users of it keep a margin.
#include "croquis/body/shapes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace croquis {
namespace {

constexpr double kTiny = 1e-9;
constexpr std::size_t kAtOnce = 16;  ///< pieces of a loft whose distances are worked out in one go

Vec3 orthogonal_part(const Vec3& v, const Vec3& unit) { return (v - v.dot(unit) * unit).normalized(); }

double cubic(const Vec4& c, double s) { return c[0] + s * (c[1] + s * (c[2] + s * c[3])); }
double cubic_slope(const Vec4& c, double s) { return c[1] + s * (2.0 * c[2] + s * 3.0 * c[3]); }

/// Hermite coefficients from values and slopes (per unit of the local parameter).
Vec4 hermite(double a, double b, double slope_a, double slope_b) {
  return {a, slope_a, 3.0 * (b - a) - 2.0 * slope_a - slope_b, 2.0 * (a - b) + slope_a + slope_b};
}

double radius_of(const Section& section, int which) {
  switch (which) {
    case 0:
      return section.side_plus;
    case 1:
      return section.side_minus;
    case 2:
      return section.front_plus;
    default:
      return section.front_minus;
  }
}

}  // namespace

void Ball::include(const Ball& other) {
  if (other.radius < 0.0) return;
  const double apart = (other.center - center).norm();
  if (radius >= apart + other.radius) return;
  if (radius < 0.0 || other.radius >= apart + radius) {
    *this = other;
    return;
  }
  const double wanted = 0.5 * (apart + radius + other.radius);
  center += (wanted - radius) / apart * (other.center - center);
  radius = wanted;
}

Section round_section(const Vec3& center, double radius) { return {center, radius, radius, radius, radius, 0.0}; }

Section oval_section(const Vec3& center, double side, double front, double square) {
  return {center, side, side, front, front, square};
}

Section oval_section(const Vec3& center, double side, double front_plus, double front_minus, double square) {
  return {center, side, side, front_plus, front_minus, square};
}

Loft::Loft(std::vector<Section> sections, const Vec3& side, const Vec3& front, double cap_start, double cap_end)
    : sections_(std::move(sections)), cap_{cap_start, cap_end} {
  const std::size_t count = sections_.size();
  std::vector<Vec3> normals(count), sides(count), fronts(count);
  std::vector<double> lengths(count - 1);
  double handedness = 1.0;
  for (std::size_t i = 0; i + 1 < count; ++i) lengths[i] = (sections_[i + 1].center - sections_[i].center).norm();
  for (std::size_t i = 0; i < count; ++i) {
    Vec3 tangent = Vec3::Zero();
    if (i > 0) tangent += (sections_[i].center - sections_[i - 1].center).normalized();
    if (i + 1 < count) tangent += (sections_[i + 1].center - sections_[i].center).normalized();
    tangent.normalize();
    normals[i] = tangent;
    sides[i] = orthogonal_part(side, tangent);
    fronts[i] = tangent.cross(sides[i]);
    if (i == 0) handedness = fronts[i].dot(front) < 0.0 ? -1.0 : 1.0;
    fronts[i] *= handedness;
  }
  const auto slope = [&](std::size_t i, int which) {  // per metre; flat at the ends, where the caps begin
    if (i == 0 || i + 1 == count) return 0.0;
    const double before = lengths[i - 1], after = lengths[i];
    const double a = (radius_of(sections_[i], which) - radius_of(sections_[i - 1], which)) / before;
    const double b = (radius_of(sections_[i + 1], which) - radius_of(sections_[i], which)) / after;
    const double parabola = (a * after + b * before) / (before + after);
    // Steep neighbours must not throw the outline beyond the sections themselves.
    const double limit = 3.0 * std::min(std::abs(a), std::abs(b));
    return a * b <= 0.0 ? 0.25 * parabola : std::clamp(parabola, -limit, limit);
  };
  for (std::size_t i = 0; i + 1 < count; ++i) {
    Piece piece;
    piece.start = sections_[i].center;
    piece.along = sections_[i + 1].center - sections_[i].center;
    piece.inverse_length2 = 1.0 / piece.along.squaredNorm();
    for (std::size_t end = 0; end < 2; ++end) {
      piece.normal[end] = normals[i + end];
      piece.side[end] = sides[i + end];
      piece.front[end] = fronts[i + end];
      piece.square[end] = sections_[i + end].square;
    }
    for (int which = 0; which < 4; ++which) {
      piece.radius[which] = hermite(radius_of(sections_[i], which), radius_of(sections_[i + 1], which),
                                    lengths[i] * slope(i, which), lengths[i] * slope(i + 1, which));
    }
    pieces_.push_back(piece);
  }
  axes_.resize(std::ssize(pieces_), 7);
  for (Eigen::Index i = 0; i < axes_.rows(); ++i) {
    const Piece& piece = pieces_[static_cast<std::size_t>(i)];
    axes_.row(i) << piece.start.transpose().array(), piece.along.transpose().array(), piece.inverse_length2;
  }
  if (cap_[0] < 0.0) cap_[0] = sections_.front().mean_radius();
  if (cap_[1] < 0.0) cap_[1] = sections_.back().mean_radius();
  for (const Section& s : sections_) {
    const double reach = std::hypot(std::max(s.side_plus, s.side_minus), std::max(s.front_plus, s.front_minus));
    const double widest = std::max({s.side_plus, s.side_minus, s.front_plus, s.front_minus});
    ball_.include({s.center, s.square > 0.0 ? reach : widest});
  }
  ball_.include({sections_.front().center, cap_[0]});
  ball_.include({sections_.back().center, cap_[1]});
}

Loft::Nearest Loft::nearest(const Vec3& point) const {
  std::size_t best = 0;
  double least = std::numeric_limits<double>::max();
  const double px = point.x(), py = point.y(), pz = point.z();
  const std::size_t count = pieces_.size();
  const double* axes = axes_.data();
  double distance2[kAtOnce];
  for (std::size_t begin = 0; begin < count; begin += kAtOnce) {
    const std::size_t some = std::min(kAtOnce, count - begin);
    const double* axis = axes + begin;
    for (std::size_t i = 0; i < some; ++i) {
      const double x = px - axis[i], y = py - axis[count + i], z = pz - axis[2 * count + i];
      const double ax = axis[3 * count + i], ay = axis[4 * count + i], az = axis[5 * count + i];
      const double s = std::min(std::max((x * ax + y * ay + z * az) * axis[6 * count + i], 0.0), 1.0);
      const double ox = x - s * ax, oy = y - s * ay, oz = z - s * az;
      distance2[i] = ox * ox + oy * oy + oz * oz;
    }
    for (std::size_t i = 0; i < some; ++i) {
      if (distance2[i] < least) {
        best = begin + i;
        least = distance2[i];
      }
    }
  }
  // Where the axis bends, two pieces meet in the plane of their section: without this the outline would crease there.
  const auto before = [&](std::size_t i, std::size_t end) {
    const Piece& piece = pieces_[i];
    const Vec3 d = end == 0 ? Vec3(point - piece.start) : Vec3(point - piece.start - piece.along);
    return d.dot(piece.normal[end]);
  };
  if (best + 1 < pieces_.size() && before(best, 1) > 0.0) {
    ++best;
  } else if (best > 0 && before(best, 0) < 0.0) {
    --best;
  }
  const double from_start = before(best, 0), from_end = before(best, 1);
  const double apart = from_start - from_end;
  return {&pieces_[best], apart > kTiny ? std::clamp(from_start / apart, 0.0, 1.0) : from_start < 0.0 ? 0.0 : 1.0};
}

ShapeSample Loft::sample(const Vec3& point) const {
  const Nearest at = nearest(point);
  const Piece& piece = *at.piece;
  const double s = at.s;
  const Vec3 side = (1.0 - s) * piece.side[0] + s * piece.side[1];
  const Vec3 front = (1.0 - s) * piece.front[0] + s * piece.front[1];
  const Vec3 tangent = piece.along * std::sqrt(piece.inverse_length2);
  const Vec3 offset = point - piece.start - s * piece.along;
  const bool first = at.piece == &pieces_.front() && s <= 0.0, last = at.piece == &pieces_.back() && s >= 1.0;
  const double u = offset.dot(side), v = offset.dot(front), w = first || last ? offset.dot(tangent) : 0.0;
  const Vec4& side_radius = piece.radius[u < 0.0 ? 1 : 0];
  const Vec4& front_radius = piece.radius[v < 0.0 ? 3 : 2];
  const double a = std::max(cubic(side_radius, s), 1e-4), b = std::max(cubic(front_radius, s), 1e-4);
  const double c = first ? cap_[0] : last ? cap_[1] : 0.5 * (a + b);
  const double x = u / a, y = v / b, z = w / std::max(c, 1e-4);
  const double xx = x * x, yy = y * y, zz = z * z;
  const double round = std::sqrt(xx + yy + zz);
  if (round < kTiny) return {-std::min(a, b), front};
  const double square = (1.0 - s) * piece.square[0] + s * piece.square[1];
  const double box = square > 0.0 ? std::sqrt(std::sqrt(xx * xx + yy * yy + zz * zz)) : round;
  const double length = (1.0 - square) * round + square * box;
  // Gradient of that length by x, y, z, then by space; the outline's own slope tilts it along the axis.
  const double rounded = (1.0 - square) / round, boxed = square > 0.0 ? square / (box * box * box) : 0.0;
  const double gx = rounded * x + boxed * x * xx, gy = rounded * y + boxed * y * yy, gz = rounded * z + boxed * z * zz;
  double along = gz / std::max(c, 1e-4);
  if (!first && !last) {
    const double per_metre = std::sqrt(piece.inverse_length2);
    along -= per_metre * (gx * x * cubic_slope(side_radius, s) / a + gy * y * cubic_slope(front_radius, s) / b);
  }
  const Vec3 gradient = (gx / a) * side + (gy / b) * front + along * tangent;
  const double steepness = gradient.norm();
  if (steepness < kTiny) return {-std::min(a, b), front};
  // Deep inside a flat shape the estimate is far too large: no point is deeper than the least radius.
  return {std::max((length - 1.0) / steepness, -std::min({a, b, c})), gradient / steepness};
}

Box Loft::box() const {
  Box box;
  for (std::size_t i = 0; i < sections_.size(); ++i) {
    const Section& s = sections_[i];
    double reach = std::max({s.side_plus, s.side_minus, s.front_plus, s.front_minus});
    if (i == 0) reach = std::max(reach, cap_[0]);
    if (i + 1 == sections_.size()) reach = std::max(reach, cap_[1]);
    box.extend(Vec3(s.center - Vec3::Constant(reach)));
    box.extend(Vec3(s.center + Vec3::Constant(reach)));
  }
  return box;
}

double Loft::least_radius() const {
  double least = std::numeric_limits<double>::max();
  for (const Section& s : sections_) {
    least = std::min({least, 0.5 * (s.side_plus + s.side_minus), 0.5 * (s.front_plus + s.front_minus)});
  }
  return least;
}

double Loft::radius_near(const Vec3& point) const {
  const Nearest at = nearest(point);
  double sum = 0.0;
  for (const Vec4& radius : at.piece->radius) sum += cubic(radius, at.s);
  return 0.25 * sum;
}

Ellipsoid::Ellipsoid(const Vec3& center, const Vec3& radii, const Mat3& axes)
    : center_(center), radii_(radii), axes_(axes), ball_{center, radii.maxCoeff()} {}

ShapeSample Ellipsoid::sample(const Vec3& point) const {
  const Vec3 local = axes_.transpose() * (point - center_);
  const Vec3 scaled = local.cwiseQuotient(radii_);
  const double length = scaled.norm();
  if (length < kTiny) return {-radii_.minCoeff(), axes_.col(1)};
  const Vec3 gradient = scaled.cwiseQuotient(radii_) / length;
  const double steepness = gradient.norm();
  return {std::max((length - 1.0) / steepness, -radii_.minCoeff()), axes_ * (gradient / steepness)};
}

Box Ellipsoid::box() const {
  Vec3 reach = Vec3::Zero();
  for (int axis = 0; axis < 3; ++axis) reach += (radii_[axis] * axes_.col(axis)).cwiseAbs();
  return {Vec3(center_ - reach), Vec3(center_ + reach)};
}

}  // namespace croquis
