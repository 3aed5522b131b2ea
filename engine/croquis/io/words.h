// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace croquis {

/// "1 joint", "3 joints": a number with its noun.
[[nodiscard]] inline std::string count_of(long long count, std::string_view noun) {
  return std::to_string(count) + " " + std::string(noun) + (count == 1 ? "" : "s");
}

}  // namespace croquis
