// SPDX-License-Identifier: MIT
#pragma once

namespace croquis {

// Of ASCII alone, whatever the locale says.
[[nodiscard]] constexpr bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
[[nodiscard]] constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

}  // namespace croquis
