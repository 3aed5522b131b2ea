// SPDX-License-Identifier: MIT
#include "croquis/body/polygonize.h"

#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "croquis/base/random.h"
#include "croquis/body/forms.h"
#include "croquis/body/half_edges.h"
#include "croquis/body/remesh.h"

namespace croquis {
namespace {

Form ball(const Vec3& center, double radius, double detail, double blend = 0.0) {
  return make_form(Ellipsoid(center, Vec3::Constant(radius)), {{0}, blend, detail});
}

double volume_of(const Triangulation& mesh) {
  double six = 0.0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const auto at = [&](int v) -> const Vec3& { return mesh.positions[static_cast<std::size_t>(v)]; };
    six += at(a).dot(at(b).cross(at(c)));
  }
  return six / 6.0;
}

/// Half-edges without a twin, all of which must lie in the plane x = 0. Throws unless the mesh is a manifold.
int count_rim_edges(const Triangulation& mesh) {
  const HalfEdges edges(static_cast<int>(mesh.positions.size()), mesh.triangles);
  int rim = 0;
  for (int h = 0; h < edges.count(); ++h) {
    if (edges.twin(h) >= 0) continue;
    ++rim;
    EXPECT_EQ(mesh.positions[static_cast<std::size_t>(edges.origin(h))].x(), 0.0);
  }
  return rim;
}

int count_pieces(const Triangulation& mesh) {
  std::vector<int> piece(mesh.positions.size());
  for (std::size_t v = 0; v < piece.size(); ++v) piece[v] = static_cast<int>(v);
  const auto root = [&](int v) {
    while (piece[static_cast<std::size_t>(v)] != v) v = piece[static_cast<std::size_t>(v)];
    return v;
  };
  for (const auto& [a, b, c] : mesh.triangles) {
    piece[static_cast<std::size_t>(root(a))] = root(b);
    piece[static_cast<std::size_t>(root(c))] = root(b);
  }
  std::set<int> roots;
  for (const auto& triangle : mesh.triangles) roots.insert(root(triangle[0]));
  return static_cast<int>(roots.size());
}

TEST(Polygonize, MakesABallOfABall) {
  const ImplicitSurface surface({{ball(Vec3(0.3, -0.2, 0.1), 1.0, 0.1)}}, false);
  const Triangulation mesh = polygonize(surface);
  EXPECT_EQ(count_rim_edges(mesh), 0);
  EXPECT_EQ(count_pieces(mesh), 1);
  EXPECT_NEAR(volume_of(mesh), 4.0 / 3.0 * kPi, 0.05);
}

TEST(Polygonize, TakesSmallCubesOnlyWhereDetailIsAskedFor) {
  const ImplicitSurface coarse({{ball(Vec3(0, 0, 0), 1.0, 0.1)}}, false);
  const ImplicitSurface mixed({{ball(Vec3(0, 0, 0), 1.0, 0.1), ball(Vec3(1.0, 0, 0), 0.05, 0.005)}}, false);
  const Triangulation mesh = polygonize(mixed);
  EXPECT_EQ(count_rim_edges(mesh), 0);
  EXPECT_EQ(count_pieces(mesh), 1);
  EXPECT_LT(mesh.positions.size(), 3 * polygonize(coarse).positions.size());
}

TEST(Polygonize, OfAMirroredSurfaceMakesTheHalfWithItsRimInThePlane) {
  const ImplicitSurface surface({{ball(Vec3(0.1, 0, 0), 1.0, 0.1), ball(Vec3(0, 1.0, 0), 0.1, 0.01)}}, true);
  const Triangulation mesh = polygonize(surface);
  EXPECT_GT(count_rim_edges(mesh), 20);
  for (const Vec3& p : mesh.positions) EXPECT_GE(p.x(), 0.0);
}

TEST(Polygonize, KeepsAGapOpenThatMustStayOpen) {
  Form left = ball(Vec3(-0.105, 0, 0), 0.1, 0.05), right = ball(Vec3(0.105, 0, 0), 0.1, 0.05);
  left.gap = right.gap = 0.008;
  const ImplicitSurface surface({{left, right}}, false);
  EXPECT_EQ(count_pieces(polygonize(surface)), 2);
}

TEST(Polygonize, OfAnyMassesIsAManifoldThatRemeshingCanTake) {
  const RemeshOptions quick{.most_vertices = 1500, .rounds = 2, .final_rounds = 1};
  Random random(7);
  for (int body = 0; body < 16; ++body) {
    const auto place = [&] { return Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)); };
    const auto detail = [&] { return 0.12 * std::pow(10.0, random.uniform(-0.7, 0.3)); };
    Limb root{{ball(place(), random.uniform(0.2, 0.6), detail())}, 0.0};
    for (int form = 0; form < 4; ++form) root.forms.push_back(ball(place(), random.uniform(0.1, 0.5), detail(), 0.1));
    root.forms.push_back(make_carving(Ellipsoid(place(), Vec3(0.4, 0.1, 0.3)), {{0}, 0.05, detail()}));
    Limb limb{{make_form(Loft({round_section(place(), 0.08), round_section(2.0 * place(), 0.03)}, Vec3(0.1, 0.2, 1.0),
                              Vec3(1.0, 0.1, 0.0)),
                         {{0}, 0.0, 0.02})},
              0.05};
    root.limbs.push_back(std::move(limb));
    const bool mirrored = body % 2 == 0;
    const ImplicitSurface surface(std::move(root), mirrored);
    const Triangulation mesh = polygonize(surface, random.uniform(0.8, 2.0));
    EXPECT_TRUE(count_rim_edges(mesh) == 0 || mirrored) << "body " << body;
    EXPECT_NO_THROW(static_cast<void>(count_rim_edges(remesh(surface, mesh, quick)))) << "body " << body;
  }
}

}  // namespace
}  // namespace croquis
