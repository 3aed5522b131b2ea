// SPDX-License-Identifier: MIT
#include "croquis/edit/screen_form.h"

#include <span>

#include "croquis/base/error.h"
#include "croquis/rig/pose.h"
#include "croquis/skinning/skinning.h"

namespace croquis {
namespace {

using skinning_kernels::DualQuaternionEntry;
using skinning_kernels::MatrixEntry;

SkinningPalette palette_of(const Part& part, std::span<const Affine> model, SkinningMethod method) {
  if (part.skin) return make_palette(*part.skin, model, method);
  const Affine matrix = model[static_cast<std::size_t>(part.joint)] * part.joint_from_mesh;
  return SkinningPalette(std::span(&matrix, 1), {}, method);
}

void append_rows(std::vector<float>& floats, const MatrixEntry& matrix) {
  for (int row = 0; row < 3; ++row) {
    for (const auto& column : matrix.columns) floats.push_back(column[row]);
  }
}

template <class Vector>
void append(std::vector<float>& floats, const Vector& vector) {
  for (int axis = 0; axis < 3; ++axis) floats.push_back(static_cast<float>(vector[axis]));
}

}  // namespace

std::vector<float> make_screen_palette(const Actor& actor, SkinningMethod method) {
  constexpr MatrixEntry kNoStretch = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
  const std::vector<Affine> model = compute_model_transforms(actor.character->skeleton, actor.pose);
  std::vector<float> floats;
  for (const Part& part : actor.character->parts) {
    const SkinningPalette palette = palette_of(part, model, method);
    for (std::size_t i = 0; i < static_cast<std::size_t>(palette.size()); ++i) {
      append_rows(floats, palette.matrices().empty() ? kNoStretch : palette.matrices()[i]);
      const DualQuaternionEntry rigid =
          palette.dual_quaternions().empty() ? DualQuaternionEntry{} : palette.dual_quaternions()[i];
      floats.insert(floats.end(), std::begin(rigid.real), std::end(rigid.real));
      floats.insert(floats.end(), std::begin(rigid.dual), std::end(rigid.dual));
    }
  }
  return floats;
}

std::vector<float> make_screen_joints(const Actor& actor) {
  std::vector<float> floats;
  for (const Vec3& position : compute_positions(actor.character->skeleton, actor.pose)) append(floats, position);
  return floats;
}

std::vector<float> make_screen_vertices(const Actor& actor, int part, SkinningMethod method) {
  const std::vector<Part>& parts = actor.character->parts;
  if (part < 0 || part >= std::ssize(parts)) throw_invalid_argument("part " + std::to_string(part) + " is not there");
  const Part& chosen = parts[static_cast<std::size_t>(part)];
  const std::vector<Affine> model = compute_model_transforms(actor.character->skeleton, actor.pose);
  std::vector<float> floats;
  for (const Vec3f& position : pose_part(chosen, model, chosen.shape_weights, method).positions)
    append(floats, position);
  return floats;
}

}  // namespace croquis
