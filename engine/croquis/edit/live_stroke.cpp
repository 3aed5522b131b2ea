// SPDX-License-Identifier: MIT
#include "croquis/edit/live_stroke.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/edit/commands.h"
#include "croquis/edit/line_choice.h"
#include "croquis/edit/line_setup.h"
#include "croquis/math/polyline.h"

namespace croquis {
namespace {

constexpr double kStepPx = 3.0;      // the pen is followed in steps of at least this
constexpr double kDecides = 0.05;    // part of the body's size after which the line is chosen
constexpr std::size_t kMost = 4096;  // steps of one stroke

bool same_sample(const StrokeSample& a, const StrokeSample& b) { return a.position == b.position; }

/// How unlike the beginning of a line and that of a stroke are: where they start, and where they are at equal lengths.
double begun_cost(const Polyline2& line, const Polyline2& stroke, double body_px) {
  constexpr int kPoints = 8;
  const double reach = std::min(line.length(), stroke.length());
  double mean = 0.0;
  for (int i = 1; i <= kPoints; ++i) {
    const double s = reach * i / kPoints;
    mean += ((stroke.at(s) - stroke.at(0.0)) - (line.at(s) - line.at(0.0))).norm() / kPoints;
  }
  return (line.at(0.0) - stroke.at(0.0)).norm() / body_px + 0.1 * mean / std::max(reach, 1e-9);
}

}  // namespace

bool is_followed_live(const StrokeSettings& settings) {
  return settings.live && is_line_method(settings) && settings.alternative == 0 && settings.depth == 0 &&
         settings.exaggerate == 1.0 && settings.length == "fit";
}

BegunLine choose_begun_line(const Character& character, const Pose& pose, const std::vector<Vec2>& points,
                            const Camera& camera) {
  const std::vector<BodyLine> lines = standard_body_lines(character.skeleton, character.humanoid);
  if (lines.empty()) throw_invalid_argument("the skeleton has no bone to pose: it needs a joint below another");
  const std::vector<Vec3> positions = compute_positions(character.skeleton, pose);
  const double body_px = character.skeleton.extent() / camera.units_per_pixel(positions.front());
  const Polyline2 stroke(points);
  BegunLine best{lines.front(), true};
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < lines.size(); ++i) {
    std::vector<Vec2> seen;
    for (const int joint : lines[i].joints) {
      if (const auto pixel = camera.project(positions[static_cast<std::size_t>(joint)])) seen.push_back(*pixel);
    }
    if (seen.size() < lines[i].joints.size()) continue;
    for (const bool forward : {true, false}) {
      // Of lines that begin alike those that stand first are likelier; down from the head the whole body is meant.
      double cost = begun_cost(Polyline2(seen), stroke, body_px) + 0.004 * static_cast<double>(i);
      if (!forward && lines[i].name == "trunk") cost += 0.02;
      if (cost < least) {
        least = cost;
        best = {lines[i], forward};
      }
      std::reverse(seen.begin(), seen.end());
    }
  }
  return best;
}

LiveStroke::LiveStroke(const Project& project, const PlacedStroke& stroke) {
  const Actor& actor = actor_at(project, stroke.actor);
  character_ = actor.character;
  pins_ = actor.pins;
  table_ = project.settings;
  start_ = actor.pose;
  camera_ = stroke.camera;
  settings_ = stroke.settings;
  camera_.check();
  check_words(settings_);
  options_ = make_solver_options(project, actor, settings_);
  const std::vector<Vec3> positions = compute_positions(character_->skeleton, start_);
  least_px_ = kDecides * character_->skeleton.extent() / camera_.units_per_pixel(positions.front());
  restart();
}

void LiveStroke::restart() {
  line_.reset();
  body_line_ = {};
  seen_.clear();
  points_.clear();
  drawn_px_ = 0.0;
}

bool LiveStroke::follows(const Project& project, const PlacedStroke& stroke) const {
  if (stroke.actor < 0 || stroke.actor >= std::ssize(project.actors)) return false;
  const Actor& actor = project.actors[static_cast<std::size_t>(stroke.actor)];
  return actor.character == character_ && stroke.settings == settings_ && project.settings == table_ &&
         stroke.camera == camera_ && actor.pins == pins_ && actor.pose == start_;
}

void LiveStroke::begin(const std::vector<Vec2>& points) {
  using enum LineInput::Direction;
  LineInput::Direction direction = solver_direction(settings_);
  if (settings_.body_line == "auto" && settings_.joints.empty()) {
    BegunLine begun = choose_begun_line(*character_, start_, points, camera_);
    body_line_ = std::move(begun.line);
    if (direction == automatic) direction = begun.forward ? forward : backward;
  } else {
    body_line_ = choose_line(*character_, settings_).line;
    if (body_line_.joints.empty()) throw_invalid_argument("the method line wants a path of joints");
  }
  line_.emplace(character_->skeleton, character_->humanoid, start_, body_line_, direction, camera_, options_);
}

const Pose& LiveStroke::update(const std::vector<StrokeSample>& samples) {
  const bool goes_on =
      samples.size() >= seen_.size() && std::equal(seen_.begin(), seen_.end(), samples.begin(), same_sample);
  if (!goes_on) restart();
  for (std::size_t i = seen_.size(); i < samples.size(); ++i) {
    const Vec2& point = samples[i].position;
    if (!point.allFinite()) throw_invalid_argument("stroke: sample " + std::to_string(i) + " is not finite");
    seen_.push_back(samples[i]);
    if (!points_.empty() && ((point - points_.back()).norm() < kStepPx || points_.size() >= kMost)) continue;
    if (!points_.empty()) drawn_px_ += (point - points_.back()).norm();
    points_.push_back(point);
    if (drawn_px_ < least_px_) continue;
    if (!line_) begin(points_);
    line_->update(points_);
  }
  return pose();
}

}  // namespace croquis
