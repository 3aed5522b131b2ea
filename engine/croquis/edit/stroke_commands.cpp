// SPDX-License-Identifier: MIT
#include "croquis/edit/stroke_commands.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/base/index.h"
#include "croquis/base/stopwatch.h"
#include "croquis/edit/line_choice.h"
#include "croquis/edit/line_setup.h"
#include "croquis/edit/readings.h"

namespace croquis {
namespace {

bool same_samples(const std::vector<StrokeSample>& a, const std::vector<StrokeSample>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const StrokeSample& x, const StrokeSample& y) { return x.position == y.position; });
}

/// The project with a stroke followed as it was drawn.
DrawnStroke follow_stroke(const Project& project, const PlacedStroke& stroke, LiveStroke* live) {
  const Stopwatch watch;
  std::optional<LiveStroke> own;
  if (live == nullptr || !live->follows(project, stroke)) live = &own.emplace(project, stroke);
  const Pose& pose = live->update(stroke.stroke.samples);
  if (live->body_line().joints.empty()) throw_invalid_argument("the line is too short to say what it is for: draw on");
  const Actor& actor = actor_at(project, stroke.actor);
  const Character& character = *actor.character;
  DrawnStroke drawn;
  drawn.project = set_pose(project, stroke.actor, pose);
  drawn.line = live->body_line();
  drawn.report.body_line = drawn.line.name;
  drawn.report.forward = live->forward();
  drawn.report.fit = measure_fit(character.skeleton, pose, drawn.line, clean_stroke(stroke.stroke), stroke.camera);
  drawn.report.limit_violations = find_limit_violations(limits_of(project.settings, character), pose);
  drawn.report.solve_ms = watch.milliseconds();
  PlacedStroke kept = stroke;
  kept.id = drawn.project.next_id++;
  kept.before = actor.pose;
  kept.line = drawn.line;
  drawn.project.strokes.push_back(std::move(kept));
  return drawn;
}

/// The readings of a stroke, the one that is followed live first where there is one.
std::vector<StrokeReading> ordered_readings(const Project& project, const PlacedStroke& stroke,
                                            const std::optional<StrokeReading>& followed) {
  std::vector<StrokeReading> readings = readings_of(project, stroke);
  if (!followed) return readings;
  const auto same = std::find_if(readings.begin(), readings.end(), [&](const StrokeReading& r) {
    return r.line.joints == followed->line.joints && r.forward == followed->forward && r.settings.depth == 0;
  });
  if (same != readings.end()) {
    std::rotate(readings.begin(), same, same + 1);
  } else {
    readings.insert(readings.begin(), *followed);
  }
  return readings;
}

/// How a stroke that was followed live is read.
StrokeReading reading_of(const DrawnStroke& followed, StrokeSettings settings) {
  const bool forward = followed.report.forward;
  settings.alternative = settings.depth = 0;
  if (settings.joints.empty()) settings.body_line = followed.line.name;
  settings.direction = forward ? "forward" : "backward";
  return {reading_label(followed.line, forward), followed.line, forward, 0.0, std::move(settings)};
}

struct Undrawn {
  Project project;
  bool forward = true;
};

/// The project with the joints that a stroke moved where they stood when it was drawn; what was done to others since
/// stays. And which way the stroke was read.
Undrawn without_stroke(const Project& project, int index, const DrawHelp& help) {
  const PlacedStroke& stroke = project.strokes[at(index)];
  Undrawn before{project, true};
  if (!stroke.before) return before;
  Pose& pose = before.project.actors[at(stroke.actor)].pose;
  const Pose now = pose;
  pose = *stroke.before;
  const DrawnStroke again = draw_stroke(before.project, stroke, {help.live, false});
  before.forward = again.report.forward;
  const Pose& after = again.project.actors[at(stroke.actor)].pose;
  for (std::size_t i = 0; i < pose.local.size(); ++i) {
    if (after.local[i] == pose.local[i]) pose.local[i] = now.local[i];
  }
  return before;
}

}  // namespace

int stroke_index(const Project& project, int id) {
  for (int i = 0; i < std::ssize(project.strokes); ++i) {
    if (project.strokes[at(i)].id == id) return i;
  }
  throw_invalid_argument("no line on the table has the number " + std::to_string(id));
}

DrawnStroke draw_stroke(const Project& project, const PlacedStroke& stroke, const DrawHelp& help) {
  (void)actor_at(project, stroke.actor);
  check_stroke(stroke.stroke, stroke.camera);
  DrawnStroke drawn;
  PlacedStroke pen = stroke;
  pen.settings.alternative = pen.settings.depth = 0;
  std::optional<StrokeReading> followed;
  if (is_followed_live(pen.settings)) {
    drawn = follow_stroke(project, pen, help.live);
    followed = reading_of(drawn, pen.settings);
    drawn.readings = {followed->label};
    if (!help.readings && is_followed_live(stroke.settings)) return drawn;
  }
  const std::vector<StrokeReading> readings = ordered_readings(project, stroke, followed);
  drawn.readings.clear();
  for (const StrokeReading& reading : readings) drawn.readings.push_back(reading.label);
  if (is_followed_live(stroke.settings)) return drawn;
  drawn.chosen = std::clamp(stroke.settings.alternative, 0, static_cast<int>(readings.size()) - 1);
  PlacedStroke read = stroke;
  read.settings = readings[at(drawn.chosen)].settings;
  PosedLines posed = pose_along_lines(project, {read});
  drawn.project = std::move(posed.project);
  drawn.report = std::move(posed.reports.front());
  drawn.line = drawn.project.strokes.back().line;
  drawn.project.strokes.back().settings = stroke.settings;  // as it was meant, so that it can be read otherwise
  return drawn;
}

DrawnStroke change_stroke(const Project& project, int id, const std::vector<StrokeSample>& samples,
                          const StrokeSettings& settings, const DrawHelp& help) {
  const int index = stroke_index(project, id);
  PlacedStroke stroke = project.strokes[at(index)];
  const bool redrawn = !same_samples(stroke.stroke.samples, samples);
  stroke.stroke.samples = samples;
  stroke.settings = settings;
  const Undrawn before = without_stroke(project, index, help);
  if (redrawn) {
    stroke.settings.live = false;
    stroke.settings.alternative = 0;
    if (stroke.settings.joints.empty()) stroke.settings.body_line = stroke.line.name;
    if (is_line_method(settings)) stroke.settings.direction = before.forward ? "forward" : "backward";
  }
  DrawnStroke drawn = draw_stroke(before.project, stroke, help);
  PlacedStroke solved = drawn.project.strokes.back();
  solved.id = id;
  solved.before = stroke.before;
  drawn.project.strokes.pop_back();
  drawn.project.strokes[at(index)] = std::move(solved);
  return drawn;
}

Project hide_stroke(const Project& project, int id, bool hidden) {
  Project next = project;
  next.strokes[at(stroke_index(project, id))].hidden = hidden;
  return next;
}

Project delete_stroke(const Project& project, int id) {
  Project next = project;
  next.strokes.erase(next.strokes.begin() + stroke_index(project, id));
  return next;
}

}  // namespace croquis
