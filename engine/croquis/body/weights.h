// SPDX-License-Identifier: MIT
#pragma once

#include "croquis/body/armature.h"
#include "croquis/body/implicit_surface.h"
#include "croquis/body/polygonize.h"
#include "croquis/mesh/skin.h"

namespace croquis {

struct WeightOptions {
  double spread = 0.25;  ///< how far weights are smoothed along the surface, in local radii
};

/// Skin weights of a mesh on an implicit surface, at most four influences per vertex. A vertex belongs to the forms in
/// the proportion in which they shape the surface there; along a form's chain of joints the weight passes from one to
/// the next as a smooth step across the plane that halves the angle of the two bones; the whole is then diffused along
/// the surface,
///     (M / t + L) w = (M / t) w0,   t = (spread * local radius)^2,
/// with M the vertices' areas and L the cotangent Laplacian. On a mirrored surface the weights are mirror images:
/// `image` is each vertex's mirror image there (a vertex with x = 0 is its own), and empty on any other surface.
[[nodiscard]] Skin compute_weights(const ImplicitSurface& surface, const Armature& armature, const Triangulation& mesh,
                                   const std::vector<int>& image, const WeightOptions& options = {});

}  // namespace croquis
