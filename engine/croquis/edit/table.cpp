// SPDX-License-Identifier: MIT
#include "croquis/edit/table.h"

#include <utility>

#include "croquis/base/error.h"
#include "croquis/base/stopwatch.h"
#include "croquis/base/text.h"
#include "croquis/body/pose_shelf.h"
#include "croquis/edit/body_commands.h"
#include "croquis/edit/line_choice.h"
#include "croquis/edit/open_pose.h"
#include "croquis/edit/pose_text.h"
#include "croquis/edit/readings.h"
#include "croquis/edit/table_json.h"
#include "croquis/io/character_file.h"
#include "croquis/io/svg.h"

namespace croquis {
namespace {

using Json = nlohmann::ordered_json;

std::string dump(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

/// The ids of the actors that stand or are otherwise than before.
std::vector<int> moved_actors(const Project& before, const Project& after) {
  std::vector<int> moved;
  for (const Actor& actor : after.actors) {
    const Actor* old = nullptr;
    for (const Actor& candidate : before.actors) {
      if (candidate.id == actor.id) old = &candidate;
    }
    const bool same = old != nullptr && old->character == actor.character && old->pose == actor.pose;
    if (!same) moved.push_back(actor.id);
  }
  return moved;
}

Json answer_selection(const Actor& actor, const std::vector<int>& joints) {
  try {
    StrokeSettings settings;
    settings.joints = joints;
    const LineChoice choice = choose_line(*actor.character, settings);
    Json segments = Json::array();
    for (const SkeletonSegment& segment : choice.segments) segments.push_back(segment);
    return {{"valid", true}, {"message", ""}, {"segments", segments}};
  } catch (const Error& error) {
    return {{"valid", false}, {"message", error.what()}, {"segments", Json::array()}};
  }
}

}  // namespace

Table::Table() : history_(Project{}), shown_(history_.current()) {}

std::string Table::show(const TableChange& change, bool project_changed) {
  Json answer;
  if (project_changed) {
    answer["state"] = describe_project(change.project);
    answer["state"]["undo"] = history_.undo_label();
    answer["state"]["redo"] = history_.redo_label();
  }
  answer["moved"] = moved_actors(shown_, change.project);
  if (change.line) {
    answer["solved"] = describe_line(*change.line);
    answer["solve_ms"] = change.line->report.solve_ms;
  }
  if (!change.notice.empty()) answer["notice"] = change.notice;
  shown_ = change.project;
  return dump(answer);
}

std::string Table::execute(std::string_view command_json, std::span<const std::byte> file) {
  TableChange change = apply_table_command(history_.current(), command_json, file, {live_.get(), true});
  history_.commit(change.project, change.label);
  return show(change, true);
}

std::optional<TableChange> Table::follow_pen(std::string_view command_json) {
  const Project& project = history_.current();
  const std::optional<PlacedStroke> stroke = read_draw_command(project, command_json);
  if (!stroke || !is_followed_live(stroke->settings)) return std::nullopt;
  const Stopwatch watch;
  if (!live_ || !live_->follows(project, *stroke)) live_ = std::make_shared<LiveStroke>(project, *stroke);
  TableChange change;
  change.project = set_pose(project, stroke->actor, live_->update(stroke->stroke.samples));
  if (live_->body_line().joints.empty()) return change;
  DrawnStroke line;
  line.line = live_->body_line();
  line.report.body_line = line.line.name;
  line.report.forward = live_->forward();
  line.report.solve_ms = watch.milliseconds();
  line.readings = {reading_label(line.line, line.report.forward)};
  change.line = std::move(line);
  return change;
}

std::string Table::preview(std::string_view command_json) {
  const std::optional<TableChange> followed = follow_pen(command_json);
  if (followed) return show(*followed, false);
  return show(apply_table_command(history_.current(), command_json, {}, {live_.get(), false}), false);
}

std::string Table::cancel_preview() {
  Json answer;
  answer["moved"] = Json::array();
  for (const Actor& actor : history_.current().actors) answer["moved"].push_back(actor.id);
  shown_ = history_.current();
  return dump(answer);
}

std::string Table::undo() {
  history_.undo();
  return show({history_.current(), {}, {}, {}}, true);
}

std::string Table::redo() {
  history_.redo();
  return show({history_.current(), {}, {}, {}}, true);
}

std::string Table::restore(std::span<const std::byte> project_file) {
  history_ = History(read_project(project_file, "project.croquis"));
  return show({history_.current(), {}, {}, {}}, true);
}

const Actor& Table::shown_actor(int id) const {
  return shown_.actors[static_cast<std::size_t>(actor_index(shown_, id))];
}

std::string Table::query(std::string_view name, std::string_view arguments_json) const {
  const TableArguments arguments(arguments_json);
  const Project& project = history_.current();
  const int index = actor_index(project, arguments.integer("actor"));
  const Actor& actor = project.actors[static_cast<std::size_t>(index)];
  const Character& character = *actor.character;
  if (name == "pose") return dump({{"pose", write_pose_text(character, actor.pose)}});
  if (name == "pose_joints") {
    Json joints = Json::array();
    const Pose pose = read_pose_text(arguments.text("pose"), character, character.start);
    for (const Vec3& p : compute_positions(character.skeleton, pose)) {
      for (int axis = 0; axis < 3; ++axis) joints.push_back(p[axis]);
    }
    return dump({{"joints", joints}});
  }
  if (name == "shelf") {
    Json poses = Json::array();
    if (character.humanoid.is_humanoid()) {
      for (const ShelfPose& pose : make_pose_shelf()) {
        poses.push_back({{"name", pose.name},
                         {"pose", write_pose_text(pose.pose, pose.grounded)},
                         {"kind", pose.kind == ShelfPose::Kind::hand ? "hand" : "pose"}});
      }
    }
    for (const NamedPose& kept : project.poses) {
      if (kept.actor != index) continue;
      poses.push_back({{"name", kept.name}, {"pose", write_pose_text(character, kept.pose)}, {"kind", "mine"}});
    }
    return dump({{"poses", poses}});
  }
  if (name == "selection") return dump(answer_selection(actor, arguments.integers("joints")));
  throw_invalid_argument("there is no query '" + printable(name) + "'; there are pose, pose_joints, shelf, selection");
}

Bytes Table::export_file(std::string_view format, int actor_id, std::string_view options_json) const {
  const Project& project = history_.current();
  const TableArguments options(options_json);
  const auto bytes_of = [](const std::string& text) {
    const auto* first = reinterpret_cast<const std::byte*>(text.data());
    return Bytes(first, first + text.size());
  };
  if (format == "croquis") return write_project(project);
  if (format == "svg") {
    const Camera camera = options.camera("camera");
    std::vector<Stroke> strokes;
    for (const PlacedStroke& placed : project.strokes) {
      if (!placed.hidden) strokes.push_back(placed.stroke);
    }
    if (strokes.empty()) throw_invalid_argument("there is no line on the table to export");
    return bytes_of(write_svg_strokes(strokes, camera.width_px, camera.height_px));
  }
  const Actor& actor = project.actors[static_cast<std::size_t>(actor_index(project, actor_id))];
  if (format == "openpose") return bytes_of(write_open_pose(project, options.camera("camera")));
  const std::string file_name = "croquis." + std::string(format);
  WrittenFile written = write_character(*actor.character, actor.pose, format, file_name, {});
  if (!written.companions.empty()) {
    throw Error(ErrorCode::unsupported, "a page saves one file at a time: export GLB, which holds everything in one");
  }
  return std::move(written.bytes);
}

}  // namespace croquis
