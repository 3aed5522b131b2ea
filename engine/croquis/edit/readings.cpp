// SPDX-License-Identifier: MIT
#include "croquis/edit/readings.h"

#include <algorithm>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/base/text.h"
#include "croquis/edit/commands.h"
#include "croquis/edit/line_choice.h"
#include "croquis/edit/line_setup.h"
#include "croquis/posing/line_ranking.h"

namespace croquis {
namespace {

bool is_open(const StrokeSettings& settings) { return settings.body_line == "auto" && settings.joints.empty(); }

/// The candidates for a stroke among `lines`, the wanted direction alone if one is said. As many are solved whatever is
/// asked for: the second reading is the same in a list of two and of five.
std::vector<LineCandidate> rank(const Project& project, const PlacedStroke& stroke,
                                const std::vector<BodyLine>& lines) {
  const Actor& actor = actor_at(project, stroke.actor);
  const Character& character = *actor.character;
  StrokeSettings settings = stroke.settings;
  if (!is_line_method(settings)) settings = {};
  LineRankingOptions options;
  options.solver = make_solver_options(project, actor, settings);
  PlacedStroke read = stroke;
  read.settings = settings;
  const LineInput input = make_line_input(read, {});
  std::vector<LineCandidate> candidates =
      rank_body_lines(character.skeleton, character.humanoid, actor.pose, lines, input.stroke, stroke.camera, options);
  const std::string& wanted = stroke.settings.direction;
  if (wanted != "forward" && wanted != "backward") return candidates;
  std::vector<LineCandidate> kept;
  std::copy_if(candidates.begin(), candidates.end(), std::back_inserter(kept),
               [&](const LineCandidate& c) { return c.forward == (wanted == "forward"); });
  if (!kept.empty()) return kept;
  for (LineCandidate& candidate : candidates) candidate.forward = wanted == "forward";
  return candidates;
}

StrokeReading reading_of(const StrokeSettings& settings, const BodyLine& line, bool forward, double cost) {
  StrokeReading reading{reading_label(line, forward), line, forward, cost, settings};
  if (is_open(settings)) reading.settings.body_line = line.name;
  reading.settings.direction = forward ? "forward" : "backward";
  reading.settings.alternative = 0;
  return reading;
}

/// The readings of a stroke whose line is known: both ways round; of a matching method, as its own rule has it.
std::vector<StrokeReading> read_known_line(const Project& project, const PlacedStroke& stroke) {
  const Character& character = *actor_at(project, stroke.actor).character;
  const LineChoice choice = choose_line(character, stroke.settings);
  StrokeReading first{choice.line.name, choice.line, true, 0.0, stroke.settings};
  first.settings.alternative = 0;
  if (choice.line.joints.empty() || !is_line_method(stroke.settings)) return {first};
  std::vector<StrokeReading> readings;
  for (const LineCandidate& candidate : rank(project, stroke, {choice.line})) {
    readings.push_back(reading_of(stroke.settings, choice.line, candidate.forward, candidate.cost));
  }
  if (readings.size() == 1 && stroke.settings.direction == "auto") {
    const StrokeReading& only = readings.front();
    readings.push_back(reading_of(stroke.settings, choice.line, !only.forward, only.cost + 1.0));
  }
  return readings;
}

/// Puts the likeliest reading's other depths after it.
void add_depths(const Project& project, const PlacedStroke& stroke, std::vector<StrokeReading>& readings) {
  constexpr int kMostDepths = 3;
  if (readings.empty() || readings.front().line.joints.empty() || !is_line_method(stroke.settings)) return;
  const StrokeReading first = readings.front();
  const Actor& actor = actor_at(project, stroke.actor);
  PlacedStroke read = stroke;
  read.settings = first.settings;
  const std::vector<LineSolverResult> depths = solve_alternatives(
      actor.character->skeleton, actor.character->humanoid, actor.pose, {make_line_input(read, first.line)},
      stroke.camera, make_solver_options(project, actor, first.settings), kMostDepths);
  for (int k = 1; k < std::ssize(depths); ++k) {
    StrokeReading reading = first;
    reading.label += " (depth " + std::to_string(k + 1) + ")";
    const double more = depths[static_cast<std::size_t>(k)].report.residual - depths.front().report.residual;
    reading.cost = std::max(readings[static_cast<std::size_t>(k - 1)].cost, first.cost + more);
    reading.settings.depth = k;
    readings.insert(readings.begin() + k, std::move(reading));
  }
}

/// Whether two lines have a bone in common: two joints that are neighbours in both.
bool share_a_bone(const BodyLine& a, const BodyLine& b) {
  for (std::size_t i = 1; i < a.joints.size(); ++i) {
    for (std::size_t k = 1; k < b.joints.size(); ++k) {
      const std::pair one = std::minmax(a.joints[i - 1], a.joints[i]);
      const std::pair other = std::minmax(b.joints[k - 1], b.joints[k]);
      if (one == other) return true;
    }
  }
  return false;
}

}  // namespace

std::string reading_label(const BodyLine& line, bool forward) { return line.name + (forward ? "" : " (backward)"); }

std::vector<StrokeReading> readings_of(const Project& project, const PlacedStroke& stroke, int most) {
  const Character& character = *actor_at(project, stroke.actor).character;
  stroke.camera.check();
  check_stroke(stroke.stroke, stroke.camera);
  std::vector<StrokeReading> readings;
  if (is_open(stroke.settings)) {
    const std::vector<BodyLine> lines = standard_body_lines(character.skeleton, character.humanoid);
    if (lines.empty()) throw_invalid_argument("the skeleton has no bone to pose: it needs a joint below another");
    for (const LineCandidate& candidate : rank(project, stroke, lines)) {
      readings.push_back(reading_of(stroke.settings, candidate.line, candidate.forward, candidate.cost));
    }
  } else {
    readings = read_known_line(project, stroke);
  }
  add_depths(project, stroke, readings);
  if (std::ssize(readings) > most) readings.resize(static_cast<std::size_t>(std::max(1, most)));
  return readings;
}

std::vector<PlacedStroke> assign_body_lines(const Project& project, std::vector<PlacedStroke> strokes) {
  if (strokes.empty()) return strokes;
  const Character& character = *actor_at(project, strokes.front().actor).character;
  const std::vector<BodyLine> lines = standard_body_lines(character.skeleton, character.humanoid);
  std::vector<BodyLine> taken;
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    const auto named = std::find_if(lines.begin(), lines.end(),
                                    [&](const BodyLine& line) { return line.name == strokes[i].stroke.name; });
    if (is_open(strokes[i].settings) && named != lines.end()) strokes[i].settings.body_line = named->name;
    if (is_open(strokes[i].settings)) {
      open.push_back(i);
    } else {
      taken.push_back(choose_line(character, strokes[i].settings).line);
    }
  }
  struct Match {
    std::size_t stroke;
    LineCandidate candidate;
  };
  std::vector<Match> matches;
  for (const std::size_t i : open) {
    check_stroke(strokes[i].stroke, strokes[i].camera);
    for (LineCandidate& candidate : rank(project, strokes[i], lines)) matches.push_back({i, std::move(candidate)});
  }
  std::stable_sort(matches.begin(), matches.end(),
                   [](const Match& a, const Match& b) { return a.candidate.cost < b.candidate.cost; });
  for (const Match& match : matches) {
    StrokeSettings& settings = strokes[match.stroke].settings;
    const BodyLine& line = match.candidate.line;
    const auto crosses = [&](const BodyLine& other) { return share_a_bone(line, other); };
    if (!is_open(settings) || std::any_of(taken.begin(), taken.end(), crosses)) continue;
    settings.body_line = line.name;
    if (settings.direction == "auto") settings.direction = match.candidate.forward ? "forward" : "backward";
    taken.push_back(line);
  }
  for (const std::size_t i : open) {
    if (!is_open(strokes[i].settings)) continue;
    throw_invalid_argument("stroke " + std::to_string(i + 1) +
                           (strokes[i].stroke.name.empty() ? "" : " ('" + printable(strokes[i].stroke.name) + "')") +
                           ": no body line is left for it; name one by the stroke's id");
  }
  return strokes;
}

}  // namespace croquis
