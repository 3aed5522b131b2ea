// SPDX-License-Identifier: MIT
#include "croquis/edit/table_command.h"

#include <array>
#include <cmath>
#include <functional>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/base/text.h"
#include "croquis/body/body.h"
#include "croquis/edit/body_commands.h"
#include "croquis/edit/stroke_commands.h"
#include "croquis/edit/table_json.h"
#include "croquis/io/character_file.h"
#include "croquis/project/set_down.h"

namespace croquis {
namespace {

/// A command's own arguments, and the project it is for.
struct Call {
  const Project& project;
  const TableArguments& arguments;
  std::span<const std::byte> file;
  const DrawHelp& help;

  [[nodiscard]] int actor() const { return arguments.integer("actor"); }
  [[nodiscard]] int stroke() const { return arguments.integer("stroke"); }
};

TableChange plain(Project project, std::string label) { return {std::move(project), std::move(label), {}, {}}; }

TableChange solved(DrawnStroke drawn, std::string label) {
  TableChange change;
  change.project = std::move(drawn.project);
  change.label = std::move(label);
  change.line = std::move(drawn);
  return change;
}

TableChange add_builtin(const Call& call) {
  const std::string name = call.arguments.text("character");
  const Proportions proportions = read_proportions(call.arguments.numbers_by_name("proportions"));
  return plain(set_down_beside(add_builtin_character(call.project, name, proportions)), "add " + name);
}

TableChange set_proportions(const Call& call) {
  const int index = actor_index(call.project, call.actor());
  Project next = call.project;
  Actor& actor = next.actors[static_cast<std::size_t>(index)];
  if (actor.builtin.empty()) throw_invalid_argument("only the built-in characters have proportions to set");
  actor.proportions = call.arguments.numbers_by_name("proportions");
  auto character = make_builtin_actor(actor.builtin, read_proportions(actor.proportions));
  if (!actor.place.isZero(0.0)) character = std::make_shared<const Character>(set_down(*character, actor.place));
  // The same skeleton in other measures: rotations carry over, places come from the new body.
  Pose pose = character->start;
  for (std::size_t i = 0; i < pose.local.size(); ++i) pose.local[i].rotation = actor.pose.local[i].rotation;
  actor.character = std::move(character);
  actor.pose = std::move(pose);
  actor.pins.clear();
  const auto of_actor = [&](const auto& thing) { return thing.actor == index; };
  std::erase_if(next.strokes, of_actor);
  std::erase_if(next.poses, of_actor);
  return plain(std::move(next), "proportions");
}

TableChange open(const Call& call) {
  const std::string name = call.arguments.text("file");
  if (file_format(name) == "croquis") {
    Project opened = read_project(call.file, name);
    for (Actor& actor : opened.actors) {
      if (actor.id == 0) actor.id = opened.next_id++;
    }
    for (PlacedStroke& stroke : opened.strokes) {
      if (stroke.id == 0) stroke.id = opened.next_id++;
    }
    return plain(std::move(opened), "open " + name);
  }
  const ResourceReader nothing_beside = [](std::string_view uri) -> Bytes {
    throw Error(ErrorCode::io,
                "this file needs '" + printable(uri) + "' beside it: open a .glb, which holds everything");
  };
  auto character = std::make_shared<const Character>(read_character(call.file, name, nothing_beside));
  return plain(set_down_beside(add_character(call.project, std::move(character))), "open " + name);
}

PlacedStroke drawn_stroke(const Project& project, const TableArguments& arguments) {
  PlacedStroke stroke;
  stroke.actor = actor_index(project, arguments.integer("actor"));
  stroke.stroke.samples = arguments.samples("samples");
  stroke.stroke.raw_pen = true;
  stroke.camera = arguments.camera("camera");
  stroke.settings = arguments.stroke_settings("settings", default_stroke_settings(project));
  return stroke;
}

TableChange draw(const Call& call) {
  return solved(draw_stroke(call.project, drawn_stroke(call.project, call.arguments), call.help), "draw");
}

TableChange redraw(const Call& call) {
  const PlacedStroke& old = call.project.strokes[static_cast<std::size_t>(stroke_index(call.project, call.stroke()))];
  return solved(change_stroke(call.project, call.stroke(), call.arguments.samples("samples"), old.settings, call.help),
                "redraw");
}

TableChange set_stroke(const Call& call) {
  const PlacedStroke& old = call.project.strokes[static_cast<std::size_t>(stroke_index(call.project, call.stroke()))];
  if (call.arguments.has("hidden")) {
    const bool hidden = call.arguments.flag("hidden");
    return plain(hide_stroke(call.project, call.stroke(), hidden), hidden ? "hide line" : "show line");
  }
  const StrokeSettings settings = call.arguments.stroke_settings("settings", old.settings);
  return solved(change_stroke(call.project, call.stroke(), old.stroke.samples, settings, call.help), "change line");
}

TableChange drag(const Call& call) {
  TableChange change;
  std::string status;
  change.project =
      drag_joint(call.project, call.actor(), call.arguments.integer("joint"), call.arguments.point("target"), &status);
  change.label = "move";
  if (status != "ok") change.notice = status;
  return change;
}

TableChange mirror_command(const Call& call) {
  const std::string side = call.arguments.text("side");
  const MirrorSide which = side == "left" ? MirrorSide::left : side == "right" ? MirrorSide::right : MirrorSide::both;
  if (which == MirrorSide::both && side != "both") throw_bad_file("/side", "wanted both, left or right");
  return plain(mirror_actor(call.project, call.actor(), which), "mirror");
}

TableChange set_table(const Call& call) {
  Project next = call.project;
  next.settings = call.arguments.table_settings("settings", call.project.settings);
  return plain(std::move(next), "rules");
}

TableChange delete_view(const Call& call) {
  const int index = call.arguments.integer("index");
  if (index < 0 || index >= std::ssize(call.project.views)) throw_bad_file("/index", "names no kept view");
  Project next = call.project;
  next.views.erase(next.views.begin() + index);
  return plain(std::move(next), "forget view");
}

using Handler = TableChange (*)(const Call&);

constexpr std::array<std::pair<std::string_view, Handler>, 20> kHandlers{{
    {"add_character", add_builtin},
    {"open", open},
    {"set_proportions", set_proportions},
    {"remove_actor", [](const Call& c) { return plain(remove_actor(c.project, c.actor()), "remove"); }},
    {"draw", draw},
    {"redraw", redraw},
    {"set_stroke", set_stroke},
    {"delete_stroke", [](const Call& c) { return plain(delete_stroke(c.project, c.stroke()), "delete line"); }},
    {"set_table", set_table},
    {"drag", drag},
    {"rotate",
     [](const Call& c) {
       const Quat turn = c.arguments.rotation("rotation_model");
       return plain(rotate_joint(c.project, c.actor(), c.arguments.integer("joint"), turn), "rotate");
     }},
    {"pin",
     [](const Call& c) {
       const bool on = c.arguments.flag("on");
       return plain(
           pin_joint(c.project, c.actor(), c.arguments.integer("joint"), on, c.arguments.flag("with_rotation")),
           on ? "pin" : "unpin");
     }},
    {"mirror", mirror_command},
    {"reset",
     [](const Call& c) {
       return plain(reset_actor(c.project, c.actor(), c.arguments.integers("joints"), c.arguments.number("amount")),
                    "reset");
     }},
    {"apply_pose",
     [](const Call& c) {
       return plain(apply_pose_text(c.project, c.actor(), c.arguments.text("pose"), c.arguments.number("strength"),
                                    c.arguments.flag("flipped")),
                    "pose");
     }},
    {"keep_pose",
     [](const Call& c) { return plain(keep_pose(c.project, c.actor(), c.arguments.text("pose_name")), "keep pose"); }},
    {"go_to_frame",
     [](const Call& c) {
       return plain(go_to_frame(c.project, c.actor(), c.arguments.integer("clip"), c.arguments.integer("frame")),
                    "frame");
     }},
    {"keep_view",
     [](const Call& c) {
       return plain(set_view(c.project, c.arguments.text("view_name"), c.arguments.camera("camera")), "keep view");
     }},
    {"delete_view", delete_view},
    {"clear",
     [](const Call& c) {
       Project empty;
       empty.next_id = c.project.next_id;
       return plain(std::move(empty), "new table");
     }},
}};

}  // namespace

TableChange apply_table_command(const Project& project, std::string_view command_json, std::span<const std::byte> file,
                                const DrawHelp& help) {
  const TableArguments arguments(command_json);
  const std::string name = arguments.text("name");
  for (const auto& [known, handler] : kHandlers) {
    if (known == name) return handler({project, arguments, file, help});
  }
  std::vector<std::string> names;
  for (const auto& [known, handler] : kHandlers) names.emplace_back(known);
  throw_bad_file("/name", "'" + printable(name) + "' is no command; there are " + join(names, ", "));
}

std::optional<PlacedStroke> read_draw_command(const Project& project, std::string_view command_json) {
  const TableArguments arguments(command_json);
  if (arguments.text("name") != "draw") return std::nullopt;
  return drawn_stroke(project, arguments);
}

}  // namespace croquis
