// SPDX-License-Identifier: MIT
#include "croquis/edit/pose_text.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <nlohmann/json.hpp>

#include "croquis/base/error.h"
#include "croquis/base/text.h"
#include "croquis/body/pose_shelf.h"
#include "croquis/posing/pose_edit.h"

namespace croquis {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const Quat& q) { return Json::array({q.x(), q.y(), q.z(), q.w()}); }

std::vector<double> read_numbers(const Json& value, std::size_t count, const std::string& place) {
  if (!value.is_array() || value.size() != count) throw_bad_file(place, "wanted " + std::to_string(count) + " numbers");
  std::vector<double> numbers;
  for (const Json& element : value) {
    if (!element.is_number() || !std::isfinite(element.get<double>())) throw_bad_file(place, "wanted finite numbers");
    numbers.push_back(element.get<double>());
  }
  return numbers;
}

Quat read_rotation(const Json& value, const std::string& place) {
  const std::vector<double> v = read_numbers(value, 4, place);
  const Quat q(v[3], v[0], v[1], v[2]);
  if (q.norm() < 1e-6) throw_bad_file(place, "wanted a quaternion that is not zero");
  return q.normalized();
}

double lowest_joint(const Skeleton& skeleton, const Pose& pose) {
  const std::vector<Vec3> positions = compute_positions(skeleton, pose);
  double lowest = positions.back().y();
  for (int i = 0; i < skeleton.joint_count(); ++i) {
    if (!skeleton.joint(i).helper) lowest = std::min(lowest, positions[static_cast<std::size_t>(i)].y());
  }
  return lowest;
}

/// The pose with the hips moved up or down until the lowest joint is as low as at rest.
Pose stand_on_ground(const Character& character, const Pose& pose) {
  const Skeleton& skeleton = character.skeleton;
  const int hips = character.humanoid.joint(HumanoidBone::hips);
  const double lift = lowest_joint(skeleton, rest_pose(skeleton)) - lowest_joint(skeleton, pose);
  const Vec3 place = compute_positions(skeleton, pose)[static_cast<std::size_t>(hips)] + lift * Vec3::UnitY();
  return place_joint(skeleton, pose, hips, place);
}

Pose take_humanoid_pose(const Character& character, HumanoidPose goal, bool grounded, const Pose& base) {
  if (grounded) goal.hips_offset = Vec3::Zero();
  Pose pose = apply_humanoid_pose(character.skeleton, character.humanoid, character.front, goal, base);
  return grounded ? stand_on_ground(character, pose) : pose;
}

Pose read_humanoid(const Json& json, const Character& character, const Pose& base) {
  if (!character.humanoid.has(HumanoidBone::hips)) {
    throw_invalid_argument("this pose is for a humanoid, and " + printable(character.name) + " is none");
  }
  HumanoidPose goal;
  for (const auto& [name, value] : json.at("bones").items()) {
    const std::optional<HumanoidBone> bone = parse_humanoid_bone(name);
    if (!bone) throw_bad_file("/bones/" + printable(name), "is no humanoid bone");
    goal.turns[static_cast<std::size_t>(*bone)] = read_rotation(value, "/bones/" + name);
  }
  if (json.contains("hips")) {
    const std::vector<double> v = read_numbers(json["hips"], 3, "/hips");
    goal.hips_offset = Vec3(v[0], v[1], v[2]);
  }
  const bool grounded = json.contains("grounded") && json["grounded"] == true;
  return take_humanoid_pose(character, std::move(goal), grounded, base);
}

}  // namespace

std::string write_pose_text(const HumanoidPose& pose, bool grounded) {
  Json json{{"bones", Json::object()}};
  for (int i = 0; i < kHumanoidBoneCount; ++i) {
    const std::optional<Quat>& turn = pose.turns[static_cast<std::size_t>(i)];
    if (turn) json["bones"][std::string(to_string(static_cast<HumanoidBone>(i)))] = to_json(*turn);
  }
  if (pose.hips_offset) json["hips"] = {pose.hips_offset->x(), pose.hips_offset->y(), pose.hips_offset->z()};
  if (grounded) json["grounded"] = true;
  return json.dump();
}

std::string write_pose_text(const Character& character, const Pose& pose) {
  if (character.humanoid.is_humanoid()) {
    const HumanoidPose humanoid = extract_humanoid_pose(character.skeleton, character.humanoid, character.front, pose);
    return write_pose_text(humanoid, false);
  }
  Json json{{"joints", Json::object()}};
  for (int i = 0; i < character.skeleton.joint_count(); ++i) {
    json["joints"][character.skeleton.reference(i)] = to_json(pose.local[static_cast<std::size_t>(i)].rotation);
  }
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Pose read_pose_text(std::string_view text, const Character& character, const Pose& base) {
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object()) throw_bad_file("pose", "wanted a JSON object");
  if (json.contains("bones") && json["bones"].is_object()) return read_humanoid(json, character, base);
  if (!json.contains("joints") || !json["joints"].is_object()) throw_bad_file("pose", "wanted \"bones\" or \"joints\"");
  Pose pose = base;
  int fitting = 0;
  for (int i = 0; i < character.skeleton.joint_count(); ++i) {
    const std::string name = character.skeleton.reference(i);
    if (!json["joints"].contains(name)) continue;
    pose.local[static_cast<std::size_t>(i)].rotation =
        read_rotation(json["joints"][name], "/joints/" + printable(name));
    ++fitting;
  }
  if (fitting == 0) throw_invalid_argument("no joint of this pose is a joint of " + printable(character.name));
  return pose;
}

std::optional<Pose> find_shelf_pose(const Character& character, std::string_view name) {
  if (!character.humanoid.has(HumanoidBone::hips)) return std::nullopt;
  const auto plain = [](std::string_view text) {
    std::string word = to_lower(text);
    std::replace(word.begin(), word.end(), '-', ' ');
    return word;
  };
  for (const ShelfPose& pose : make_pose_shelf()) {
    if (pose.kind != ShelfPose::Kind::body || plain(pose.name) != plain(name)) continue;
    return take_humanoid_pose(character, pose.pose, pose.grounded, rest_pose(character.skeleton));
  }
  return std::nullopt;
}

}  // namespace croquis
