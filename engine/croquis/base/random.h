// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace croquis {

/// A seeded random source (splitmix64): the same seed gives the same numbers on every platform and compiler, which the
/// standard library's distributions do not promise.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  [[nodiscard]] std::uint64_t bits();
  /// Uniform in [0, 1).
  [[nodiscard]] double uniform();
  /// Uniform in [low, high).
  [[nodiscard]] double uniform(double low, double high);
  /// Uniform in {0, ..., count - 1}; count > 0.
  [[nodiscard]] int index(int count);
  /// Normal with mean 0 and standard deviation 1 (Box-Muller).
  [[nodiscard]] double normal();

 private:
  std::uint64_t state_;
};

}  // namespace croquis
