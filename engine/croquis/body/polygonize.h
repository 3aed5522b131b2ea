// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "croquis/body/implicit_surface.h"

namespace croquis {

/// Triangles in double precision, counter-clockwise from outside.
struct Triangulation {
  std::vector<Vec3> positions;
  std::vector<std::array<int, 3>> triangles;
};

/// Marching cubes on a rectilinear grid whose planes stand closer together where a form that they cut asks for detail
/// (a plane's distance to the next is `cell` times the wanted edge length). Each cell's outline is traced over its
/// faces by one rule (where a face is ambiguous, the inside corners are kept apart), so the result is always a
/// manifold, and closed; of a mirrored surface only the half x >= 0 is made, open at the plane x = 0, where its rim has
/// x exactly 0.
[[nodiscard]] Triangulation polygonize(const ImplicitSurface& surface, double cell = 0.9);

}  // namespace croquis
