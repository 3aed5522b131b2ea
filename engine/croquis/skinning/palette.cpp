// SPDX-License-Identifier: MIT
// Dual quaternions: kavan2008. Scale before the rigid motion is that paper's two-phase skinning; the common scale and
// the polar decomposition are ours, so that the split does not depend on where the model's origin lies.
#include "croquis/skinning/palette.h"

#include <algorithm>
#include <cmath>

#include <Eigen/SVD>

#include "croquis/base/error.h"

namespace croquis {
namespace {

using skinning_kernels::DualQuaternionEntry;
using skinning_kernels::MatrixEntry;

// How far M^T M may be from a multiple of one for M to count as a rotation times a scale: the noise of inverse bind
// matrices that a file stores as floats.
constexpr double kSimilarityTolerance = 1e-5;

double signed_scale(const Mat3& m) { return std::cbrt(m.determinant()); }

bool is_similarity(const Mat3& m, double scale) {
  const double square = scale * scale;
  return square > 0.0 && (m.transpose() * m / square - Mat3::Identity()).cwiseAbs().maxCoeff() < kSimilarityTolerance;
}

bool is_near(double scale, double common) {
  return std::abs(scale - common) <= kSimilarityTolerance * std::abs(common);
}

// The proper rotation of M = R S, S symmetric: a mirroring stays in S, as a point reflection, because that is the same
// for every joint of a mirrored rig. Of a flattened M any rotation that fits.
Mat3 polar_rotation(const Mat3& m, double scale) {
  if (is_similarity(m, scale)) return m / scale;
  const Eigen::JacobiSVD<Mat3> svd(m, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Mat3 u = svd.matrixU();
  const Mat3 v = svd.matrixV();
  if ((u * v.transpose()).determinant() < 0.0) {
    const Vec3 sizes = svd.singularValues();
    if (sizes[2] <= 1e-9 * sizes[0]) {
      u.col(2) = -u.col(2);
    } else {
      u = -u;
    }
  }
  return u * v.transpose();
}

MatrixEntry to_entry(const Mat3& linear, const Vec3& translation) {
  MatrixEntry entry = {};
  for (int c = 0; c < 4; ++c) {
    const Vec3 column = c < 3 ? Vec3(linear.col(c)) : translation;
    for (int r = 0; r < 3; ++r) entry.columns[c][r] = static_cast<float>(column[r]);
  }
  entry.columns[3][3] = 1.0F;
  return entry;
}

// The inverse transpose up to a positive factor, from cofactors, so that a flattened matrix has one too.
Mat3 normal_matrix(const Mat3& m) {
  Mat3 cofactors;
  for (int c = 0; c < 3; ++c) cofactors.col(c) = m.col((c + 1) % 3).cross(m.col((c + 2) % 3));
  const double norm = cofactors.norm();
  if (!(norm > 0.0)) return Mat3::Zero();
  return cofactors * ((m.determinant() < 0.0 ? -std::sqrt(3.0) : std::sqrt(3.0)) / norm);
}

DualQuaternionEntry to_dual_quaternion(const Mat3& rotation, const Vec3& translation) {
  const Quat real = Quat(rotation).normalized();
  Quat shift;
  shift.coeffs() << 0.5 * translation, 0.0;
  const Quat dual = shift * real;
  DualQuaternionEntry entry = {};
  for (int c = 0; c < 4; ++c) {
    entry.real[c] = static_cast<float>(real.coeffs()[c]);
    entry.dual[c] = static_cast<float>(dual.coeffs()[c]);
  }
  return entry;
}

float dot(const DualQuaternionEntry& a, const DualQuaternionEntry& b) {
  return a.real[0] * b.real[0] + a.real[1] * b.real[1] + a.real[2] * b.real[2] + a.real[3] * b.real[3];
}

// Turns every entry to the side of the first one: q and -q are the same motion.
void gather_in_hemisphere(std::vector<DualQuaternionEntry>& entries) {
  for (DualQuaternionEntry& entry : entries) {
    if (dot(entries.front(), entry) >= 0.0F) continue;
    for (int c = 0; c < 4; ++c) {
      entry.real[c] = -entry.real[c];
      entry.dual[c] = -entry.dual[c];
    }
  }
}

// Which pairs point apart, as KernelJob::signs; none if the palette is too large for a table of all pairs to pay.
std::vector<float> compare_pairs(const std::vector<DualQuaternionEntry>& entries) {
  constexpr std::size_t kMost = 256;
  const std::size_t count = entries.size();
  if (count > kMost) return {};
  std::vector<float> signs(count * count, 0.0F);
  for (std::size_t a = 0; a < count; ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      if (dot(entries[a], entries[b]) < 0.0F) signs[a * count + b] = signs[b * count + a] = -0.0F;
    }
  }
  return signs;
}

double median_scale(std::span<const Affine> matrices) {
  std::vector<double> scales;
  for (const Affine& matrix : matrices) scales.push_back(signed_scale(matrix.linear()));
  const auto middle = scales.begin() + std::ssize(scales) / 2;
  std::nth_element(scales.begin(), middle, scales.end());
  return *middle != 0.0 ? *middle : 1.0;
}

}  // namespace

SkinningPalette::SkinningPalette(std::span<const Affine> matrices, std::span<const Vec3> centres, SkinningMethod method)
    : method_(method) {
  if (matrices.empty()) throw_invalid_argument("SkinningPalette: wanted at least one matrix");
  if (!centres.empty() && centres.size() != matrices.size()) {
    throw_invalid_argument("SkinningPalette: wanted one centre per matrix");
  }
  for (const Affine& matrix : matrices) {
    if (!matrix.matrix().allFinite()) throw_invalid_argument("SkinningPalette: a matrix is not finite");
    is_mirrored_.push_back(matrix.linear().determinant() < 0.0 ? 1 : 0);
  }
  for (const Vec3& centre : centres) {
    if (!centre.allFinite()) throw_invalid_argument("SkinningPalette: a centre is not finite");
  }
  any_mirrored_ = std::find(is_mirrored_.begin(), is_mirrored_.end(), 1) != is_mirrored_.end();
  if (method == SkinningMethod::linear) {
    set_matrices(matrices);
    return;
  }

  const double common = median_scale(matrices);
  std::vector<Affine> stretches(matrices.size(), Affine::Identity());
  bool any_stretch = !is_near(common, 1.0);
  for (std::size_t i = 0; i < matrices.size(); ++i) {
    const Mat3 m = matrices[i].linear();
    const double scale = signed_scale(m);
    const bool is_rigid = is_similarity(m, scale) && is_near(scale, common);
    any_stretch = any_stretch || !is_rigid;
    const Mat3 rotation = polar_rotation(m, scale);
    const Vec3 centre = centres.empty() ? Vec3(Vec3::Zero()) : centres[i];
    stretches[i].linear() = is_rigid ? Mat3(common * Mat3::Identity()) : Mat3(rotation.transpose() * m);
    stretches[i].translation() = common * centre - stretches[i].linear() * centre;
    dual_quaternions_.push_back(to_dual_quaternion(rotation, matrices[i] * centre - rotation * (common * centre)));
  }
  gather_in_hemisphere(dual_quaternions_);
  signs_ = compare_pairs(dual_quaternions_);
  share_hemisphere_ =
      !signs_.empty() && std::none_of(signs_.begin(), signs_.end(), [](float s) { return std::signbit(s); });
  if (share_hemisphere_) signs_.clear();
  if (any_stretch) set_matrices(stretches);
}

void SkinningPalette::set_matrices(std::span<const Affine> matrices) {
  const double first = signed_scale(matrices.front().linear());
  bool is_common_similarity = true;
  for (const Affine& matrix : matrices) {
    const double scale = signed_scale(matrix.linear());
    is_common_similarity = is_common_similarity && is_near(scale, first) && is_similarity(matrix.linear(), scale);
    matrices_.push_back(to_entry(matrix.linear(), matrix.translation()));
  }
  if (is_common_similarity) return;
  for (const Affine& matrix : matrices)
    normal_matrices_.push_back(to_entry(normal_matrix(matrix.linear()), Vec3::Zero()));
}

SkinningPalette make_palette(const Skin& skin, std::span<const Affine> model, SkinningMethod method) {
  if (skin.joints.size() != skin.inverse_bind.size()) {
    throw_invalid_argument("make_palette: wanted one inverse bind matrix per joint of the skin");
  }
  std::vector<Affine> matrices;
  std::vector<Vec3> centres;
  for (std::size_t i = 0; i < skin.joints.size(); ++i) {
    const int joint = skin.joints[i];
    if (joint < 0 || joint >= std::ssize(model)) {
      throw_invalid_argument("make_palette: wanted one matrix per joint, the skin names joint " +
                             std::to_string(joint));
    }
    matrices.push_back(model[static_cast<std::size_t>(joint)] * skin.inverse_bind[i]);
    if (method == SkinningMethod::linear) continue;
    const Vec3 centre = skin.inverse_bind[i].inverse().translation();
    centres.push_back(centre.allFinite() ? centre : Vec3(Vec3::Zero()));
  }
  return SkinningPalette(matrices, centres, method);
}

}  // namespace croquis
