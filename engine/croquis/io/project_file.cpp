// SPDX-License-Identifier: MIT
// The project file is a GLB whose scene shows the actors as they stand. All that makes it a project is in the root
// extension CROQUIS_project: the file that each character came from, whole, and strokes, poses, views and settings.
// Joints are named by the nodes of their own file, so that another choice of joints in a later version reads the same.
#include "croquis/io/project_file.h"

#include <utility>

#include <nlohmann/json.hpp>

#include "croquis/base/error.h"
#include "croquis/base/text.h"
#include "croquis/io/bvh.h"
#include "croquis/io/gltf_build.h"
#include "croquis/io/gltf_edit.h"
#include "croquis/io/gltf_read.h"
#include "croquis/io/gltf_write.h"
#include "croquis/io/obj.h"
#include "croquis/io/project_json.h"
#include "croquis/project/set_down.h"

namespace croquis {
namespace {

constexpr const char* kExtension = "CROQUIS_project";
constexpr int kVersion = 1;

/// The file that a character is kept as: its own, or one made now.
SourceFile source_of(const Character& character) {
  if (character.source != nullptr) return *character.source;
  SourceFile source;
  source.format = "glb";
  source.name = (character.name.empty() ? "character" : character.name) + ".glb";
  source.bytes = write_new_gltf(character, character.start, "glb", source.name, {}).bytes;
  return source;
}

Json write_source(GltfEditor& editor, const SourceFile& source) {
  Json json = {{"format", source.format}, {"name", source.name}, {"bufferView", editor.add_view(source.bytes)}};
  for (const auto& [uri, bytes] : source.resources) {
    if (bytes.empty()) continue;
    json["resources"].push_back({{"uri", uri}, {"bufferView", editor.add_view(bytes)}});
  }
  return json;
}

Json write_humanoid(const HumanoidMap& humanoid, const JointNodes& nodes) {
  Json json = Json::object();
  for (int i = 0; i < kHumanoidBoneCount; ++i) {
    const HumanoidMap::Entry& entry = humanoid.entries[static_cast<std::size_t>(i)];
    if (entry.joint < 0) continue;
    json[std::string(to_string(static_cast<HumanoidBone>(i)))] = {{"node", nodes.node(entry.joint)},
                                                                  {"confidence", entry.confidence}};
  }
  return json;
}

HumanoidMap read_humanoid(const JsonPlace& place, const JointNodes& nodes) {
  HumanoidMap humanoid;
  for (const std::string& name : place.keys()) {
    const auto bone = parse_humanoid_bone(name);
    if (bone) humanoid.set(*bone, nodes.joint(place[name]["node"]), place[name]["confidence"].number());
  }
  return humanoid;
}

Json write_actor(GltfEditor& editor, const Actor& actor) {
  const Character& character = *actor.character;
  const JointNodes nodes(character);
  Json pins = Json::array(), proportions = Json::object();
  for (const Pin& pin : actor.pins) pins.push_back(write_pin(pin, nodes));
  for (const auto& [name, value] : actor.proportions) proportions[name] = value;
  const Vec3& front = character.front;
  // The file that it is kept as does not know where on the table it was set down.
  const bool is_moved = character.source == nullptr && !actor.place.isZero(0.0);
  const SourceFile source = source_of(is_moved ? set_down(character, -actor.place) : character);
  Json json = {{"name", character.name},
               {"id", actor.id},
               {"source", write_source(editor, source)},
               {"humanoid", write_humanoid(character.humanoid, nodes)},
               {"front", {front.x(), front.y(), front.z()}},
               {"pose", write_pose(actor.pose, nodes)},
               {"pins", std::move(pins)},
               {"builtin", actor.builtin},
               {"proportions", std::move(proportions)}};
  if (!actor.place.isZero(0.0)) json["place"] = {actor.place.x(), actor.place.y(), actor.place.z()};
  return json;
}

Character read_source(const GltfDocument& document, const JsonPlace& place) {
  const auto bytes_of = [&](const JsonPlace& owner) {
    return document.buffer_view(owner["bufferView"].index(document.count("bufferViews"), "buffer view"));
  };
  const auto resources = [&](std::string_view uri) -> Bytes {
    const JsonPlace list = place["resources"];
    for (int i = 0; i < list.size(); ++i) {
      if (list[i]["uri"].text() != uri) continue;
      const auto bytes = bytes_of(list[i]);
      return {bytes.begin(), bytes.end()};
    }
    throw Error(ErrorCode::io, "'" + printable(uri) + "' is not there");
  };
  const std::string format = place["format"].text(), name = place["name"].text();
  const auto bytes = bytes_of(place);
  try {
    if (format == "bvh") return read_bvh(bytes, name);
    if (format == "obj") return read_obj(bytes, name);
    return read_gltf(bytes, name, resources);
  } catch (const Error& error) {
    throw Error(error.code(), place.pointer() + ": in '" + printable(name) + "': " + error.what());
  }
}

Actor read_actor(const GltfDocument& document, const JsonPlace& place) {
  Character character = read_source(document, place["source"]);
  const JointNodes nodes(character);
  character.name = place["name"].text();
  if (place["humanoid"].exists()) character.humanoid = read_humanoid(place["humanoid"], nodes);
  if (place["front"].exists()) {
    const Vec3 front(place["front"].numbers(3).data());
    if (std::abs(front.norm() - 1.0) > 1e-3) place["front"].fail("wanted a unit vector");
    character.front = front.normalized();
  }
  Actor actor;
  if (place["place"].exists()) {
    actor.place = Vec3(place["place"].numbers(3).data());
    character = set_down(std::move(character), actor.place);
  }
  actor.pose = read_pose(place["pose"], nodes, character.start);
  actor.id = static_cast<int>(place["id"].integer_or(0, 0, 2147483647));
  const JsonPlace pins = place["pins"], proportions = place["proportions"];
  for (int i = 0; i < pins.size(); ++i) actor.pins.push_back(read_pin(pins[i], nodes));
  actor.builtin = place["builtin"].text_or("");
  for (const std::string& name : proportions.keys()) actor.proportions[name] = proportions[name].number();
  actor.character = std::make_shared<const Character>(std::move(character));
  return actor;
}

JsonPlace open_extension(const GltfDocument& document) {
  const JsonPlace extension = document.root()["extensions"][kExtension];
  if (!extension.exists()) extension.fail("is missing: this is no Croquis project");
  const auto version = extension["version"].integer(1, 2147483647);
  if (version > kVersion) {
    throw Error(ErrorCode::unsupported, "the project was written by a newer Croquis (version " +
                                            std::to_string(version) + " of the format, this one reads up to " +
                                            std::to_string(kVersion) + ")");
  }
  return extension;
}

}  // namespace

bool is_project(std::span<const std::byte> bytes) {
  if (!is_glb(bytes)) return false;
  const std::string_view json = parse_glb(bytes).json;
  if (json.find(kExtension) == std::string_view::npos) return false;
  const auto parsed = parse_json(json);
  const JsonPlace root(parsed.get(), "");
  return root.is_object() && root["extensions"].is_object() && root["extensions"][kExtension].exists();
}

Bytes write_project(const Project& project) {
  project.check();
  GltfEditor editor;
  std::vector<int> roots;
  std::vector<JointNodes> nodes;
  Json actors = Json::array(), strokes = Json::array(), poses = Json::array(), views = Json::array();
  for (const Actor& actor : project.actors) {
    nodes.emplace_back(*actor.character);
    const BuiltCharacter built = build_character(editor, *actor.character, actor.pose);
    roots.insert(roots.end(), built.scene_roots.begin(), built.scene_roots.end());
    actors.push_back(write_actor(editor, actor));
  }
  for (const PlacedStroke& stroke : project.strokes) {
    strokes.push_back(write_stroke(stroke, nodes[static_cast<std::size_t>(stroke.actor)]));
  }
  for (const NamedPose& pose : project.poses) {
    poses.push_back({{"name", pose.name},
                     {"actor", pose.actor},
                     {"pose", write_pose(pose.pose, nodes[static_cast<std::size_t>(pose.actor)])}});
  }
  for (const NamedView& view : project.views) {
    views.push_back({{"name", view.name}, {"camera", write_camera_place(view.camera)}});
  }
  Json scene = Json::object();
  if (!roots.empty()) scene["nodes"] = roots;
  editor.json()["scenes"] = Json::array({std::move(scene)});
  editor.json()["scene"] = 0;
  editor.json()["extensions"][kExtension] = {
      {"version", kVersion},       {"actors", std::move(actors)}, {"strokes", std::move(strokes)},
      {"poses", std::move(poses)}, {"views", std::move(views)},   {"settings", write_table_settings(project.settings)},
      {"next_id", project.next_id}};
  editor.use_extension(kExtension);
  return editor.finish("glb", "").bytes;
}

Project read_project(std::span<const std::byte> bytes, std::string_view file_name) {
  const GltfDocument document = open_gltf(bytes, file_name, nullptr);
  const JsonPlace extension = open_extension(document);
  Project project;
  std::vector<JointNodes> nodes;
  const JsonPlace actors = extension["actors"], strokes = extension["strokes"], poses = extension["poses"],
                  views = extension["views"];
  for (int i = 0; i < actors.size(); ++i) {
    project.actors.push_back(read_actor(document, actors[i]));
    nodes.emplace_back(*project.actors.back().character);
  }
  const auto start_of = [&](int actor) -> const Pose& {
    return project.actors[static_cast<std::size_t>(actor)].character->start;
  };
  for (int i = 0; i < strokes.size(); ++i) {
    const int actor = strokes[i]["actor"].index(actors.size(), "actor");
    project.strokes.push_back(read_stroke(strokes[i], nodes[static_cast<std::size_t>(actor)], start_of(actor)));
    project.strokes.back().actor = actor;
  }
  for (int i = 0; i < poses.size(); ++i) {
    const int actor = poses[i]["actor"].index(actors.size(), "actor");
    project.poses.push_back({poses[i]["name"].text(), actor,
                             read_pose(poses[i]["pose"], nodes[static_cast<std::size_t>(actor)], start_of(actor))});
  }
  for (int i = 0; i < views.size(); ++i) {
    project.views.push_back({views[i]["name"].text(), read_camera_place(views[i]["camera"])});
  }
  project.settings = read_table_settings(extension["settings"]);
  project.next_id = static_cast<int>(extension["next_id"].integer_or(1, 0, 2147483647));
  try {
    project.check();
  } catch (const Error& error) {
    throw_bad_file(extension.pointer(), error.what());
  }
  return project;
}

Character read_first_actor(std::span<const std::byte> bytes, std::string_view file_name) {
  const Project project = read_project(bytes, file_name);
  if (project.actors.empty()) throw_bad_file("/extensions/CROQUIS_project/actors", "the project has no character");
  Character character = *project.actors.front().character;
  character.start = project.actors.front().pose;
  return character;
}

}  // namespace croquis
