// SPDX-License-Identifier: MIT
#include "croquis/posing/line_ranking.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "croquis/base/error.h"
#include "croquis/posing/joint_roles.h"
#include "croquis/posing/line_likeness.h"
#include "croquis/posing/pose_edit.h"

namespace croquis {
namespace {

/// What the parts of an Unlikeness weigh. Both tables were fitted (logistic regression over the lines of each stroke)
/// to poses of people, so that differences of the sums are log odds: what matters most is that a stroke passes where
/// the hips are, which tells left from right too, and that a line is about as long in the picture as it was.
struct Odds {
  std::array<double, kBodyParts> away, aside;  // trunk, hip, shoulder, head, knee, elbow, foot, hand
  double too_long, longer, shorter;
};
constexpr Odds kScreening = {
    {12.4, 7.0, 3.4, 6.2, 4.1, 6.5, 2.1, -2.8}, {10.1, 35.4, 2.9, -10.1, -2.6, 3.6, -4.7, -5.6}, 4.4, 2.4, 1.5};
constexpr Odds kPosed = {
    {5.6, 6.6, 0.7, -2.0, -1.4, 3.1, 0.1, -2.3}, {7.6, 44.4, 6.8, -4.1, -2.9, 1.1, -0.8, -2.1}, 18.1, 0.0, 2.0};

double weigh(const Unlikeness& u, const Odds& odds) {
  double sum = odds.too_long * u.too_long + odds.longer * u.longer + odds.shorter * u.shorter;
  for (std::size_t part = 0; part < u.away.size(); ++part) {
    sum += odds.away[part] * u.away[part] + odds.aside[part] * u.aside[part];
  }
  return sum;
}

/// The same with the pose that comes of it: what it asks of the body, how well it answers, how far the root goes (body
/// sizes, radians).
double weigh_posed(const Unlikeness& u, const LineSolverResult& result, double fit, double root_moved,
                   double root_turned) {
  return weigh(u, kPosed) + 4.8 * std::sqrt(result.turned) + 38.9 * fit + 45.3 * std::sqrt(result.report.residual) +
         10.4 * root_moved + 1.3 * root_turned;
}

}  // namespace

std::vector<LineCandidate> rank_body_lines(const Skeleton& skeleton, const HumanoidMap& humanoid, const Pose& start,
                                           const std::vector<BodyLine>& lines, const Polyline2& stroke,
                                           const Camera& camera, const LineRankingOptions& options) {
  if (lines.empty()) throw_invalid_argument("rank_body_lines: got no line, wanted at least one");
  if (!(stroke.length() > 0.0)) throw_invalid_argument("rank_body_lines: the stroke has no length");
  const std::vector<Vec3> positions = compute_positions(skeleton, start);

  std::vector<std::optional<SeenLine>> pictures;
  double body_px = 0.0;  // leg and trunk of a person: two thirds of the way from foot to hand
  for (const BodyLine& line : lines) {
    pictures.push_back(see_line(humanoid, positions, line, camera));
    if (pictures.back()) body_px = std::max(body_px, pictures.back()->reach / 1.5);
  }
  struct Entry {
    LineCandidate candidate;
    Unlikeness unlike;
    double cost;
  };
  std::vector<Entry> entries;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (!pictures[i]) continue;
    // The way round that is nearer to the start pose; the other would turn the body over.
    const Unlikeness ahead = compare_line(*pictures[i], stroke, true, body_px),
                     back = compare_line(*pictures[i], stroke, false, body_px);
    const double ahead_cost = weigh(ahead, kScreening), back_cost = weigh(back, kScreening);
    const bool forward = ahead_cost <= back_cost;
    entries.push_back({{lines[i], forward, 0.0, {}}, forward ? ahead : back, std::min(ahead_cost, back_cost)});
  }
  std::stable_sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.cost < b.cost; });
  const auto most = static_cast<std::size_t>(std::max(1, options.solved));
  if (entries.size() > most) entries.erase(entries.begin() + static_cast<std::ptrdiff_t>(most), entries.end());

  const auto root = static_cast<std::size_t>(find_body_root(skeleton, humanoid));
  const double body = body_px * camera.units_per_pixel(positions[root]);
  const Quat root_before = compute_model_rotations(skeleton, start)[root];
  LineSolverOptions quick = options.solver;
  quick.thorough = false;
  std::vector<LineCandidate> candidates;
  for (Entry& entry : entries) {
    LineCandidate& candidate = entry.candidate;
    LineInput input{candidate.line, stroke};
    input.direction = candidate.forward ? LineInput::Direction::forward : LineInput::Direction::backward;
    candidate.result = solve_lines(skeleton, humanoid, start, {input}, camera, quick);
    const std::vector<Vec3> posed = compute_positions(skeleton, candidate.result.pose);
    const Quat root_after = compute_model_rotations(skeleton, candidate.result.pose)[root];
    candidate.cost =
        weigh_posed(entry.unlike, candidate.result, candidate.result.fits.front().mean_px / body_px,
                    (posed[root] - positions[root]).norm() / body, root_before.angularDistance(root_after));
    candidates.push_back(std::move(candidate));
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const LineCandidate& a, const LineCandidate& b) { return a.cost < b.cost; });
  return candidates;
}

}  // namespace croquis
