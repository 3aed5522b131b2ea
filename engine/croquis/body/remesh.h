// SPDX-License-Identifier: MIT
#pragma once

#include "croquis/body/implicit_surface.h"
#include "croquis/body/polygonize.h"

namespace croquis {

struct RemeshOptions {
  int most_vertices = 7000;  ///< about: where the wanted lengths would make more, all of them grow
  int rounds = 4;            ///< of splitting, collapsing, flipping, relaxing
  int final_rounds = 2;      ///< of flipping and relaxing only
};

/// Makes the triangles of a surface's mesh near equilateral, with edges of the length that the surface asks for (its
/// `detail`), every vertex on the surface. A rim in the plane x = 0 stays in that plane.
[[nodiscard]] Triangulation remesh(const ImplicitSurface& surface, const Triangulation& mesh,
                                   const RemeshOptions& options = {});

}  // namespace croquis
