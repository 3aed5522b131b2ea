// SPDX-License-Identifier: MIT
#include "croquis/posing/line_ranking.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "croquis/base/error.h"
#include "croquis/posing/joint_roles.h"
#include "croquis/posing/pose_edit.h"

namespace croquis {
namespace {

constexpr int kPoints = 33;

/// A line as it stands in the start pose's picture.
struct Seen {
  std::vector<Vec2> points;  ///< at equal parts of its length
  double length = 0.0;       ///< of its picture, pixels
  double reach = 0.0;        ///< pixels that its bones would cover lying flat
};

std::optional<Seen> see(const std::vector<Vec3>& positions, const BodyLine& line, const Camera& camera) {
  Seen seen;
  std::vector<Vec2> joints;
  for (std::size_t k = 0; k < line.joints.size(); ++k) {
    const Vec3& x = positions[static_cast<std::size_t>(line.joints[k])];
    const std::optional<Vec2> pixel = camera.project(x);
    if (!pixel) return std::nullopt;
    joints.push_back(*pixel);
    if (k == 0) continue;
    const Vec3& before = positions[static_cast<std::size_t>(line.joints[k - 1])];
    seen.reach += (x - before).norm() / camera.units_per_pixel(0.5 * (x + before));
  }
  const Polyline2 own(std::move(joints));
  if (!(seen.reach > 0.0)) return std::nullopt;
  seen.points = own.resampled(kPoints);
  seen.length = own.length();
  return seen;
}

/// How a stroke differs from a line of the start pose. The weights below were fitted (logistic regression) to poses of
/// people: what matters is that the hips stay where they are, and that a line is about as long in the picture as it
/// was.
struct Unlikeness {
  double distance = 0.0;            ///< mean, per body size
  double too_long = 0.0;            ///< longer than the bones reach: log of the ratio
  double longer = 0.0, less = 0.0;  ///< than the line was: log of the ratio
};

Unlikeness compare(const Seen& seen, const std::vector<Vec2>& stroke, double length, bool forward, double body_px) {
  Unlikeness u;
  const auto drawn = [&](int i) { return stroke[static_cast<std::size_t>(forward ? i : kPoints - 1 - i)]; };
  for (int i = 0; i < kPoints; ++i) {
    u.distance += (seen.points[static_cast<std::size_t>(i)] - drawn(i)).norm() / (kPoints * body_px);
  }
  const double ratio = std::log(length / std::max(seen.length, 1e-3 * length));
  u.too_long = std::max(0.0, std::log(length / seen.reach));
  u.longer = std::max(0.0, ratio);
  u.less = std::max(0.0, -ratio);
  return u;
}

double screen(const Unlikeness& u) { return 17.0 * u.distance + 14.8 * u.too_long + 7.6 * u.longer + 5.2 * u.less; }

/// The same with the pose that comes of it.
double rank(const Unlikeness& u, const LineSolverResult& result, double fit, double root_moved, double root_turned) {
  return 7.6 * u.distance + 11.8 * u.too_long + 4.6 * u.longer + 6.9 * u.less + 5.7 * std::sqrt(result.turned) +
         12.9 * fit + 18.1 * root_moved + 2.0 * root_turned;
}

}  // namespace

std::vector<LineCandidate> rank_body_lines(const Skeleton& skeleton, const HumanoidMap& humanoid, const Pose& start,
                                           const std::vector<BodyLine>& lines, const Polyline2& stroke,
                                           const Camera& camera, const LineRankingOptions& options) {
  if (lines.empty()) throw_invalid_argument("rank_body_lines: got no line, wanted at least one");
  if (!(stroke.length() > 0.0)) throw_invalid_argument("rank_body_lines: the stroke has no length");
  const std::vector<Vec3> positions = compute_positions(skeleton, start);
  const std::vector<Vec2> drawn = stroke.resampled(kPoints);

  struct Entry {
    std::size_t line;
    bool forward;
    Unlikeness unlike;
    double cost;
  };
  std::vector<std::optional<Seen>> pictures;
  double body_px = 0.0;  // leg and trunk of a person: two thirds of the way from foot to hand
  for (const BodyLine& line : lines) {
    pictures.push_back(see(positions, line, camera));
    if (pictures.back()) body_px = std::max(body_px, pictures.back()->reach / 1.5);
  }
  const auto root = static_cast<std::size_t>(find_body_root(skeleton, humanoid));
  const double body = body_px * camera.units_per_pixel(positions[root]);
  const Quat root_before = compute_model_rotations(skeleton, start)[root];
  std::vector<Entry> entries;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (!pictures[i]) continue;
    // The way round that is nearer to the start pose; the other would turn the body over.
    const Unlikeness ahead = compare(*pictures[i], drawn, stroke.length(), true, body_px),
                     back = compare(*pictures[i], drawn, stroke.length(), false, body_px);
    const bool forward = screen(ahead) <= screen(back);
    entries.push_back({i, forward, forward ? ahead : back, screen(forward ? ahead : back)});
  }
  const auto cheaper = [](const auto& a, const auto& b) { return a.cost < b.cost; };
  std::stable_sort(entries.begin(), entries.end(), cheaper);
  if (std::ssize(entries) > options.solved) entries.resize(static_cast<std::size_t>(std::max(1, options.solved)));

  std::vector<LineCandidate> candidates;
  for (const Entry& entry : entries) {
    LineInput input{lines[entry.line], stroke};
    input.direction = entry.forward ? LineInput::Direction::forward : LineInput::Direction::backward;
    LineCandidate candidate{lines[entry.line], entry.forward, 0.0, {}};
    candidate.result = solve_lines(skeleton, humanoid, start, {input}, camera, options.solver);
    const std::vector<Vec3> posed = compute_positions(skeleton, candidate.result.pose);
    const Quat root_after = compute_model_rotations(skeleton, candidate.result.pose)[root];
    candidate.cost = rank(entry.unlike, candidate.result, candidate.result.fits.front().mean_px / body_px,
                          (posed[root] - positions[root]).norm() / body, root_before.angularDistance(root_after));
    candidates.push_back(std::move(candidate));
  }
  std::stable_sort(candidates.begin(), candidates.end(), cheaper);
  return candidates;
}

}  // namespace croquis
