// SPDX-License-Identifier: MIT
#include "croquis/edit/stroke_commands.h"

#include <algorithm>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/edit/readings.h"

namespace croquis {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

}  // namespace

int stroke_index(const Project& project, int id) {
  for (int i = 0; i < std::ssize(project.strokes); ++i) {
    if (project.strokes[at(i)].id == id) return i;
  }
  throw_invalid_argument("no line on the table has the number " + std::to_string(id));
}

DrawnStroke draw_stroke(const Project& project, const PlacedStroke& stroke) {
  if (stroke.actor < 0 || stroke.actor >= std::ssize(project.actors)) {
    throw_invalid_argument("draw_stroke: there is no such character");
  }
  const Actor& actor = project.actors[at(stroke.actor)];
  const std::vector<StrokeReading> readings = readings_of(*actor.character, actor.pose, stroke);
  if (readings.empty()) throw_invalid_argument("the skeleton has no bone to pose: it needs a joint below another");
  DrawnStroke drawn;
  drawn.chosen = std::clamp(stroke.settings.alternative, 0, static_cast<int>(readings.size()) - 1);
  for (const StrokeReading& reading : readings) drawn.readings.push_back(reading.label);
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
                          const StrokeSettings& settings) {
  const int index = stroke_index(project, id);
  PlacedStroke stroke = project.strokes[at(index)];
  stroke.stroke.samples = samples;
  stroke.settings = settings;
  Project before = project;
  if (stroke.before) {
    Pose& pose = before.actors[at(stroke.actor)].pose;
    for (const int joint : stroke.line.joints) pose.local[at(joint)] = stroke.before->local[at(joint)];
  }
  DrawnStroke drawn = draw_stroke(before, stroke);
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
