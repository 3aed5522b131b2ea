// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

/// The inner loops of skinning, as plain pointers: inside this room only (and for its tests and benchmark).
namespace croquis::skinning_kernels {

/// A vector whose square is not above this has no direction left.
inline constexpr float kNoDirection = 1e-30F;

/// A 3x4 matrix by columns, each with a fourth row: 0 0 0 1. The blended 1 is the sum of a vertex's weights.
struct alignas(64) MatrixEntry {
  float columns[4][4];
};

/// A unit dual quaternion, both parts x y z w.
struct alignas(32) DualQuaternionEntry {
  float real[4];
  float dual[4];
};

/// Vertices to skin; every array is packed (3 floats per position and normal, 4 per tangent) and null where absent.
/// Outputs overlap no input.
/// Posed tangents, and normals with `unit_normals`, are unit, or as they were where a matrix leaves them no direction.
struct KernelJob {
  const MatrixEntry* matrices = nullptr;
  const MatrixEntry* normal_matrices = nullptr;  ///< null: as `matrices`
  const DualQuaternionEntry* dual_quaternions = nullptr;
  const std::uint16_t* joint_indices = nullptr;
  const float* weights = nullptr;
  std::ptrdiff_t influences = 0;
  std::ptrdiff_t count = 0;
  const float* positions = nullptr;
  const float* normals = nullptr;
  const float* tangents = nullptr;
  float* posed_positions = nullptr;
  float* posed_normals = nullptr;
  float* posed_tangents = nullptr;
  bool unit_normals = true;
  bool share_hemisphere = false;  ///< no two of `dual_quaternions` have real parts with a negative dot product
  /// Else, or null: -0 where entries a and b have such real parts, 0 elsewhere, at [a * palette_size + b].
  const float* signs = nullptr;
  std::ptrdiff_t palette_size = 0;

  /// `length` vertices from `first` on.
  [[nodiscard]] KernelJob slice(std::ptrdiff_t first, std::ptrdiff_t length) const;
};

struct KernelSet {
  const char* name;
  void (*linear)(const KernelJob& job);
  void (*dual_quaternion)(const KernelJob& job);
};

/// Every vertex by 4-wide vectors that any compiler here knows.
void linear_portable(const KernelJob& job);
void dual_quaternion_portable(const KernelJob& job);
/// Gives the posed normals unit length where they are.
void normalise_portable(const KernelJob& job);

/// For processors with AVX2 and FMA.
void linear_x86_64_v3(const KernelJob& job);
void dual_quaternion_x86_64_v3(const KernelJob& job);

/// The kernels that this processor can run, the fastest first; the last is the portable one.
struct KernelList {
  const KernelSet* sets;
  int count;
};
[[nodiscard]] KernelList available_kernels();

}  // namespace croquis::skinning_kernels
