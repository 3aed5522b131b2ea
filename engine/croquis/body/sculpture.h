// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "croquis/body/armature.h"
#include "croquis/body/implicit_surface.h"
#include "croquis/body/weights.h"
#include "croquis/project/character.h"

namespace croquis {

/// A part of a character before it is a mesh.
struct Sculpture {
  std::string name;
  Limb root;
  bool mirrored = false;  ///< see ImplicitSurface
  Vec4f color = Vec4f(0.8F, 0.8F, 0.8F, 1.0F);
  WeightOptions weights;
};

/// Meshes the surface, makes its normals and hangs it on the armature's joints.
[[nodiscard]] Part build_part(Sculpture sculpture, const Armature& armature);

/// A character of one part, standing in its armature's rest pose, facing +Z, no humanoid.
[[nodiscard]] Character assemble(std::string name, const Armature& armature, Sculpture sculpture);

}  // namespace croquis
