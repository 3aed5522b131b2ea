// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "croquis/picture/picture.h"

namespace croquis {

/// A vertex as the GPU reads it.
struct SceneVertex {
  Vec3f position;  ///< scene space
  Vec3f normal;    ///< scene space, unit
  Vec2f uv;
};

/// A run of triangles with one material.
struct SceneDraw {
  int first = 0;  ///< into Scene::triangles
  int count = 0;  ///< indices, three a triangle
  Vec4f base_color = Vec4f(0.8F, 0.8F, 0.8F, 1.0F);
  std::shared_ptr<const Bytes> image;
  bool double_sided = false;
  bool cut_out = false;
};

/// Everything that is to be drawn, as triangles in scene space: the world moved and scaled so that the figures fill the
/// unit sphere about the origin. A doll and a giant give the same numbers.
struct Scene {
  std::vector<SceneVertex> vertices;
  std::vector<std::uint32_t> triangles;
  std::vector<SceneDraw> draws;
  Vec3 centre = Vec3::Zero();  ///< world
  double radius = 1.0;         ///< world units per scene unit
  double floor = 0.0;          ///< height of the ground, scene space

  [[nodiscard]] Vec3 from_world(const Vec3& world) const { return (world - centre) / radius; }
  [[nodiscard]] Affine world_from_scene() const { return Eigen::Translation3d(centre) * Eigen::Scaling(radius); }
};

/// Poses and gathers the actors. Throws invalid_argument as PictureRenderer::render does.
[[nodiscard]] Scene build_scene(const std::vector<PictureActor>& actors, SkinningMethod skinning);

/// A body for a skeleton that has none, in model space: a tapered capsule along every bone between joints that are not
/// helpers, a ball for the head of a humanoid. Empty if there is no bone.
[[nodiscard]] Mesh build_bone_mesh(const Character& character, const Pose& pose);

/// Which side of a humanoid each joint is on: +1 left, -1 right, 0 middle; fingers, toes and unnamed joints as the
/// joint they hang on.
[[nodiscard]] std::vector<int> compute_sides(const Character& character);

}  // namespace croquis
