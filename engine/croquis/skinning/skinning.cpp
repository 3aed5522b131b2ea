// SPDX-License-Identifier: MIT
#include "croquis/skinning/skinning.h"

#include <algorithm>
#include <string>

#include "croquis/base/error.h"
#include "croquis/skinning/skin_vertices.h"

namespace croquis {
namespace {

// Flat, so that the compiler makes vectors of it.
void add_scaled(float weight, const float* deltas, float* values, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) values[i] += weight * deltas[i];
}

void add_shape(float weight, const std::vector<Vec3f>& deltas, std::vector<Vec3f>& values) {
  if (deltas.empty() || values.empty()) return;
  if (deltas.size() != values.size()) throw_invalid_argument("apply_shapes: a shape does not fit its mesh");
  add_scaled(weight, deltas.front().data(), values.front().data(), 3 * values.size());
}

void add_shape(float weight, const std::vector<Vec3f>& deltas, std::vector<Vec4f>& values) {
  if (deltas.empty() || values.empty()) return;
  if (deltas.size() != values.size()) throw_invalid_argument("apply_shapes: a shape does not fit its mesh");
  for (std::size_t v = 0; v < values.size(); ++v) values[v].head<3>() += weight * deltas[v];
}

bool any_active(std::span<const float> weights) {
  return std::any_of(weights.begin(), weights.end(), [](float weight) { return weight != 0.0F; });
}

}  // namespace

Mesh apply_shapes(const Mesh& mesh, std::span<const BlendShape> shapes, std::span<const float> weights) {
  if (weights.size() != shapes.size()) {
    throw_invalid_argument("apply_shapes: got " + std::to_string(weights.size()) + " weights for " +
                           std::to_string(shapes.size()) + " shapes");
  }
  Mesh shaped = mesh;
  for (std::size_t s = 0; s < shapes.size(); ++s) {
    if (weights[s] == 0.0F) continue;
    add_shape(weights[s], shapes[s].positions, shaped.positions);
    add_shape(weights[s], shapes[s].normals, shaped.normals);
    add_shape(weights[s], shapes[s].tangents, shaped.tangents);
  }
  return shaped;
}

PosedPart pose_part(const Part& part, std::span<const Affine> model, std::span<const float> shape_weights,
                    SkinningMethod method) {
  if (shape_weights.size() != part.shapes.size()) {
    throw_invalid_argument("pose_part: got " + std::to_string(shape_weights.size()) + " weights for " +
                           std::to_string(part.shapes.size()) + " shapes");
  }
  Mesh shaped;
  const bool is_shaped = any_active(shape_weights);
  if (is_shaped) shaped = apply_shapes(part.mesh, part.shapes, shape_weights);
  const Mesh& mesh = is_shaped ? shaped : part.mesh;

  PosedPart posed;
  posed.positions.resize(mesh.positions.size());
  posed.normals.resize(mesh.normals.size());
  posed.tangents.resize(mesh.tangents.size());
  SkinningJob job{.positions = mesh.positions,
                  .normals = mesh.normals,
                  .tangents = mesh.tangents,
                  .posed_positions = posed.positions,
                  .posed_normals = posed.normals,
                  .posed_tangents = posed.tangents};
  if (part.skin) {
    job.joint_indices = part.skin->joint_indices;
    job.weights = part.skin->weights;
    job.influences = part.skin->influences;
    skin_vertices(make_palette(*part.skin, model, method), job);
    return posed;
  }
  if (part.joint < 0 || part.joint >= std::ssize(model)) {
    throw_invalid_argument("pose_part: wanted one matrix per joint, the part hangs on joint " +
                           std::to_string(part.joint));
  }
  // A rigid part is a skin of one joint.
  const Affine carried[] = {model[static_cast<std::size_t>(part.joint)] * part.joint_from_mesh};
  const std::vector<std::uint16_t> indices(mesh.positions.size(), 0);
  const std::vector<float> weights(mesh.positions.size(), 1.0F);
  job.joint_indices = indices;
  job.weights = weights;
  job.influences = 1;
  skin_vertices(SkinningPalette(carried), job);
  return posed;
}

std::vector<PosedPart> pose_character(const Character& character, const Pose& pose, SkinningMethod method) {
  const std::vector<Affine> model = compute_model_transforms(character.skeleton, pose);
  std::vector<PosedPart> parts;
  parts.reserve(character.parts.size());
  for (const Part& part : character.parts) parts.push_back(pose_part(part, model, part.shape_weights, method));
  return parts;
}

}  // namespace croquis
