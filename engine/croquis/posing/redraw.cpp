// SPDX-License-Identifier: MIT
#include "croquis/posing/redraw.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "croquis/math/rotation.h"
#include "croquis/posing/extract_line.h"

namespace croquis {
namespace {

/// Root mean square distance of a stroke from the path's own line, points at equal parts of the lengths. Inside the
/// line they may slide along it a little: one cut corner shifts all that comes after it.
double distance_from_own(const LineProblem& problem, const LinePath& path) {
  constexpr int kPoints = 129;
  constexpr double kSlide = 0.005;
  std::vector<Vec2> joints;
  for (const int node : path.nodes)
    joints.push_back(problem.project(problem.nodes[static_cast<std::size_t>(node)].start));
  const Polyline2 pieces(joints);
  if (!(pieces.length() > 1e-6)) return 1.0;
  const Polyline2 curve = curve_through(joints, 257);
  double nearest = 1.0;
  for (const Polyline2* own : {&pieces, &curve}) {
    double sum = 0.0;
    for (int i = 0; i < kPoints; ++i) {
      const double part = static_cast<double>(i) / (kPoints - 1), step = 1.0 / (kPoints - 1);
      Vec2 off = path.curve.at(part * path.curve.length()) - own->at(part * own->length());
      if (i > 0 && i + 1 < kPoints) {
        const Vec2 along = own->at((part + step) * own->length()) - own->at((part - step) * own->length());
        const double norm = along.norm();
        if (norm > 0.0) off -= std::clamp(off.dot(along) / norm, -kSlide, kSlide) * along / norm;
      }
      sum += off.squaredNorm();
    }
    nearest = std::min(nearest, std::sqrt(sum / kPoints));
  }
  return nearest;
}

}  // namespace

double redraw_share(const LineProblem& problem) {
  constexpr double kSame = 0.0015, kOther = 0.006;
  double farthest = 0.0;
  for (const LinePath& path : problem.paths) farthest = std::max(farthest, distance_from_own(problem, path));
  const double t = std::clamp((farthest - kSame) / (kOther - kSame), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

void take_share(const LineProblem& problem, double share, LineState& state) {
  if (share >= 1.0) return;
  state.shift *= share;
  for (Quat& turn : state.turn) turn = rotation_from_vector(share * rotation_to_vector(turn));
  problem.update(state);
}

}  // namespace croquis
