// SPDX-License-Identifier: MIT
#include "croquis/mesh/mesh.h"

#include <algorithm>

#include "croquis/base/error.h"

namespace croquis {

void Mesh::check() const {
  const auto want = [&](bool holds, const std::string& what) {
    if (!holds) throw_invalid_argument("Mesh: " + what);
  };
  const auto fits = [&](std::size_t size) { return size == 0 || size == positions.size(); };
  want(fits(normals.size()), "wanted no normals or one per vertex");
  want(fits(tangents.size()), "wanted no tangents or one per vertex");
  want(fits(uvs.size()), "wanted no texture coordinates or one per vertex");
  want(triangles.size() % 3 == 0, "wanted three indices per triangle");
  want(std::all_of(triangles.begin(), triangles.end(), [&](std::uint32_t i) { return i < positions.size(); }),
       "a triangle names a vertex that is not there");
  want(std::all_of(positions.begin(), positions.end(), [](const Vec3f& p) { return p.allFinite(); }),
       "a position is not finite");
}

std::vector<Vec3f> compute_normals(const std::vector<Vec3f>& positions, const std::vector<std::uint32_t>& triangles) {
  std::vector<Vec3f> normals(positions.size(), Vec3f::Zero());
  for (std::size_t t = 0; t + 2 < triangles.size(); t += 3) {
    const Vec3f& a = positions[triangles[t]];
    const Vec3f area = (positions[triangles[t + 1]] - a).cross(positions[triangles[t + 2]] - a);
    for (std::size_t corner = 0; corner < 3; ++corner) normals[triangles[t + corner]] += area;
  }
  for (Vec3f& normal : normals) {
    const float length = normal.stableNorm();
    normal = length > 0.0F ? Vec3f(normal / length) : Vec3f::UnitY();
  }
  return normals;
}

double signed_volume(const std::vector<Vec3f>& positions, const std::vector<std::uint32_t>& triangles) {
  double six_volumes = 0.0;
  for (std::size_t t = 0; t + 2 < triangles.size(); t += 3) {
    const Vec3 a = positions[triangles[t]].cast<double>(), b = positions[triangles[t + 1]].cast<double>(),
               c = positions[triangles[t + 2]].cast<double>();
    six_volumes += a.dot(b.cross(c));
  }
  return six_volumes / 6.0;
}

}  // namespace croquis
