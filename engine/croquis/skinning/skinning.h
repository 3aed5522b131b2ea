// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "croquis/project/character.h"
#include "croquis/skinning/palette.h"

namespace croquis {

/// A part's vertices in model space, posed.
struct PosedPart {
  std::vector<Vec3f> positions;
  std::vector<Vec3f> normals;   ///< unit; empty if the mesh has none
  std::vector<Vec4f> tangents;  ///< unit, w the handedness; empty if the mesh has none
};

/// A mesh with its shapes added: positions + sum of weight * delta, and so the normals and tangents, which keep the
/// length that comes out. `weights` has one entry per shape; a shape without deltas for an array leaves it. Throws
/// invalid_argument if a size is off.
[[nodiscard]] Mesh apply_shapes(const Mesh& mesh, std::span<const BlendShape> shapes, std::span<const float> weights);

/// Shapes first, then the skin (or the carrying joint). `model` is model_from_joint of every joint of the skeleton,
/// `shape_weights` one per shape of the part. Throws invalid_argument if a size is off or a joint is not there.
[[nodiscard]] PosedPart pose_part(const Part& part, std::span<const Affine> model, std::span<const float> shape_weights,
                                  SkinningMethod method = SkinningMethod::linear);

/// Every part of a character in a pose, with the parts' own shape weights.
[[nodiscard]] std::vector<PosedPart> pose_character(const Character& character, const Pose& pose,
                                                    SkinningMethod method = SkinningMethod::linear);

}  // namespace croquis
