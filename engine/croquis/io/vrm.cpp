// SPDX-License-Identifier: MIT
// Sources: vrm0, vrm1, vrma; sections "humanoid" and "meta".
#include "croquis/io/vrm.h"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "croquis/base/text.h"

namespace croquis {
namespace {

/// The thumb's three bones had other names in VRM 0.x: its Proximal is the Metacarpal of 1.0, and so on.
std::string bone_name_of_vrm1(std::string name) {
  for (const char* side : {"left", "right"}) {
    if (name == std::string(side) + "ThumbProximal") return std::string(side) + "ThumbMetacarpal";
    if (name == std::string(side) + "ThumbIntermediate") return std::string(side) + "ThumbProximal";
  }
  return name;
}

void add_bone(VrmInfo& info, const std::string& name, int node, std::vector<std::string>& oddities) {
  const auto bone = parse_humanoid_bone(name);
  if (!bone) {
    oddities.push_back("The file names a humanoid bone '" + printable(name) + "', which VRM does not have.");
    return;
  }
  const auto same = [&](const auto& other) { return other.first == *bone || other.second == node; };
  if (std::any_of(info.bones.begin(), info.bones.end(), same)) {
    oddities.push_back("The humanoid bone '" + printable(name) + "' or its node stands in the file twice.");
    return;
  }
  info.bones.emplace_back(*bone, node);
}

void read_bones_of_vrm0(const JsonPlace& vrm, int nodes, VrmInfo& info, std::vector<std::string>& oddities) {
  const JsonPlace bones = vrm["humanoid"]["humanBones"];
  for (int i = 0; i < bones.size(); ++i) {
    const JsonPlace node = bones[i]["node"];
    if (node.integer_or(-1, -1, 2147483647) < 0) continue;  // some exporters write -1 for "none"
    add_bone(info, bone_name_of_vrm1(bones[i]["bone"].text()), node.index(nodes, "node"), oddities);
  }
}

void read_bones_of_vrm1(const JsonPlace& vrm, int nodes, VrmInfo& info, std::vector<std::string>& oddities) {
  const JsonPlace bones = vrm["humanoid"]["humanBones"];
  for (const std::string& name : bones.keys()) {
    const JsonPlace node = bones[name]["node"];
    if (node.exists()) add_bone(info, name, node.index(nodes, "node"), oddities);
  }
}

/// A text, number or bool as words; texts of an array joined; empty for the rest.
std::string words_of(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_boolean()) return value.get<bool>() ? "true" : "false";
  if (value.is_number()) return format_double(value.get<double>(), 17);
  std::vector<std::string> parts;
  if (value.is_array()) {
    for (const Json& part : value) {
      if (part.is_string()) parts.push_back(part.get<std::string>());
    }
  }
  return join(parts, ", ");
}

Licence read_meta(const JsonPlace& meta, VrmKind kind) {
  Licence licence;
  for (const std::string& key : meta.keys()) {
    std::string words = words_of(meta[key].json());
    if (words.empty()) continue;
    if (key == (kind == VrmKind::vrm0 ? "title" : "name")) {
      licence.title = std::move(words);
    } else if (key == (kind == VrmKind::vrm0 ? "author" : "authors")) {
      licence.authors = std::move(words);
    } else if (key == (kind == VrmKind::vrm0 ? "licenseName" : "licenseUrl")) {
      licence.name = std::move(words);
    } else if (key != "texture" && key != "thumbnailImage") {
      licence.terms[key] = std::move(words);
    }
  }
  return licence;
}

}  // namespace

VrmInfo read_vrm(const GltfDocument& document, std::vector<std::string>& oddities) {
  VrmInfo info;
  const int nodes = document.count("nodes");
  const JsonPlace extensions = document.root()["extensions"];
  const JsonPlace vrm0 = extensions["VRM"], vrm1 = extensions["VRMC_vrm"], animation = extensions["VRMC_vrm_animation"];
  if (vrm1.exists()) {
    info.kind = VrmKind::vrm1;
    read_bones_of_vrm1(vrm1, nodes, info, oddities);
    if (vrm1["meta"].is_object()) info.licence = read_meta(vrm1["meta"], info.kind);
  } else if (vrm0.exists()) {
    info.kind = VrmKind::vrm0;
    read_bones_of_vrm0(vrm0, nodes, info, oddities);
    if (vrm0["meta"].is_object()) info.licence = read_meta(vrm0["meta"], info.kind);
  } else if (animation.exists()) {
    info.kind = VrmKind::animation;
    read_bones_of_vrm1(animation, nodes, info, oddities);
  }
  const JsonPlace copyright = document.root()["asset"]["copyright"];
  if (!info.licence && copyright.is_text()) info.licence = Licence{.name = copyright.text()};
  return info;
}

}  // namespace croquis
