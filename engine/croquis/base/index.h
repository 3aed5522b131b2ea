// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace croquis {

/// An index that is not negative, as the standard containers take it. Indices of joints, vertices, ... are ints, with
/// -1 for none.
[[nodiscard]] constexpr std::size_t at(int index) { return static_cast<std::size_t>(index); }

}  // namespace croquis
