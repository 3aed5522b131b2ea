// SPDX-License-Identifier: MIT
#include "croquis/io/gltf_vertices.h"

namespace croquis {
namespace {

/// glTF wants unit normals whatever the mesh had; one without a direction points up.
Vec3f unit(const Vec3& vector) {
  const double length = vector.stableNorm();
  return length > 0.0 ? Vec3f((vector / length).cast<float>()) : Vec3f::UnitY();
}

}  // namespace

VertexSpace::VertexSpace(const Affine& to_from)
    : to_from_(to_from),
      normal_(to_from.linear().inverse().transpose()),
      identity_(to_from.matrix() == Affine::Identity().matrix()) {}

std::vector<Vec3f> VertexSpace::points(const std::vector<Vec3f>& points) const {
  if (identity_) return points;
  std::vector<Vec3f> carried;
  carried.reserve(points.size());
  for (const Vec3f& point : points) carried.emplace_back((to_from_ * Vec3(point.cast<double>())).cast<float>());
  return carried;
}

std::vector<Vec3f> VertexSpace::vectors(const std::vector<Vec3f>& vectors) const {
  if (identity_) return vectors;
  std::vector<Vec3f> carried;
  carried.reserve(vectors.size());
  for (const Vec3f& vector : vectors) {
    carried.emplace_back((to_from_.linear() * Vec3(vector.cast<double>())).cast<float>());
  }
  return carried;
}

std::vector<Vec3f> VertexSpace::normals(const std::vector<Vec3f>& normals) const {
  std::vector<Vec3f> carried;
  carried.reserve(normals.size());
  for (const Vec3f& normal : normals) carried.push_back(unit(normal_ * normal.cast<double>()));
  return carried;
}

std::vector<Vec4f> VertexSpace::tangents(const std::vector<Vec4f>& tangents) const {
  // A mirroring turns the handedness round.
  const float sign = to_from_.linear().determinant() < 0.0 ? -1.0F : 1.0F;
  std::vector<Vec4f> carried;
  carried.reserve(tangents.size());
  for (const Vec4f& tangent : tangents) {
    const Vec3f direction = unit(to_from_.linear() * tangent.head<3>().cast<double>());
    const float handedness = tangent.w() < 0.0F ? -sign : sign;
    carried.emplace_back(direction.x(), direction.y(), direction.z(), handedness);
  }
  return carried;
}

}  // namespace croquis
