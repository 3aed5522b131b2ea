// SPDX-License-Identifier: MIT
#include "croquis/skinning/skin_vertices.h"

#include <algorithm>
#include <cassert>
#include <string>
#include <vector>

#include "croquis/base/error.h"

namespace croquis {
namespace {

using skinning_kernels::KernelJob;
using skinning_kernels::KernelSet;

// Small enough for a stretched block to stay in the first-level cache.
constexpr std::ptrdiff_t kBlock = 256;

void check(const SkinningPalette& palette, const SkinningJob& job) {
  const auto want = [](bool holds, const std::string& what) {
    if (!holds) throw_invalid_argument("skin_vertices: " + what);
  };
  const std::size_t vertices = job.positions.size();
  want(job.influences >= 1, "wanted at least one influence per vertex");
  const std::size_t slots = vertices * static_cast<std::size_t>(job.influences);
  want(job.joint_indices.size() == slots && job.weights.size() == slots,
       "wanted " + std::to_string(slots) + " joint indices and weights");
  want(job.posed_positions.size() == vertices, "wanted room for every position");
  want(job.normals.empty() || job.normals.size() == vertices, "wanted no normals or one per vertex");
  want(job.tangents.empty() || job.tangents.size() == vertices, "wanted no tangents or one per vertex");
  want(job.posed_normals.size() == job.normals.size(), "wanted room for every normal");
  want(job.posed_tangents.size() == job.tangents.size(), "wanted room for every tangent");
  assert(std::all_of(job.joint_indices.begin(), job.joint_indices.end(), [&](int i) { return i < palette.size(); }));
  static_cast<void>(palette);
}

template <typename Vector>
auto* floats(std::span<Vector> vectors) {
  return vectors.empty() ? nullptr : vectors.front().data();
}

KernelJob to_kernel_job(const SkinningPalette& palette, const SkinningJob& job) {
  KernelJob kernel_job;
  kernel_job.matrices = palette.matrices().empty() ? nullptr : palette.matrices().data();
  kernel_job.normal_matrices = palette.normal_matrices().empty() ? nullptr : palette.normal_matrices().data();
  kernel_job.dual_quaternions = palette.dual_quaternions().empty() ? nullptr : palette.dual_quaternions().data();
  kernel_job.joint_indices = job.joint_indices.data();
  kernel_job.weights = job.weights.data();
  kernel_job.influences = job.influences;
  kernel_job.count = std::ssize(job.positions);
  kernel_job.positions = floats(job.positions);
  kernel_job.normals = floats(job.normals);
  kernel_job.tangents = floats(job.tangents);
  kernel_job.posed_positions = floats(job.posed_positions);
  kernel_job.posed_normals = floats(job.posed_normals);
  kernel_job.posed_tangents = floats(job.posed_tangents);
  kernel_job.share_hemisphere = palette.share_hemisphere();
  kernel_job.signs = palette.signs().empty() ? nullptr : palette.signs().data();
  kernel_job.palette_size = palette.size();
  kernel_job.unit_normals = job.unit_normals;
  return kernel_job;
}

// The handedness of vertices whose heaviest influence mirrors.
void mirror_tangents(const SkinningPalette& palette, const KernelJob& job) {
  for (std::ptrdiff_t v = 0; v < job.count; ++v) {
    const float* weights = job.weights + v * job.influences;
    const std::ptrdiff_t heaviest = std::max_element(weights, weights + job.influences) - weights;
    const bool follows_none = !(weights[heaviest] > 0.0F);
    const int entry = follows_none ? 0 : job.joint_indices[v * job.influences + heaviest];
    if (palette.is_mirrored(entry)) job.posed_tangents[4 * v + 3] = -job.posed_tangents[4 * v + 3];
  }
}

// Stretches a block of vertices, then moves them by dual quaternions.
void skin_in_two_phases(const KernelJob& whole, const KernelSet& kernels) {
  std::vector<float> positions(3 * kBlock), normals(3 * kBlock), tangents(4 * kBlock);
  for (std::ptrdiff_t first = 0; first < whole.count; first += kBlock) {
    const KernelJob block = whole.slice(first, std::min(kBlock, whole.count - first));
    KernelJob stretch = block, move = block;
    move.positions = stretch.posed_positions = positions.data();
    if (block.normals != nullptr) move.normals = stretch.posed_normals = normals.data();
    if (block.tangents != nullptr) move.tangents = stretch.posed_tangents = tangents.data();
    kernels.linear(stretch);
    kernels.dual_quaternion(move);
  }
}

}  // namespace

void skin_vertices(const SkinningPalette& palette, const SkinningJob& job) {
  skin_vertices(palette, job, skinning_kernels::available_kernels().sets[0]);
}

void skin_vertices(const SkinningPalette& palette, const SkinningJob& job, const KernelSet& kernels) {
  check(palette, job);
  const KernelJob whole = to_kernel_job(palette, job);
  if (palette.method() == SkinningMethod::linear) {
    kernels.linear(whole);
  } else if (whole.matrices == nullptr) {
    kernels.dual_quaternion(whole);
  } else {
    skin_in_two_phases(whole, kernels);
  }
  if (whole.tangents != nullptr && palette.any_mirrored()) mirror_tangents(palette, whole);
}

}  // namespace croquis
