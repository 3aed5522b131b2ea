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

/// Marching cubes on a tree of cubes that are smaller where a form that reaches into them asks for detail (at most
/// `cell` times the wanted edge length: remeshing makes it the wanted one). Each cube's outline is traced over its
/// faces by one rule (where a face is ambiguous, the inside corners are kept apart), and the face of a large cube over
/// those of the small ones beside it, so the result is always a manifold, and closed; of a mirrored surface only the
/// half x >= 0 is made, open at the plane x = 0, where its rim has x exactly 0.
[[nodiscard]] Triangulation polygonize(const ImplicitSurface& surface, double cell = 1.6);

}  // namespace croquis
