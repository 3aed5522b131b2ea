// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "croquis/project/project.h"
#include "croquis/skinning/palette.h"

namespace croquis {

/// Floats of one entry of a screen palette.
inline constexpr int kScreenEntry = 20;

/// What a graphics card skins an actor with, all parts in order; a part without a skin has one entry. Each entry is
/// five texels of 4 floats: three rows of the matrix that is blended (dual quaternions: the stretch), then the real and
/// the dual part of the rigid motion that follows it, x y z w (linear: zero).
[[nodiscard]] std::vector<float> make_screen_palette(const Actor& actor, SkinningMethod method);

/// Where every joint is, model space, 3 floats each.
[[nodiscard]] std::vector<float> make_screen_joints(const Actor& actor);

/// Where the engine itself puts the vertices of a part, model space, 3 floats each: what a card has to come up with.
[[nodiscard]] std::vector<float> make_screen_vertices(const Actor& actor, int part, SkinningMethod method);

}  // namespace croquis
