// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "croquis/io/gltf_edit.h"
#include "croquis/math/types.h"

namespace croquis {

/// Carries vertices from one space to another: points by `to_from`, normals by its inverse transpose, tangents and
/// differences by its linear part. Normals and tangents come out as unit vectors.
class VertexSpace {
 public:
  explicit VertexSpace(const Affine& to_from);

  [[nodiscard]] std::vector<Vec3f> points(const std::vector<Vec3f>& points) const;
  [[nodiscard]] std::vector<Vec3f> vectors(const std::vector<Vec3f>& vectors) const;
  [[nodiscard]] std::vector<Vec3f> normals(const std::vector<Vec3f>& normals) const;
  [[nodiscard]] std::vector<Vec4f> tangents(const std::vector<Vec4f>& tangents) const;

 private:
  Affine to_from_;
  Mat3 normal_;
  bool identity_ = false;  ///< then nothing is recomputed, only made valid
};

/// An accessor of one vector per vertex, for use as an attribute.
template <class Vector>
int add_vectors(GltfEditor& editor, const std::vector<Vector>& vectors, bool bounds) {
  constexpr int kWidth = Vector::RowsAtCompileTime;
  static_assert(sizeof(Vector) == kWidth * sizeof(float));
  const std::span<const float> numbers(vectors.empty() ? nullptr : vectors.front().data(), vectors.size() * kWidth);
  return editor.add_floats(numbers, kWidth == 2 ? "VEC2" : kWidth == 3 ? "VEC3" : "VEC4", bounds, ViewTarget::vertices);
}

}  // namespace croquis
