// SPDX-License-Identifier: MIT
#include "croquis/posing/line_ranking.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "croquis/base/error.h"

namespace croquis {
namespace {

constexpr int kPoints = 33;

/// A line as it stands in the start pose's picture.
struct Seen {
  std::vector<Vec2> points;  ///< at equal parts of its length
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
  return seen;
}

/// How unlike the line of the start pose and the stroke are: mean distance, ends twice, per body size; and a stroke
/// that is longer than the bones reach, or much shorter.
double screen(const Seen& seen, const std::vector<Vec2>& stroke, double length, bool forward, double body_px) {
  double mean = 0.0;
  const auto drawn = [&](int i) { return stroke[static_cast<std::size_t>(forward ? i : kPoints - 1 - i)]; };
  for (int i = 0; i < kPoints; ++i) mean += (seen.points[static_cast<std::size_t>(i)] - drawn(i)).norm() / kPoints;
  const double ends =
      0.5 * ((seen.points.front() - drawn(0)).norm() + (seen.points.back() - drawn(kPoints - 1)).norm());
  const double ratio = std::log(length / seen.reach);
  const double misfit = ratio > 0.0 ? 2.0 * ratio : 0.5 * -ratio;
  return (mean + ends) / body_px + misfit;
}

}  // namespace

std::vector<LineCandidate> rank_body_lines(const Skeleton& skeleton, const HumanoidMap& humanoid, const Pose& start,
                                           const std::vector<BodyLine>& lines, const Polyline2& stroke,
                                           const Camera& camera, const LineRankingOptions& options) {
  if (lines.empty()) throw_invalid_argument("rank_body_lines: got no line, wanted at least one");
  if (!(stroke.length() > 0.0)) throw_invalid_argument("rank_body_lines: the stroke has no length");
  const std::vector<Vec3> positions = compute_positions(skeleton, start);
  const std::vector<Vec2> drawn = stroke.resampled(kPoints);
  const double body_px = skeleton.extent() / camera.units_per_pixel(positions.front());

  struct Entry {
    std::size_t line;
    bool forward;
    double cost, reach;
  };
  std::vector<Entry> entries;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::optional<Seen> seen = see(positions, lines[i], camera);
    if (!seen) continue;
    for (const bool forward : {true, false}) {
      entries.push_back({i, forward, screen(*seen, drawn, stroke.length(), forward, body_px), seen->reach});
    }
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
    const double fit = candidate.result.fits.front().mean_px / body_px;
    const double shortness = std::max(0.0, std::log(entry.reach / stroke.length()));
    candidate.cost = entry.cost + std::sqrt(candidate.result.turned) + 10.0 * fit + 0.5 * shortness;
    candidates.push_back(std::move(candidate));
  }
  std::stable_sort(candidates.begin(), candidates.end(), cheaper);
  return candidates;
}

}  // namespace croquis
