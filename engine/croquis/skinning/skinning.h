// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "croquis/project/character.h"

namespace croquis {

enum class SkinningMethod { linear, dual_quaternion };

/// A part's vertices in model space, posed.
struct PosedPart {
  std::vector<Vec3f> positions;
  std::vector<Vec3f> normals;   ///< empty if the mesh has none
  std::vector<Vec4f> tangents;  ///< empty if the mesh has none
};

/// Morph targets first, then the skin (or the carrying joint). `model` is model_from_joint of every joint,
/// `shape_weights` one per shape of the part.
[[nodiscard]] PosedPart pose_part(const Part& part, std::span<const Affine> model, std::span<const float> shape_weights,
                                  SkinningMethod method = SkinningMethod::linear);

/// Every part of a character in a pose, with the parts' own shape weights.
[[nodiscard]] std::vector<PosedPart> pose_character(const Character& character, const Pose& pose,
                                                    SkinningMethod method = SkinningMethod::linear);

}  // namespace croquis
