// SPDX-License-Identifier: MIT
#include "croquis/edit/readings.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "croquis/edit/line_choice.h"
#include "croquis/math/polyline.h"
#include "croquis/sketch/stroke.h"

namespace croquis {
namespace {

struct Candidate {
  BodyLine line;
  bool forward = true;
  double cost = 0.0;
};

/// Distances between the stroke's ends and the line's, in picture heights, and the ratio of their lengths.
double cost_of(const std::vector<Vec3>& positions, const BodyLine& line, bool forward, const Polyline2& stroke,
               const Camera& camera) {
  std::vector<Vec2> pixels;
  for (const int joint : line.joints) {
    const std::optional<Vec2> pixel = camera.project(positions[static_cast<std::size_t>(joint)]);
    if (!pixel) return 1e3;
    pixels.push_back(*pixel);
  }
  const Polyline2 drawn(pixels);
  const Vec2 &first = forward ? pixels.front() : pixels.back(), &last = forward ? pixels.back() : pixels.front();
  const double ends = (stroke.points().front() - first).norm() + 0.7 * (stroke.points().back() - last).norm();
  const double length = std::abs(std::log(std::max(stroke.length(), 1.0) / std::max(drawn.length(), 1.0)));
  return ends / camera.height_px + 0.12 * length + (forward ? 0.0 : 0.02);
}

}  // namespace

std::vector<StrokeReading> readings_of(const Character& character, const Pose& pose, const PlacedStroke& stroke) {
  const StrokeSettings& settings = stroke.settings;
  const bool any_line = settings.body_line == "auto" && settings.joints.empty();
  std::vector<BodyLine> lines;
  if (any_line) {
    lines = standard_body_lines(character.skeleton, character.humanoid);
  } else {
    StrokeSettings said = settings;
    if (said.body_line == "auto") said.body_line.clear();
    lines.push_back(choose_line(character, said).line);
  }
  check_stroke(stroke.stroke, stroke.camera);
  const Polyline2 drawn = clean_stroke(stroke.stroke);
  const std::vector<Vec3> positions = compute_positions(character.skeleton, pose);
  std::vector<Candidate> candidates;
  for (const BodyLine& line : lines) {
    for (const bool forward : {true, false}) {
      if (settings.direction == (forward ? "backward" : "forward")) continue;
      const double cost = line.joints.empty() ? 0.0 : cost_of(positions, line, forward, drawn, stroke.camera);
      candidates.push_back({line, forward, cost});
    }
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; });
  constexpr std::size_t kMost = 6;
  if (candidates.size() > kMost) candidates.resize(kMost);

  std::vector<StrokeReading> readings;
  for (const Candidate& candidate : candidates) {
    StrokeReading reading{candidate.line.name + (candidate.forward ? "" : " (backward)"), settings};
    if (any_line) reading.settings.body_line = candidate.line.name;
    if (!settings.joints.empty()) reading.settings.body_line.clear();
    reading.settings.direction = candidate.forward ? "forward" : "backward";
    readings.push_back(std::move(reading));
  }
  return readings;
}

}  // namespace croquis
