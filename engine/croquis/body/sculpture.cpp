// SPDX-License-Identifier: MIT
#include "croquis/body/sculpture.h"

#include <algorithm>

#include "croquis/body/polygonize.h"
#include "croquis/body/remesh.h"

namespace croquis {
namespace {

/// Adds the mirror image of a half x >= 0; vertices with x = 0 are shared.
void mirror(Triangulation& mesh) {
  const std::size_t vertices = mesh.positions.size(), triangles = mesh.triangles.size();
  std::vector<int> image(vertices);
  for (std::size_t v = 0; v < vertices; ++v) {
    const Vec3 p = mesh.positions[v];
    image[v] = static_cast<int>(p.x() == 0.0 ? v : mesh.positions.size());
    if (p.x() != 0.0) mesh.positions.emplace_back(-p.x(), p.y(), p.z());
  }
  for (std::size_t t = 0; t < triangles; ++t) {
    std::array<int, 3> triangle = mesh.triangles[t];
    for (int& v : triangle) v = image[static_cast<std::size_t>(v)];
    std::swap(triangle[1], triangle[2]);
    mesh.triangles.push_back(triangle);
  }
}

}  // namespace

Part build_part(Sculpture sculpture, const Armature& armature) {
  const ImplicitSurface surface(std::move(sculpture.root), sculpture.mirrored);
  Triangulation mesh = remesh(surface, polygonize(surface));
  if (surface.mirrored()) mirror(mesh);
  Part part;
  part.name = std::move(sculpture.name);
  part.material.base_color = sculpture.color;
  for (const Vec3& position : mesh.positions) {
    part.mesh.positions.push_back(position.cast<float>());
    part.mesh.normals.push_back(surface.normal(position, 0.2 * surface.sample(position).detail).cast<float>());
  }
  for (const auto& triangle : mesh.triangles) {
    for (const int v : triangle) part.mesh.triangles.push_back(static_cast<std::uint32_t>(v));
  }
  part.skin = compute_weights(surface, armature, mesh, sculpture.weights);
  return part;
}

Character assemble(std::string name, const Armature& armature, Sculpture sculpture) {
  const Skeleton skeleton = armature.skeleton();
  Character character{std::move(name), skeleton, rest_pose(skeleton), {}, Vec3::UnitZ(), {}, {}, std::nullopt, {},
                      nullptr,         {}};
  character.parts.push_back(build_part(std::move(sculpture), armature));
  return character;
}

}  // namespace croquis
