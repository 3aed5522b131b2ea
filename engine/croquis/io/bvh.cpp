// SPDX-License-Identifier: MIT
// Source: bvh.
#include "croquis/io/bvh.h"

#include <algorithm>
#include <cmath>

#include "croquis/base/error.h"
#include "croquis/base/text.h"
#include "croquis/io/bvh_motion.h"
#include "croquis/io/unique_names.h"

namespace croquis {
namespace {

int root_count(const BvhText& text) {
  return static_cast<int>(
      std::count_if(text.nodes.begin(), text.nodes.end(), [](const BvhNode& n) { return n.parent < 0; }));
}

Skeleton make_skeleton(const BvhText& text) {
  UniqueNames names;
  for (const BvhNode& node : text.nodes) names.take(node.name);
  const int helpers = root_count(text) > 1 ? 1 : 0;
  std::vector<Joint> joints;
  joints.reserve(text.nodes.size() + 1);
  if (helpers > 0) joints.push_back({.name = "", .helper = true});
  for (const BvhNode& node : text.nodes) {
    Joint joint;
    joint.parent = node.parent < 0 ? helpers - 1 : node.parent + helpers;
    if (node.end_site) {
      joint.name = names.next(joints[static_cast<std::size_t>(joint.parent)].name + "_end", "");
    } else {
      joint.name = node.name;
    }
    joint.rest.translation = node.offset;
    joints.push_back(std::move(joint));
  }
  return Skeleton(std::move(joints));
}

std::vector<double> frame_times(const BvhText& text, double frame_time) {
  std::vector<double> times(static_cast<std::size_t>(text.frame_count));
  for (int frame = 0; frame < text.frame_count; ++frame) times[static_cast<std::size_t>(frame)] = frame * frame_time;
  return times;
}

bool has_any(const BvhNode& node, BvhChannel first) {
  return node.has(first) || node.has(first + 1) || node.has(first + 2);
}

Clip make_clip(const BvhText& text, double frame_time, const std::string& name) {
  Clip clip;
  clip.name = name;
  const bool added = bvh_positions_are_added(text);
  const int helpers = root_count(text) > 1 ? 1 : 0;
  const std::vector<double> times = frame_times(text, frame_time);
  for (int i = 0; i < std::ssize(text.nodes); ++i) {
    const BvhNode& node = text.nodes[static_cast<std::size_t>(i)];
    Curve move{.target = CurveTarget::translation, .joint = i + helpers, .width = 3, .times = times};
    Curve turn{.target = CurveTarget::rotation, .joint = i + helpers, .width = 4, .times = times};
    Quat last = Quat::Identity();
    for (int frame = 0; frame < text.frame_count; ++frame) {
      const Transform local = bvh_local_transform(node, text.row(frame), added);
      // The nearer of q and -q, for programs that interpolate the numbers.
      if (local.rotation.dot(last) < 0.0)
        last.coeffs() = -local.rotation.coeffs();
      else
        last = local.rotation;
      move.values.insert(move.values.end(), local.translation.data(), local.translation.data() + 3);
      turn.values.insert(turn.values.end(), last.coeffs().data(), last.coeffs().data() + 4);
    }
    if (has_any(node, 0)) clip.curves.push_back(std::move(move));
    if (has_any(node, 3)) clip.curves.push_back(std::move(turn));
  }
  return clip;
}

std::string stem(std::string_view file_name) {
  const std::string_view base = file_name.substr(file_name.find_last_of("/\\") + 1);
  return std::string(base.substr(0, base.rfind('.')));
}

/// A BVH states no unit; the size of a grown human (height, or span of the arms) tells which one was meant.
std::string unit_remark(const Character& character) {
  if (!character.humanoid.is_humanoid()) return {};
  Box box;
  for (int i = 0; i < character.skeleton.joint_count(); ++i) box.extend(character.skeleton.rest_position(i));
  const double size = box.sizes().maxCoeff();
  const char* const unit = size >= 1.2 && size < 2.5   ? ""
                           : size >= 120 && size < 250 ? "centimetres"
                           : size >= 45 && size < 100  ? "inches"
                                                       : "a unit of its own";
  if (*unit == '\0') return {};
  return "a BVH states no unit; a size of " + format_double(size, 4) + " looks like " + unit + " (lengths are kept)";
}

}  // namespace

Character read_bvh(std::span<const std::byte> bytes, std::string_view file_name) {
  BvhText text = parse_bvh(bytes);
  Skeleton skeleton = make_skeleton(text);
  const std::string name = to_utf8(stem(file_name));
  Character character{.name = name, .skeleton = skeleton, .start = rest_pose(skeleton)};
  character.oddities = std::move(text.oddities);
  if (root_count(text) > 1) {
    character.oddities.push_back("the file has " + std::to_string(root_count(text)) +
                                 " ROOTs; they hang under a helper");
  }
  if (text.frame_count > 0) {
    double frame_time = text.frame_time;
    if (frame_time < 1e-6 || frame_time > 1e6) {
      frame_time = 1.0 / 30.0;
      character.oddities.push_back("a frame time of " + text.frame_time_text + " seconds; taken as 1/30");
    }
    if (bvh_positions_are_added(text)) {
      character.oddities.emplace_back("the positions of the joints lie about zero; they are added to the OFFSETs");
    }
    Clip clip = make_clip(text, frame_time, name);
    if (!clip.curves.empty()) character.clips.push_back(std::move(clip));
  }
  character.humanoid = recognise_humanoid(skeleton);
  std::vector<Vec3> positions;
  for (int i = 0; i < skeleton.joint_count(); ++i) positions.push_back(skeleton.rest_position(i));
  character.front = compute_facing(character.humanoid, positions);
  if (const std::string remark = unit_remark(character); !remark.empty()) character.oddities.push_back(remark);
  character.source = std::make_shared<const SourceFile>(
      SourceFile{.format = "bvh", .name = std::string(file_name), .bytes = Bytes(bytes.begin(), bytes.end())});
  character.check();
  return character;
}

}  // namespace croquis
