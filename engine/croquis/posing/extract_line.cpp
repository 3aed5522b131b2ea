// SPDX-License-Identifier: MIT
// C. Yuksel, S. Schaefer, J. Keyser, Parameterization and applications of Catmull-Rom curves (2011).
#include "croquis/posing/extract_line.h"

#include <algorithm>
#include <cmath>

#include "croquis/base/error.h"
#include "croquis/base/text.h"

namespace croquis {
namespace {

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// The angle from a to b, counter-clockwise as seen in a picture whose y grows downward.
double turn_between(const Vec2& a, const Vec2& b) { return std::atan2(-cross(a, b), a.dot(b)); }

/// Direction angles of the pieces between equally spaced points, continuous along the line.
std::vector<double> direction_angles(const std::vector<Vec2>& points) {
  std::vector<double> angles;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Vec2 step = points[i] - points[i - 1];
    if (i == 1) {
      angles.push_back(std::atan2(-step.y(), step.x()));
    } else {
      angles.push_back(angles.back() + turn_between(points[i - 1] - points[i - 2], step));
    }
  }
  return angles;
}

}  // namespace

std::string_view to_string(LineShape shape) {
  switch (shape) {
    case LineShape::straight:
      return "straight";
    case LineShape::c:
      return "C";
    case LineShape::s:
      return "S";
    case LineShape::compound:
      return "compound";
  }
  return "";
}

LineCharacter classify_line(const Polyline2& line, double least_degrees) {
  LineCharacter character;
  if (!(line.length() > 0.0)) return character;
  const std::vector<Vec2> points = line.resampled(65);
  const Vec2 chord = points.back() - points.front();
  for (const Vec2& p : points) {
    const double away =
        chord.norm() > 0.0 ? std::abs(cross(chord, p - points.front())) / chord.norm() : (p - points.front()).norm();
    character.strength = std::max(character.strength, away / line.length());
  }
  const std::vector<double> angles = direction_angles(points);
  // The turning between extremes of the direction; an extreme counts once the direction has come back by enough.
  double extreme = angles.front(), from = angles.front();
  int way = 0;
  for (const double angle : angles) {
    if (way == 0) {
      if (std::abs(angle - from) > least_degrees * kDegree) {
        way = angle > from ? 1 : -1;
        extreme = angle;
      }
    } else if (way * (angle - extreme) > 0.0) {
      extreme = angle;
    } else if (way * (extreme - angle) > least_degrees * kDegree) {
      character.bends_degrees.push_back((extreme - from) / kDegree);
      from = extreme;
      extreme = angle;
      way = -way;
    }
  }
  if (way != 0) character.bends_degrees.push_back((extreme - from) / kDegree);
  for (const double bend : character.bends_degrees) character.turn_degrees += std::abs(bend);
  const std::size_t bends = character.bends_degrees.size();
  character.shape = bends == 0   ? LineShape::straight
                    : bends == 1 ? LineShape::c
                    : bends == 2 ? LineShape::s
                                 : LineShape::compound;
  return character;
}

Polyline2 curve_through(const std::vector<Vec2>& points, int count) {
  std::vector<Vec2> p;
  for (const Vec2& point : points) {
    if (p.empty() || (point - p.back()).norm() > 1e-9) p.push_back(point);
  }
  if (p.size() < 2) throw_invalid_argument("curve_through: wanted at least two distinct points");
  // One more point beyond each end, so that end pieces bend like their neighbours.
  const std::size_t n = p.size();
  const Vec2 before = 2.0 * p[0] - p[1], after = 2.0 * p[n - 1] - p[n - 2];
  const auto at = [&](std::ptrdiff_t i) {
    return i < 0 ? before : (i >= static_cast<std::ptrdiff_t>(n) ? after : p[static_cast<std::size_t>(i)]);
  };
  constexpr int kSteps = 48;
  std::vector<Vec2> fine{p[0]};
  for (std::ptrdiff_t i = 0; i + 1 < static_cast<std::ptrdiff_t>(n); ++i) {
    const Vec2 q[4] = {at(i - 1), at(i), at(i + 1), at(i + 2)};
    double t[4] = {0.0, 0.0, 0.0, 0.0};
    for (int k = 1; k < 4; ++k) t[k] = t[k - 1] + std::sqrt((q[k] - q[k - 1]).norm());
    for (int step = 1; step <= kSteps; ++step) {
      const double u = t[1] + (t[2] - t[1]) * step / kSteps;
      const auto mix = [u](const Vec2& a, const Vec2& b, double ta, double tb) {
        return Vec2(((tb - u) * a + (u - ta) * b) / (tb - ta));
      };
      const Vec2 a1 = mix(q[0], q[1], t[0], t[1]), a2 = mix(q[1], q[2], t[1], t[2]), a3 = mix(q[2], q[3], t[2], t[3]);
      const Vec2 b1 = mix(a1, a2, t[0], t[2]), b2 = mix(a2, a3, t[1], t[3]);
      fine.push_back(mix(b1, b2, t[1], t[2]));
    }
  }
  return Polyline2(Polyline2(std::move(fine)).resampled(count));
}

Polyline2 extract_line(const Skeleton& skeleton, const Pose& pose, const BodyLine& line, const Camera& camera,
                       int count) {
  const std::vector<Vec3> positions = compute_positions(skeleton, pose);
  std::vector<Vec2> pixels;
  for (const int joint : line.joints) {
    const std::optional<Vec2> pixel = camera.project(positions.at(static_cast<std::size_t>(joint)));
    if (!pixel) {
      throw_invalid_argument("extract_line: joint " + printable(skeleton.reference(joint)) + " is behind the camera");
    }
    pixels.push_back(*pixel);
  }
  return curve_through(pixels, count);
}

Polyline2 exaggerate_line(const Polyline2& line, double factor) {
  if (!(factor >= 0.0 && factor <= 2.0)) {
    throw_invalid_argument("exaggerate_line: factor is " + format_double(factor) + ", wanted 0 to 2");
  }
  if (!(line.length() > 0.0)) throw_invalid_argument("exaggerate_line: the line has no length");
  const int count = std::max(64, static_cast<int>(line.points().size()));
  const std::vector<Vec2> points = line.resampled(count);
  const std::vector<double> angles = direction_angles(points);
  double mean = 0.0;
  Vec2 middle = Vec2::Zero(), new_middle = Vec2::Zero();
  for (const double angle : angles) mean += angle / static_cast<double>(angles.size());
  std::vector<Vec2> bent{Vec2::Zero()};
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const double angle = mean + factor * (angles[i] - mean), step = (points[i + 1] - points[i]).norm();
    bent.push_back(bent.back() + step * Vec2(std::cos(angle), -std::sin(angle)));
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    middle += points[i] / static_cast<double>(count);
    new_middle += bent[i] / static_cast<double>(count);
  }
  for (Vec2& p : bent) p += middle - new_middle;
  return Polyline2(std::move(bent));
}

}  // namespace croquis
