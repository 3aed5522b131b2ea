// SPDX-License-Identifier: MIT
#include "loa/trials.h"

#include "loa/measures.h"
#include "loa/methods.h"
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <map>
#include <string>

#include "croquis/math/rotation.h"
#include "croquis/posing/line_ranking.h"
#include "croquis/posing/live_line.h"
#include "croquis/posing/turn_prior.h"

namespace croquis::loa {
namespace {

/// Milliseconds of processor time: other programs on the machine do not count.
double since(std::clock_t begin) { return 1000.0 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC; }

/// The degrees by which a joint turned farthest between two poses.
double largest_turn(const Pose& a, const Pose& b) {
  double most = 0.0;
  for (std::size_t i = 0; i < a.local.size(); ++i) {
    most = std::max(most, a.local[i].rotation.angularDistance(b.local[i].rotation) / kDegree);
  }
  return most;
}

}  // namespace

std::vector<int> broken_limits(const Draw& draw, LimitPreset preset, const Pose& pose) {
  const Character& character = draw.clip->character;
  const auto limits = make_joint_limits(character.skeleton, character.humanoid, preset, draw.clip->neutral);
  const std::vector<int> before = find_limit_violations(limits, draw.start);
  std::vector<int> joints;
  for (const int joint : find_limit_violations(limits, pose)) {
    const bool on_line = std::count(draw.line.joints.begin(), draw.line.joints.end(), joint) > 0;
    if (on_line && std::count(before.begin(), before.end(), joint) == 0) joints.push_back(joint);
  }
  return joints;
}

void print_truths(const DrawSet& set, nlohmann::ordered_json& report) {
  for (const LimitPreset preset : {LimitPreset::anatomical, LimitPreset::dancer, LimitPreset::cartoon}) {
    int broken = 0;
    for (const Draw& draw : set.draws) broken += broken_limits(draw, preset, draw.truth).empty() ? 0 : 1;
    const std::string name(to_string(preset));
    std::printf("true poses outside `%s`: %d of %zu\n", name.c_str(), broken, set.draws.size());
    report["truths_outside"][name] = broken;
  }
  std::printf("\n");
}

void print_spreads(const DrawSet& set, nlohmann::ordered_json& report) {
  std::map<HumanoidBone, std::vector<Vec3>> spreads;  // per bone of the left side or the middle: one a clip and side
  for (const Clip& clip : set.clips) {
    const Character& character = clip.character;
    for (const TurnPrior& prior : make_turn_prior(character.skeleton, character.humanoid, clip.neutral)) {
      const std::optional<HumanoidBone> bone = character.humanoid.bone_of(prior.joint);
      if (!bone) continue;
      const auto joint = static_cast<std::size_t>(prior.joint);
      const Quat neutral = clip.neutral.local[joint].rotation;
      Vec3 sum = Vec3::Zero();
      for (const Pose& pose : clip.poses) {
        const Vec3 turn = rotation_to_vector((pose.local[joint].rotation * neutral.conjugate()).normalized());
        sum += ((neutral * prior.frame).conjugate() * turn).cwiseAbs2();
      }
      spreads[std::min(*bone, mirror(*bone))].push_back((sum / static_cast<double>(clip.poses.size())).cwiseSqrt());
    }
  }
  std::printf("root mean square turn from the neutral frame, radians: flexion, across, along the bone\n");
  for (const auto& [bone, list] : spreads) {
    Vec3 mean = Vec3::Zero();
    for (const Vec3& spread : list) mean += spread / static_cast<double>(list.size());
    const std::string name(to_string(bone));
    std::printf("  %-24s %.3f %.3f %.3f\n", name.c_str(), mean.x(), mean.y(), mean.z());
    report["spread"][name] = {mean.x(), mean.y(), mean.z()};
  }
}

void print_line_trial(const DrawSet& set, nlohmann::ordered_json& report) {
  int first = 0, third = 0, direction = 0, but_for_sides = 0;
  // left and right, crossed or not: what a picture from the side does not show
  const auto sideless = [](std::string name) {
    for (const char* side : {"left_", "right_"}) {
      for (std::size_t at; (at = name.find(side)) != std::string::npos;) name.erase(at, std::string(side).size());
    }
    return name;
  };
  std::vector<double> milliseconds;
  std::map<std::string, std::pair<int, int>> by_line;
  for (const Draw& draw : set.draws) {
    const Character& character = draw.clip->character;
    const std::vector<BodyLine> lines = standard_body_lines(character.skeleton, character.humanoid);
    LineRankingOptions options;
    options.solver = solver_options(draw, LimitPreset::none);
    const auto begin = std::clock();
    const auto found =
        rank_body_lines(character.skeleton, character.humanoid, draw.start, lines, draw.stroke, draw.camera, options);
    milliseconds.push_back(since(begin));
    auto& [right, count] = by_line[draw.line.name];
    ++count;
    const auto meant = [&](const LineCandidate& candidate) { return candidate.line.name == draw.line.name; };
    const auto end = found.begin() + std::min<std::ptrdiff_t>(3, std::ssize(found));
    if (std::any_of(found.begin(), end, meant)) ++third;
    if (!found.empty() && sideless(found.front().line.name) == sideless(draw.line.name)) ++but_for_sides;
    if (found.empty() || !meant(found.front())) continue;
    ++first;
    ++right;
    if (found.front().forward) ++direction;
  }
  const auto all = static_cast<double>(std::max<std::size_t>(1, set.draws.size()));
  const Summary ms = summarise(milliseconds);
  std::printf("body line found: first %.1f %%, within three %.1f %%; of the first, drawn the right way round %.1f %%; ",
              100.0 * first / all, 100.0 * third / all, 100.0 * direction / std::max(1, first));
  std::printf("the first is right but for left and right in %.1f %%; ", 100.0 * but_for_sides / all);
  std::printf("%.1f ms (p95 %.1f)\n", ms.median, ms.p95);
  for (const auto& [name, count] : by_line) std::printf("  %-22s %d of %d\n", name.c_str(), count.first, count.second);
  report["auto"] = {{"first", first / all},
                    {"within_three", third / all},
                    {"first_but_for_sides", but_for_sides / all},
                    {"ms_p50", ms.median},
                    {"ms_p95", ms.p95}};
}

void print_live_trial(const DrawSet& set, nlohmann::ordered_json& report) {
  constexpr double kPen = 3.0;  // pixels between two events
  std::vector<double> turns, milliseconds, e2d, fastest;
  for (const Draw& draw : set.draws) {
    const Character& character = draw.clip->character;
    LiveLine live(character.skeleton, character.humanoid, draw.start, draw.line, LineInput::Direction::forward,
                  draw.camera, solver_options(draw, LimitPreset::anatomical));
    const int events = std::max(8, static_cast<int>(draw.stroke.length() / kPen));
    const std::vector<Vec2> points = draw.stroke.resampled(events);
    Pose before = live.pose();
    double most = 0.0;
    for (std::size_t n = 2; n <= points.size(); ++n) {
      const auto begin = std::clock();
      const Pose& now = live.update(std::span(points).first(n));
      milliseconds.push_back(since(begin));
      const double turn = largest_turn(before, now) / (points[n - 1] - points[n - 2]).norm();
      turns.push_back(turn);
      most = std::max(most, turn);
      before = now;
    }
    fastest.push_back(most);
    e2d.push_back(measure(draw, live.pose()).e2d);
  }
  const Summary turn = summarise(turns), ms = summarise(milliseconds), error = summarise(e2d),
                most = summarise(fastest);
  std::printf(
      "live, a pen event every %.0f pixels: the fastest joint turns %.2f deg/px (mean), %.2f (p95); in a stroke at "
      "most %.2f (median), %.2f (p90)\n",
      kPen, turn.mean, turn.p95, most.median, most.p90);
  std::printf("an update takes %.3f ms (median), %.3f (p95); e2D at the end %.2f / %.2f %% H\n", ms.median, ms.p95,
              error.mean, error.median);
  report["live"] = {{"turn_mean", turn.mean}, {"turn_p95", turn.p95},   {"ms_p50", ms.median},
                    {"ms_p95", ms.p95},       {"e2d_mean", error.mean}, {"e2d_median", error.median}};
}

}  // namespace croquis::loa
