// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "croquis/math/types.h"
#include "croquis/skinning/palette.h"

namespace croquis {

/// Vertices to skin and where to put them. Every span of vertices is as long as `positions`, or empty where the mesh
/// has no such thing (a posed span is empty exactly where its source is).
struct SkinningJob {
  std::span<const std::uint16_t> joint_indices;  ///< [vertices * influences], each below the palette's size
  std::span<const float> weights;                ///< as joint_indices; not negative, with sum 1 per vertex (or all 0)
  int influences = 4;
  std::span<const Vec3f> positions;  ///< bind space
  std::span<const Vec3f> normals;
  std::span<const Vec4f> tangents;
  std::span<Vec3f> posed_positions;  ///< model space; the posed spans overlap no other
  std::span<Vec3f> posed_normals;    ///< unit, see below
  std::span<Vec4f> posed_tangents;   ///< unit; w changes its sign where the vertex is mirrored
  /// False: normals keep the length that the blending gives them, which saves an eighth of the time (for a shader that
  /// normalises them anyway).
  bool unit_normals = true;
};

/// Skins every vertex by the palette's method. A vertex without weights follows entry 0. A normal or tangent that a
/// scale of 0 leaves without direction stays as it was. Dual quaternions are quickest where each vertex's first weight
/// is its largest (see normalise_weights).
///
/// Throws invalid_argument if a size is off. Indices are not checked here, frame by frame: Skin::check does it once.
/// Allocates nothing unless the palette stretches. Runs on the kernel that is the fastest on this processor, or on
/// `kernels`; kernels agree to 1e-6 of the model's size.
void skin_vertices(const SkinningPalette& palette, const SkinningJob& job);
void skin_vertices(const SkinningPalette& palette, const SkinningJob& job, const skinning_kernels::KernelSet& kernels);

}  // namespace croquis
