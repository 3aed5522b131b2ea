// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "croquis/math/types.h"
#include "croquis/mesh/skin.h"
#include "croquis/skinning/kernels.h"

namespace croquis {

/// How a vertex follows several joints. Linear blending sums their matrices: quick, but it loses volume at strong bends
/// and twists. Dual quaternions blend their screw motions and keep it (kavan2008), but bulge a little at bends.
enum class SkinningMethod { linear, dual_quaternion };

/// The joints' motions of one frame, in the forms that skinning reads. Each entry is a matrix M, model_from_bind.
///
/// Normals turn by the inverse transpose of M (scaled: only directions count). Where every M is a rotation times one
/// common scale that is M itself, and one blended matrix serves positions and normals.
///
/// For dual quaternions M is split by polar decomposition into a stretch S (symmetric, in bind space) and a rotation R:
///     M p = R (S (p - c) + s c) + r,
/// c the place of the joint when bound and s the palette's common scale (the median). The stretches are blended as
/// matrices first, then the rigid motions (R, r) as dual quaternions: joints that only rotate and translate pay for no
/// stretch, and a scale of the whole rig (centimetres, a mirror) bends like the unscaled rig.
class SkinningPalette {
 public:
  /// `matrices`: model_from_bind of each palette entry; `centres`: where each joint stood when bound, in the mesh's
  /// space (used by dual quaternions only; empty: at the origin). Throws invalid_argument if there is no entry, a size
  /// is off or a number is not finite.
  explicit SkinningPalette(std::span<const Affine> matrices, std::span<const Vec3> centres = {},
                           SkinningMethod method = SkinningMethod::linear);

  [[nodiscard]] SkinningMethod method() const { return method_; }
  [[nodiscard]] int size() const { return static_cast<int>(is_mirrored_.size()); }
  /// Does the entry turn left hands into right ones?
  [[nodiscard]] bool is_mirrored(int entry) const { return is_mirrored_[static_cast<std::size_t>(entry)] != 0; }
  [[nodiscard]] bool any_mirrored() const { return any_mirrored_; }

  /// What is blended as matrices: M, or for dual quaternions the stretches (empty if there are none).
  [[nodiscard]] const std::vector<skinning_kernels::MatrixEntry>& matrices() const { return matrices_; }
  /// Their normal matrices; empty where `matrices` serves for both.
  [[nodiscard]] const std::vector<skinning_kernels::MatrixEntry>& normal_matrices() const { return normal_matrices_; }
  /// The rigid motions; empty for linear blending.
  [[nodiscard]] const std::vector<skinning_kernels::DualQuaternionEntry>& dual_quaternions() const {
    return dual_quaternions_;
  }
  /// No two rigid motions have real parts with a negative dot product: their blends need no choice of sign. So in every
  /// pose whose joints turn by up to 90 degrees each, and in many others.
  [[nodiscard]] bool share_hemisphere() const { return share_hemisphere_; }
  /// The signs of all pairs, see KernelJob::signs. Empty where they share a hemisphere, and for large palettes.
  [[nodiscard]] const std::vector<float>& signs() const { return signs_; }

 private:
  void set_matrices(std::span<const Affine> matrices);

  SkinningMethod method_;
  bool any_mirrored_ = false;
  bool share_hemisphere_ = false;
  std::vector<std::uint8_t> is_mirrored_;
  std::vector<skinning_kernels::MatrixEntry> matrices_;
  std::vector<skinning_kernels::MatrixEntry> normal_matrices_;
  std::vector<skinning_kernels::DualQuaternionEntry> dual_quaternions_;
  std::vector<float> signs_;
};

/// The palette of a skin: M = model[joint] * inverse_bind. `model` is model_from_joint of every joint of the skeleton.
[[nodiscard]] SkinningPalette make_palette(const Skin& skin, std::span<const Affine> model,
                                           SkinningMethod method = SkinningMethod::linear);

}  // namespace croquis
