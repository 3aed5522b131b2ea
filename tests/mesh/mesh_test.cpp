// SPDX-License-Identifier: MIT
#include "croquis/mesh/mesh.h"

#include <gtest/gtest.h>

#include "croquis/base/error.h"

namespace croquis {
namespace {

/// A tetrahedron of volume 1/6 with outward triangles.
Mesh tetrahedron() {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.triangles = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
  return mesh;
}

TEST(Mesh, VolumeAndNormalsOfATetrahedron) {
  const Mesh mesh = tetrahedron();
  EXPECT_NEAR(signed_volume(mesh.positions, mesh.triangles), 1.0 / 6.0, 1e-7);
  const auto normals = compute_normals(mesh.positions, mesh.triangles);
  EXPECT_GT(normals[1].x(), 0.5F);
  for (const Vec3f& normal : normals) EXPECT_NEAR(normal.norm(), 1.0F, 1e-6F);
}

TEST(Mesh, VerticesWithoutAreaHaveANormalAllTheSame) {
  EXPECT_TRUE(compute_normals({Vec3f(1, 2, 3)}, {}).front().isApprox(Vec3f::UnitY()));
}

TEST(Mesh, CheckRefusesWhatDoesNotFit) {
  Mesh mesh = tetrahedron();
  EXPECT_NO_THROW(mesh.check());
  mesh.triangles[0] = 4;
  EXPECT_THROW(mesh.check(), Error);
  mesh = tetrahedron();
  mesh.normals.resize(3);
  EXPECT_THROW(mesh.check(), Error);
}

}  // namespace
}  // namespace croquis
