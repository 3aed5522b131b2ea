// SPDX-License-Identifier: MIT
// Sources: vrm1, vrma; sections "meta", "humanoid" and "VRMC_vrm_animation".
#include "croquis/io/vrm_write.h"

#include <array>
#include <cmath>
#include <utility>

#include <nlohmann/json.hpp>

#include "croquis/base/error.h"
#include "croquis/base/text.h"
#include "croquis/io/gltf_clip_write.h"

namespace croquis {
namespace {

constexpr std::array kRequiredBones = {
    HumanoidBone::hips,          HumanoidBone::spine,         HumanoidBone::head,          HumanoidBone::leftUpperLeg,
    HumanoidBone::leftLowerLeg,  HumanoidBone::leftFoot,      HumanoidBone::rightUpperLeg, HumanoidBone::rightLowerLeg,
    HumanoidBone::rightFoot,     HumanoidBone::leftUpperArm,  HumanoidBone::leftLowerArm,  HumanoidBone::leftHand,
    HumanoidBone::rightUpperArm, HumanoidBone::rightLowerArm, HumanoidBone::rightHand};

void require_humanoid(const Character& character, std::string_view what) {
  std::vector<std::string> missing;
  for (const HumanoidBone bone : kRequiredBones) {
    if (!character.humanoid.has(bone)) missing.emplace_back(to_string(bone));
  }
  if (missing.empty()) return;
  throw Error(ErrorCode::unsupported,
              std::string(what) + " needs a humanoid: '" + printable(character.name) + "' " +
                  (missing.size() == kRequiredBones.size() ? "is none" : "lacks " + join(missing, ", ")));
}

Json make_human_bones(const HumanoidMap& humanoid, const std::vector<int>& node_of_joint) {
  Json bones = Json::object();
  for (int i = 0; i < kHumanoidBoneCount; ++i) {
    const auto bone = static_cast<HumanoidBone>(i);
    if (!humanoid.has(bone)) continue;
    const int node = node_of_joint[static_cast<std::size_t>(humanoid.joint(bone))];
    if (node >= 0) bones[std::string(to_string(bone))] = {{"node", node}};
  }
  return bones;
}

Json make_meta(const Character& character) {
  const Licence licence = character.licence.value_or(Licence());
  Json meta = Json::object();
  meta["name"] = licence.title.empty() ? character.name.empty() ? "character" : character.name : licence.title;
  meta["authors"] = Json::array({licence.authors.empty() ? "unknown" : licence.authors});
  // The one licence that VRM 1.0 knows; what else the character's own licence says stands beside it.
  meta["licenseUrl"] = "https://vrm.dev/licenses/1.0/";
  if (!licence.name.empty()) {
    const bool is_url = licence.name.starts_with("http");
    meta[is_url ? "otherLicenseUrl" : "copyrightInformation"] = licence.name;
  }
  return meta;
}

/// The poses of an animation: at each time the whole body.
struct Frames {
  std::string name;
  std::vector<double> times;
  std::vector<Pose> poses;
};

Frames frames_of(const Clip& clip, const Pose& base) {
  Frames frames{.name = clip.name};
  const double shift = std::max(0.0, -clip.start_time());
  for (int i = 0; i < clip.frame_count(); ++i) {
    frames.times.push_back(clip.frame_time(i) + shift);
    frames.poses.push_back(sample_pose(clip, clip.frame_time(i), base));
  }
  return frames;
}

/// The same body in terms of its humanoid bones alone: every other joint stays at rest, and each bone takes the
/// orientation that it had in the model; the hips take their place too.
Pose reduce_to_humanoid(const Character& character, const Pose& pose) {
  const Skeleton& skeleton = character.skeleton;
  const std::vector<Affine> model = compute_model_transforms(skeleton, pose);
  Pose reduced = rest_pose(skeleton);
  std::vector<Affine> reduced_model(model.size());
  const int hips = character.humanoid.joint(HumanoidBone::hips);
  for (int i = 0; i < skeleton.joint_count(); ++i) {
    const auto index = static_cast<std::size_t>(i);
    const int parent = skeleton.parent(i);
    const Affine above = parent < 0 ? Affine::Identity() : reduced_model[static_cast<std::size_t>(parent)];
    Transform& local = reduced.local[index];
    if (character.humanoid.bone_of(i)) {
      local.rotation = rotation_of(above).inverse() * rotation_of(model[index]);
      if (i == hips) local.translation = above.inverse() * Vec3(model[index].translation());
    }
    reduced_model[index] = above * local.to_affine();
  }
  return reduced;
}

Clip to_humanoid_clip(const Character& character, const Frames& frames) {
  Clip clip{.name = frames.name};
  std::vector<Pose> poses;
  for (const Pose& pose : frames.poses) poses.push_back(reduce_to_humanoid(character, pose));
  for (int i = 0; i < kHumanoidBoneCount; ++i) {
    const auto bone = static_cast<HumanoidBone>(i);
    if (!character.humanoid.has(bone) || bone == HumanoidBone::leftEye || bone == HumanoidBone::rightEye) continue;
    const int joint = character.humanoid.joint(bone);
    Curve turn{.target = CurveTarget::rotation, .joint = joint, .width = 4, .times = frames.times};
    Curve move{.target = CurveTarget::translation, .joint = joint, .width = 3, .times = frames.times};
    for (const Pose& pose : poses) {
      const Transform& local = pose.local[static_cast<std::size_t>(joint)];
      for (int k = 0; k < 4; ++k) turn.values.push_back(local.rotation.coeffs()[k]);
      for (int k = 0; k < 3; ++k) move.values.push_back(local.translation[k]);
    }
    clip.curves.push_back(std::move(turn));
    if (bone == HumanoidBone::hips) clip.curves.push_back(std::move(move));
  }
  return clip;
}

/// Nodes for the humanoid's joints and all above them, at rest; -1 for the other joints.
std::vector<int> add_nodes(GltfEditor& editor, const Character& character) {
  const Skeleton& skeleton = character.skeleton;
  std::vector<bool> wanted(static_cast<std::size_t>(skeleton.joint_count()), false);
  for (int i = skeleton.joint_count() - 1; i >= 0; --i) {
    const auto index = static_cast<std::size_t>(i);
    wanted[index] = wanted[index] || character.humanoid.bone_of(i).has_value();
    if (wanted[index] && skeleton.parent(i) >= 0) wanted[static_cast<std::size_t>(skeleton.parent(i))] = true;
  }
  std::vector<int> node_of_joint(wanted.size(), -1);
  for (int i = 0; i < skeleton.joint_count(); ++i) {
    const auto index = static_cast<std::size_t>(i);
    if (!wanted[index]) continue;
    const Transform& rest = skeleton.joint(i).rest;
    Json node = Json::object();
    if (!skeleton.name(i).empty()) node["name"] = skeleton.name(i);
    node["translation"] = {rest.translation.x(), rest.translation.y(), rest.translation.z()};
    node["rotation"] = {rest.rotation.x(), rest.rotation.y(), rest.rotation.z(), rest.rotation.w()};
    if (is_moved(rest.scale, Vec3::Ones())) node["scale"] = {rest.scale.x(), rest.scale.y(), rest.scale.z()};
    node_of_joint[index] = editor.append("nodes", node);
    const int parent = skeleton.parent(i);
    if (parent < 0) continue;
    Json& above = editor.json()["nodes"][static_cast<std::size_t>(node_of_joint[static_cast<std::size_t>(parent)])];
    if (!above.contains("children")) above["children"] = Json::array();
    above["children"].push_back(node_of_joint[index]);
  }
  return node_of_joint;
}

/// The root of the scene; one more node above it where the body does not face +Z as VRM 1.0 wants.
int add_root(GltfEditor& editor, int root, const Vec3& front) {
  const double turn = -std::atan2(front.x(), front.z());
  if (std::abs(turn) < 1e-6) return root;
  const Quat rotation(Eigen::AngleAxisd(turn, Vec3::UnitY()));
  return editor.append("nodes", {{"name", "front"},
                                 {"rotation", {rotation.x(), rotation.y(), rotation.z(), rotation.w()}},
                                 {"children", Json::array({root})}});
}

}  // namespace

void add_vrm_extension(GltfEditor& editor, const Character& character, const std::vector<int>& node_of_joint) {
  Json& json = editor.json();
  if (json.contains("extensions") && (json["extensions"].contains("VRM") || json["extensions"].contains("VRMC_vrm")))
    return;
  require_humanoid(character, "A VRM");
  json["extensions"]["VRMC_vrm"] = {
      {"specVersion", "1.0"},
      {"meta", make_meta(character)},
      {"humanoid", {{"humanBones", make_human_bones(character.humanoid, node_of_joint)}}}};
  editor.use_extension("VRMC_vrm");
}

WrittenFile write_vrma(const Character& character, const Pose& pose) {
  require_humanoid(character, "A VRM animation");
  std::vector<Frames> animations;
  bool moved = false;
  for (std::size_t i = 0; i < pose.local.size(); ++i)
    moved = moved || is_changed(character.start.local[i], pose.local[i]);
  for (const Clip& clip : character.clips) {
    if (!moved && clip.frame_count() > 0) animations.push_back(frames_of(clip, character.start));
  }
  if (animations.empty()) animations.push_back({"pose", {0.0}, {pose}});

  GltfEditor editor;
  const std::vector<int> node_of_joint = add_nodes(editor, character);
  const int root = add_root(editor, node_of_joint[0], character.front);
  editor.json()["scenes"] = Json::array({Json::object({{"nodes", Json::array({root})}})});
  editor.json()["scene"] = 0;
  ClipWriter writer(editor, node_of_joint, {});
  for (const Frames& frames : animations) writer.add(to_humanoid_clip(character, frames));
  editor.json()["extensions"]["VRMC_vrm_animation"] = {
      {"specVersion", "1.0"}, {"humanoid", {{"humanBones", make_human_bones(character.humanoid, node_of_joint)}}}};
  editor.use_extension("VRMC_vrm_animation");
  return editor.finish("glb", "");
}

}  // namespace croquis
