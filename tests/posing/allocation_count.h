// SPDX-License-Identifier: MIT
#pragma once

namespace croquis {

/// How many times this program has asked for memory so far, by new, malloc or as Eigen does; negative where that cannot
/// be counted (under a sanitizer, or without glibc).
[[nodiscard]] long allocations_so_far();

}  // namespace croquis
