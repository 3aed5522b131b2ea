// SPDX-License-Identifier: MIT
#include "croquis/io/project_json.h"

#include <numeric>
#include <utility>

#include <nlohmann/json.hpp>

#include "croquis/base/error.h"
#include "croquis/io/camera_json.h"

namespace croquis {
namespace {

Json write_joints(const std::vector<int>& joints, const JointNodes& nodes) {
  Json json = Json::array();
  for (const int joint : joints) json.push_back(nodes.node(joint));
  return json;
}

std::vector<int> read_joints(const JsonPlace& place, const JointNodes& nodes) {
  std::vector<int> joints;
  for (int i = 0; i < place.size(); ++i) joints.push_back(nodes.joint(place[i]));
  return joints;
}

Quat read_rotation(const JsonPlace& place) {
  const Vec4 xyzw(place.numbers(4).data());
  if (!(std::abs(xyzw.norm() - 1.0) < 1e-3)) place.fail("wanted a unit quaternion");
  return Quat(Vec4(xyzw.normalized()));
}

Json write_settings(const StrokeSettings& settings, const JointNodes& nodes) {
  return {{"method", settings.method},
          {"body_line", settings.body_line},
          {"joints", write_joints(settings.joints, nodes)},
          {"plane", settings.plane},
          {"root", settings.root},
          {"direction", settings.direction},
          {"move", settings.move},
          {"length", settings.length},
          {"exaggerate", settings.exaggerate},
          {"weight", settings.weight},
          {"alternative", settings.alternative},
          {"depth", settings.depth},
          {"live", settings.live}};
}

StrokeSettings read_settings(const JsonPlace& place, const JointNodes& nodes) {
  StrokeSettings settings;
  // What is not said is what a file meant that was written before the line solver was the default.
  settings.method = place["method"].text_or("rotation");
  settings.body_line = place["body_line"].text_or("");
  settings.joints = read_joints(place["joints"], nodes);
  settings.plane = place["plane"].text_or(settings.plane);
  settings.root = place["root"].text_or("lock");
  settings.direction = place["direction"].text_or(settings.direction);
  settings.move = place["move"].text_or(settings.move);
  settings.length = place["length"].text_or(settings.length);
  settings.exaggerate = place["exaggerate"].number_or(settings.exaggerate);
  settings.weight = place["weight"].number_or(settings.weight);
  settings.alternative = static_cast<int>(place["alternative"].integer_or(0, 0, 1000000));
  settings.depth = static_cast<int>(place["depth"].integer_or(0, 0, 1000000));
  settings.live = place["live"].boolean_or(false);
  return settings;
}

}  // namespace

JointNodes::JointNodes(const Character& character) : nodes_(character.source_nodes) {
  if (nodes_.empty()) {
    nodes_.resize(static_cast<std::size_t>(character.skeleton.joint_count()));
    std::iota(nodes_.begin(), nodes_.end(), 0);
  }
  for (std::size_t joint = 0; joint < nodes_.size(); ++joint) joint_of_node_[nodes_[joint]] = static_cast<int>(joint);
}

int JointNodes::joint(const JsonPlace& node) const {
  const auto found = joint_of_node_.find(static_cast<int>(node.integer(-1, 2147483647)));
  if (found == joint_of_node_.end()) node.fail("no joint of the character is that node");
  return found->second;
}

Json write_pose(const Pose& pose, const JointNodes& nodes) {
  Json json = Json::array();
  for (std::size_t joint = 0; joint < pose.local.size(); ++joint) {
    const Vec3 &t = pose.local[joint].translation, &s = pose.local[joint].scale;
    const Quat& q = pose.local[joint].rotation;
    json.push_back({{"node", nodes.node(static_cast<int>(joint))},
                    {"translation", {t.x(), t.y(), t.z()}},
                    {"rotation", {q.x(), q.y(), q.z(), q.w()}},
                    {"scale", {s.x(), s.y(), s.z()}}});
  }
  return json;
}

Pose read_pose(const JsonPlace& place, const JointNodes& nodes, const Pose& start) {
  Pose pose = start;
  for (int i = 0; i < place.size(); ++i) {
    const JsonPlace entry = place[i];
    Transform& local = pose.local[static_cast<std::size_t>(nodes.joint(entry["node"]))];
    local.translation = Vec3(entry["translation"].numbers(3).data());
    local.rotation = read_rotation(entry["rotation"]);
    local.scale = Vec3(entry["scale"].numbers(3).data());
  }
  return pose;
}

Json write_pin(const Pin& pin, const JointNodes& nodes) {
  Json json = {{"node", nodes.node(pin.joint)}, {"position", {pin.position.x(), pin.position.y(), pin.position.z()}}};
  if (pin.rotation) json["rotation"] = {pin.rotation->x(), pin.rotation->y(), pin.rotation->z(), pin.rotation->w()};
  return json;
}

Pin read_pin(const JsonPlace& place, const JointNodes& nodes) {
  Pin pin;
  pin.joint = nodes.joint(place["node"]);
  pin.position = Vec3(place["position"].numbers(3).data());
  if (place["rotation"].exists()) pin.rotation = read_rotation(place["rotation"]);
  return pin;
}

Json write_stroke(const PlacedStroke& placed, const JointNodes& nodes) {
  Json samples = Json::array();
  for (const StrokeSample& sample : placed.stroke.samples) {
    samples.push_back({sample.position.x(), sample.position.y(), sample.time, sample.pressure});
  }
  Json json = {{"name", placed.stroke.name},
               {"actor", placed.actor},
               {"id", placed.id},
               {"hidden", placed.hidden},
               {"raw_pen", placed.stroke.raw_pen},
               {"samples", std::move(samples)},
               {"camera", write_camera_place(placed.camera)},
               {"settings", write_settings(placed.settings, nodes)},
               {"line", {{"name", placed.line.name}, {"joints", write_joints(placed.line.joints, nodes)}}}};
  if (placed.before) json["before"] = write_pose(*placed.before, nodes);
  return json;
}

PlacedStroke read_stroke(const JsonPlace& place, const JointNodes& nodes, const Pose& start) {
  PlacedStroke placed;
  placed.stroke.name = place["name"].text_or("");
  placed.stroke.raw_pen = place["raw_pen"].boolean_or(false);
  const JsonPlace samples = place["samples"];
  for (int i = 0; i < samples.size(); ++i) {
    const std::vector<double> numbers = samples[i].numbers(4);
    placed.stroke.samples.push_back({Vec2(numbers[0], numbers[1]), numbers[2], numbers[3]});
  }
  placed.id = static_cast<int>(place["id"].integer_or(0, 0, 2147483647));
  placed.hidden = place["hidden"].boolean_or(false);
  placed.camera = read_camera_place(place["camera"]);
  placed.settings = read_settings(place["settings"], nodes);
  if (place["before"].exists()) placed.before = read_pose(place["before"], nodes, start);
  placed.line.name = place["line"]["name"].text_or("");
  placed.line.joints = read_joints(place["line"]["joints"], nodes);
  return placed;
}

Json write_table_settings(const TableSettings& settings) {
  return {
      {"limits", settings.limits}, {"floor", settings.floor}, {"balance", settings.balance}, {"root", settings.root}};
}

TableSettings read_table_settings(const JsonPlace& place) {
  TableSettings settings;
  settings.limits = place["limits"].text_or(settings.limits);
  settings.floor = place["floor"].boolean_or(settings.floor);
  settings.balance = place["balance"].boolean_or(settings.balance);
  settings.root = place["root"].text_or(settings.root);
  return settings;
}

Json write_camera_place(const Camera& camera) { return Json::parse(write_camera(camera)); }

Camera read_camera_place(const JsonPlace& place) {
  if (!place.exists()) place.fail("is missing");
  const std::string text = place.json().dump();
  try {
    return read_camera(std::as_bytes(std::span(text)));
  } catch (const Error& error) {
    place.fail(error.what());
  }
}

}  // namespace croquis
