// SPDX-License-Identifier: MIT
#include "croquis/skinning/skin_vertices.h"

#include <algorithm>
#include <cassert>
#include <optional>
#include <string>
#include <vector>

#include "croquis/base/error.h"

namespace croquis {
namespace {

using skinning_kernels::KernelJob;
using skinning_kernels::KernelSet;

// Small enough for what is touched twice to stay in the first-level cache.
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
  return kernel_job;
}

// Unit length for the tangents, and the handedness of vertices whose heaviest influence mirrors.
void finish_tangents(const SkinningPalette& palette, const KernelJob& block) {
  for (std::ptrdiff_t v = 0; v < block.count; ++v) {
    float* tangent = block.posed_tangents + 4 * v;
    Eigen::Map<Vec3f> direction(tangent);
    const float length = direction.norm();
    if (length * length > skinning_kernels::kNoDirection) {
      direction /= length;
    } else {
      direction = Eigen::Map<const Vec3f>(block.tangents + 4 * v);
    }
    if (!palette.any_mirrored()) continue;
    const float* weights = block.weights + v * block.influences;
    const std::ptrdiff_t heaviest = std::max_element(weights, weights + block.influences) - weights;
    const bool follows_none = !(weights[heaviest] > 0.0F);
    const int entry = follows_none ? 0 : block.joint_indices[v * block.influences + heaviest];
    if (palette.is_mirrored(entry)) tangent[3] = -tangent[3];
  }
}

// Room for one block of stretched vertices, between the two phases of dual quaternion skinning.
struct Scratch {
  std::vector<float> positions = std::vector<float>(3 * kBlock);
  std::vector<float> normals = std::vector<float>(3 * kBlock);
  std::vector<float> tangents = std::vector<float>(4 * kBlock);
};

KernelJob stretch(const KernelJob& block, const KernelSet& kernels, Scratch& scratch) {
  KernelJob first = block, second = block;
  first.posed_positions = scratch.positions.data();
  second.positions = first.posed_positions;
  if (block.normals != nullptr) {
    first.posed_normals = scratch.normals.data();
    second.normals = first.posed_normals;
  }
  if (block.tangents != nullptr) {
    first.posed_tangents = scratch.tangents.data();
    second.tangents = first.posed_tangents;
  }
  kernels.linear(first);
  return second;
}

}  // namespace

void skin_vertices(const SkinningPalette& palette, const SkinningJob& job) {
  skin_vertices(palette, job, skinning_kernels::available_kernels().sets[0]);
}

void skin_vertices(const SkinningPalette& palette, const SkinningJob& job, const KernelSet& kernels) {
  check(palette, job);
  const KernelJob whole = to_kernel_job(palette, job);
  const bool is_dual = palette.method() == SkinningMethod::dual_quaternion;
  std::optional<Scratch> scratch;
  if (is_dual && whole.matrices != nullptr) scratch.emplace();
  for (std::ptrdiff_t first = 0; first < whole.count; first += kBlock) {
    const KernelJob block = whole.slice(first, std::min(kBlock, whole.count - first));
    if (!is_dual) {
      kernels.linear(block);
    } else {
      kernels.dual_quaternion(scratch ? stretch(block, kernels, *scratch) : block);
    }
    if (block.normals != nullptr) kernels.normalise(block.normals, block.posed_normals, block.count);
    if (block.tangents != nullptr) finish_tangents(palette, block);
  }
}

}  // namespace croquis
