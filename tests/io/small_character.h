// SPDX-License-Identifier: MIT
// A triangle on two joints, small enough to be reckoned by hand, and its glTF to be broken on purpose.
#pragma once

#include <functional>
#include <string>

#include <nlohmann/json.hpp>

#include "croquis/io/character_file.h"
#include "croquis/io/glb_container.h"

namespace croquis {

/// Joints "root" at the origin and "tip" one above it; a triangle whose third corner hangs half on each; one shape,
/// one clip that turns the tip.
inline Character small_character() {
  Character character{
      .name = "small",
      .skeleton = Skeleton({{.name = "root"}, {.name = "tip", .parent = 0, .rest = {.translation = Vec3(0, 1, 0)}}})};
  character.start = rest_pose(character.skeleton);
  Part part;
  part.name = "flag";
  part.mesh.positions = {Vec3f(0, 0, 0), Vec3f(1, 0, 0), Vec3f(0, 2, 0)};
  part.mesh.normals.assign(3, Vec3f::UnitZ());
  part.mesh.uvs = {Vec2f(0, 1), Vec2f(1, 1), Vec2f(0, 0)};
  part.mesh.triangles = {0, 1, 2};
  part.shapes = {{.name = "wide", .positions = {Vec3f::Zero(), Vec3f(1, 0, 0), Vec3f::Zero()}}};
  part.shape_weights = {0.25F};
  Skin skin;
  skin.joints = {0, 1};
  skin.inverse_bind = {Affine::Identity(), Affine(Eigen::Translation3d(0, -1, 0))};
  skin.joint_indices = {0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0};
  skin.weights = {1, 0, 0, 0, 1, 0, 0, 0, 0.5F, 0.5F, 0, 0};
  part.skin = skin;
  character.parts = {part};
  Curve turn{.joint = 1, .times = {0.0, 1.0}, .values = {0, 0, 0, 1, 1, 0, 0, 0}};
  character.clips = {{.name = "turn", .curves = {turn}}};
  return character;
}

/// The GLB of small_character(), its JSON changed by `change` first.
inline Bytes small_glb(const std::function<void(nlohmann::ordered_json&)>& change = nullptr) {
  const Character character = small_character();
  const Bytes bytes = write_character(character, character.start, "glb", "small.glb").bytes;
  const GlbContainer glb = parse_glb(bytes);
  auto json = nlohmann::ordered_json::parse(glb.json);
  if (change) change(json);
  return make_glb(json.dump(), glb.binary);
}

}  // namespace croquis
