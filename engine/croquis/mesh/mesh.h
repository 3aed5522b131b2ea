// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "croquis/math/types.h"

namespace croquis {

/// A triangle mesh in the form that GPUs and files use: flat arrays per vertex, three indices per triangle.
struct Mesh {
  std::vector<Vec3f> positions;
  std::vector<Vec3f> normals;   ///< empty, or one unit vector per vertex
  std::vector<Vec4f> tangents;  ///< empty, or one per vertex; w is the handedness, 1 or -1
  std::vector<Vec2f> uvs;       ///< empty, or one per vertex; (0, 0) is the image's top-left corner
  std::vector<std::uint32_t> triangles;

  [[nodiscard]] int vertex_count() const { return static_cast<int>(positions.size()); }
  [[nodiscard]] int triangle_count() const { return static_cast<int>(triangles.size() / 3); }
  /// Throws invalid_argument unless sizes agree, indices are in range and positions are finite.
  void check() const;
};

/// Area-weighted vertex normals; a vertex without area gets +Y.
[[nodiscard]] std::vector<Vec3f> compute_normals(const std::vector<Vec3f>& positions,
                                                 const std::vector<std::uint32_t>& triangles);

/// The signed volume that the triangles enclose (positive for outward, counter-clockwise triangles).
[[nodiscard]] double signed_volume(const std::vector<Vec3f>& positions, const std::vector<std::uint32_t>& triangles);

/// A morph target: what to add to each vertex at weight 1. Each array is empty or has one entry per vertex.
struct BlendShape {
  std::string name;
  std::vector<Vec3f> positions;
  std::vector<Vec3f> normals;
  std::vector<Vec3f> tangents;
};

}  // namespace croquis
