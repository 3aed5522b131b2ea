// SPDX-License-Identifier: MIT
#include "cli/commands/info_text.h"

#include <algorithm>
#include <vector>

#include "croquis/base/text.h"
#include "croquis/edit/view.h"
#include "croquis/rig/body_line.h"

namespace croquis::cli {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const Vec3& v) { return Json::array({v.x(), v.y(), v.z()}); }

Json joints_of(const Skeleton& skeleton) {
  Json joints = Json::array();
  for (int i = 0; i < skeleton.joint_count(); ++i) {
    const Joint& joint = skeleton.joint(i);
    joints.push_back({{"index", i},
                      {"name", joint.name},
                      {"parent", joint.parent},
                      {"helper", joint.helper},
                      {"rest_position", to_json(skeleton.rest_position(i))}});
  }
  return joints;
}

Json body_lines_of(const Character& character) {
  Json lines = Json::array();
  for (const BodyLine& line : standard_body_lines(character.skeleton, character.humanoid)) {
    Json joints = Json::array();
    for (const int joint : line.joints) joints.push_back(character.skeleton.reference(joint));
    lines.push_back({{"name", line.name}, {"joints", joints}});
  }
  return lines;
}

Json humanoid_of(const Character& character) {
  Json bones = Json::object();
  for (int i = 0; i < kHumanoidBoneCount; ++i) {
    const auto bone = static_cast<HumanoidBone>(i);
    const HumanoidMap::Entry& entry = character.humanoid.entries[static_cast<std::size_t>(i)];
    if (entry.joint < 0) continue;
    bones[std::string(to_string(bone))] = {{"joint", character.skeleton.reference(entry.joint)},
                                           {"confidence", entry.confidence}};
  }
  return bones;
}

Json meshes_of(const Character& character) {
  Json meshes = Json::array();
  for (const Part& part : character.parts) {
    Json mesh = {{"name", part.name},
                 {"vertices", part.mesh.vertex_count()},
                 {"triangles", part.mesh.triangle_count()},
                 {"shapes", part.shapes.size()}};
    if (part.skin) {
      mesh["skin_joints"] = part.skin->joints.size();
      mesh["influences"] = part.skin->influences;
    } else {
      mesh["carried_by"] = character.skeleton.reference(part.joint);
    }
    meshes.push_back(std::move(mesh));
  }
  return meshes;
}

Json clips_of(const Character& character) {
  Json clips = Json::array();
  for (const Clip& clip : character.clips) {
    clips.push_back(
        {{"name", clip.name}, {"seconds", clip.end_time() - clip.start_time()}, {"frames", clip.frame_count()}});
  }
  return clips;
}

Json licence_of(const Character& character) {
  if (!character.licence) return nullptr;
  const Licence& licence = *character.licence;
  Json json = {{"title", licence.title}, {"authors", licence.authors}, {"licence", licence.name}};
  for (const auto& [key, value] : licence.terms) json[key] = value;
  return json;
}

// --- the same as text ---

std::string word(const Json& json) {
  if (json.is_string()) return printable(json.get<std::string>(), 200);
  return json.is_number_float() ? format_double(json.get<double>(), 4) : json.dump();
}

std::string padded(std::string text, std::size_t width) {
  if (text.size() < width) text.resize(width, ' ');
  return text;
}

std::string counted(std::size_t count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

/// A tree, each joint below its parent.
std::string joints_text(const Json& joints) {
  std::vector<std::vector<std::size_t>> children(joints.size());
  for (std::size_t i = 1; i < joints.size(); ++i) children[joints[i]["parent"].get<std::size_t>()].push_back(i);
  std::string text = "\nJoints (" + std::to_string(joints.size()) + ")\n";
  struct Entry {
    std::size_t joint, depth;
  };
  for (std::vector<Entry> open{{0, 0}}; !open.empty();) {
    const Entry entry = open.back();
    open.pop_back();
    const Json& joint = joints[entry.joint];
    const std::size_t indent = std::min<std::size_t>(2 * entry.depth, 40);  // deep chains would run off the page
    text += "  " + padded("#" + std::to_string(entry.joint), 5) + std::string(indent, ' ') +
            (joint["name"].get<std::string>().empty() ? "(no name)" : word(joint["name"])) +
            (joint["helper"].get<bool>() ? "  (helper)" : "") + "\n";
    const std::vector<std::size_t>& below = children[entry.joint];
    for (auto child = below.rbegin(); child != below.rend(); ++child) open.push_back({*child, entry.depth + 1});
  }
  return text;
}

std::string body_lines_text(const Json& lines) {
  if (lines.empty()) return "\nBody lines: none, there is no bone to pose\n";
  std::string text = "\nBody lines (" + std::to_string(lines.size()) + ", the first is the default)\n";
  std::size_t width = 0;
  for (const Json& line : lines) width = std::max(width, word(line["name"]).size());
  for (const Json& line : lines) {
    text += "  " + padded(word(line["name"]), std::min<std::size_t>(width, 40) + 2) +
            counted(line["joints"].size(), "joint") + ": " + word(line["joints"].front()) + " ... " +
            word(line["joints"].back()) + "\n";
  }
  return text;
}

std::string humanoid_text(const Json& humanoid) {
  if (humanoid.empty()) return "\nHumanoid: no\n";
  std::string text = "\nHumanoid (" + std::to_string(humanoid.size()) + " of " + std::to_string(kHumanoidBoneCount) +
                     " bones; the number is how sure that is, from 0 to 1)\n";
  for (const auto& [bone, entry] : humanoid.items()) {
    text += "  " + padded(bone, 26) + padded(word(entry["joint"]), 30) + " " +
            format_double(entry["confidence"].get<double>(), 2) + "\n";
  }
  return text;
}

std::string meshes_text(const Json& meshes) {
  if (meshes.empty()) return "\nMeshes: none\n";
  std::string text = "\nMeshes (" + std::to_string(meshes.size()) + ")\n";
  for (const Json& mesh : meshes) {
    text += "  " + padded(mesh["name"].get<std::string>().empty() ? "(no name)" : word(mesh["name"]), 26) +
            word(mesh["vertices"]) + " vertices" + ", " + counted(mesh["triangles"].get<std::size_t>(), "triangle");
    if (const auto shapes = mesh["shapes"].get<std::size_t>()) text += ", " + counted(shapes, "shape");
    if (mesh.contains("influences")) {
      text += ", skinned to " + counted(mesh["skin_joints"].get<std::size_t>(), "joint") + ", up to " +
              word(mesh["influences"]) + " a vertex";
    } else {
      text += ", carried by " + word(mesh["carried_by"]);
    }
    text += "\n";
  }
  return text;
}

std::string clips_text(const Json& clips) {
  if (clips.empty()) return "\nClips: none\n";
  std::string text = "\nClips (" + std::to_string(clips.size()) + ")\n";
  for (const Json& clip : clips) {
    text += "  " + padded(clip["name"].get<std::string>().empty() ? "(no name)" : word(clip["name"]), 26) +
            word(clip["seconds"]) + " s, " + counted(clip["frames"].get<std::size_t>(), "frame") + "\n";
  }
  return text;
}

}  // namespace

nlohmann::ordered_json describe(const std::string& file, const Project& project) {
  const Character& character = *project.actors.front().character;
  const Box box = posed_box(character, character.start);
  Json json;
  json["file"] = file;
  json["format"] = character.source ? character.source->format : "built-in";
  json["name"] = character.name;
  json["size"] = box.isEmpty() ? Json(nullptr) : to_json(Vec3(box.sizes()));
  json["front"] = to_json(character.front);
  json["joints"] = joints_of(character.skeleton);
  json["body_lines"] = body_lines_of(character);
  json["humanoid"] = humanoid_of(character);
  json["meshes"] = meshes_of(character);
  json["clips"] = clips_of(character);
  json["licence"] = licence_of(character);
  json["oddities"] = character.oddities;
  json["characters"] = project.actors.size();
  json["strokes"] = project.strokes.size();
  json["poses"] = project.poses.size();
  json["views"] = project.views.size();
  return json;
}

std::string to_text(const nlohmann::ordered_json& d) {
  std::string text = printable(d["file"].get<std::string>(), 400) + ": " + word(d["format"]) + ", " +
                     (d["name"].get<std::string>().empty() ? "no name" : "\"" + word(d["name"]) + "\"") + "\n";
  if (!d["size"].is_null()) {
    text += "  size   " + word(d["size"][0]) + " x " + word(d["size"][1]) + " x " + word(d["size"][2]) + "\n";
  }
  text += "  faces  (" + word(d["front"][0]) + ", " + word(d["front"][1]) + ", " + word(d["front"][2]) + ")\n";
  if (d["strokes"].get<int>() + d["poses"].get<int>() + d["views"].get<int>() > 0 || d["characters"].get<int>() > 1) {
    text += "  a project of " + counted(d["characters"].get<std::size_t>(), "character") + ", " +
            counted(d["strokes"].get<std::size_t>(), "stroke") + ", " + counted(d["poses"].get<std::size_t>(), "pose") +
            ", " + counted(d["views"].get<std::size_t>(), "view") + "; this is the first character\n";
  }
  text += joints_text(d["joints"]) + body_lines_text(d["body_lines"]) + humanoid_text(d["humanoid"]) +
          meshes_text(d["meshes"]) + clips_text(d["clips"]);
  if (!d["licence"].is_null()) {
    text += "\nLicence\n";
    for (const auto& [key, value] : d["licence"].items())
      text += "  " + padded(printable(key), 26) + word(value) + "\n";
  }
  if (!d["oddities"].empty()) {
    text += "\nOdd about this file\n";
    for (const Json& oddity : d["oddities"]) text += "  - " + word(oddity) + "\n";
  }
  return text;
}

}  // namespace croquis::cli
