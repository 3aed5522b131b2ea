// SPDX-License-Identifier: MIT
#include "croquis/body/sculpture.h"

#include <algorithm>

#include "croquis/body/polygonize.h"
#include "croquis/body/remesh.h"

namespace croquis {
namespace {

/// Adds the mirror image of a half x >= 0; vertices with x = 0 are shared. vertex -> its mirror image.
std::vector<int> mirror(Triangulation& mesh) {
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
  for (std::size_t v = 0; v < vertices; ++v) {
    if (image[v] != static_cast<int>(v)) image.push_back(static_cast<int>(v));
  }
  return image;
}

}  // namespace

Part build_part(Sculpture sculpture, const Armature& armature) {
  const ImplicitSurface surface(std::move(sculpture.root), sculpture.mirrored);
  Triangulation mesh = remesh(surface, polygonize(surface));
  std::vector<Vec3f> normals;
  for (const Vec3& position : mesh.positions) {
    normals.push_back(surface.normal(position, 0.5 * surface.sample(position).detail).cast<float>());
  }
  std::vector<int> image;
  if (surface.mirrored()) image = mirror(mesh);
  Part part;
  part.name = std::move(sculpture.name);
  part.material.base_color = sculpture.color;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    part.mesh.positions.push_back(mesh.positions[v].cast<float>());
    if (v >= normals.size()) {
      const Vec3f& n = normals[static_cast<std::size_t>(image[v])];
      part.mesh.normals.emplace_back(-n.x(), n.y(), n.z());
    } else {
      part.mesh.normals.push_back(normals[v]);
      if (surface.mirrored() && mesh.positions[v].x() == 0.0) {
        part.mesh.normals.back().x() = 0.0F;
        part.mesh.normals.back().normalize();
      }
    }
  }
  for (const auto& triangle : mesh.triangles) {
    for (const int v : triangle) part.mesh.triangles.push_back(static_cast<std::uint32_t>(v));
  }
  part.skin = compute_weights(surface, armature, mesh, image, sculpture.weights);
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
