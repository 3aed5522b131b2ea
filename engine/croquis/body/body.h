// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "croquis/project/character.h"

namespace croquis {

/// Proportions of a built-in character; 1 is as designed. Each combination in range gives a clean body.
struct Proportions {
  double heads = 8.0;      ///< height in heads, 3..9 (mannequin only)
  double shoulders = 1.0;  ///< shoulder width, 0.6..1.6
  double hips = 1.0;       ///< hip width, 0.6..1.6
  double limbs = 1.0;      ///< length of arms and legs, 0.7..1.4
  double hands = 1.0;      ///< hand (and foot) size, 0.6..1.8
  double head = 1.0;       ///< head size, 0.7..1.6
  double muscle = 1.0;     ///< thickness of the forms, 0.6..1.6
};

/// The proportions by the names that people give them.
inline constexpr std::array<std::pair<const char*, double Proportions::*>, 7> kProportions{{
    {"heads", &Proportions::heads},
    {"shoulders", &Proportions::shoulders},
    {"hips", &Proportions::hips},
    {"limbs", &Proportions::limbs},
    {"hands", &Proportions::hands},
    {"head", &Proportions::head},
    {"muscle", &Proportions::muscle},
}};

/// "mannequin", "cat", "snake", "tree".
[[nodiscard]] std::vector<std::string> builtin_character_names();
[[nodiscard]] bool is_builtin_character(std::string_view name);

/// The built-in character of that name: metres, Y up, facing +Z, soles at y = 0. Deterministic. Throws
/// invalid_argument for another name (listing the names) or a proportion out of range.
[[nodiscard]] Character make_builtin_character(std::string_view name, const Proportions& proportions = {});

}  // namespace croquis
