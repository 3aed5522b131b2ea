// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "croquis/project/character.h"

namespace croquis::loa {

/// A motion clip of a humanoid, turned Y-up, with the poses that the benchmark draws from.
struct Clip {
  std::string name;
  Character character;
  double height = 0.0;      ///< leg + trunk, scene units: the H of every figure
  Pose neutral;             ///< the frame nearest to the medians of its joint rotations
  std::vector<Pose> poses;  ///< chosen by farthest-point sampling
};

/// Reads the humanoid clips of a folder, in the order of their names; `notes` receives a line for each file left out.
[[nodiscard]] std::vector<Clip> read_clips(const std::filesystem::path& folder, int poses, std::uint64_t seed,
                                           std::vector<std::string>& notes);

/// The neutral pose with the hips where `target` has them, turned about the vertical to its heading (hip line).
[[nodiscard]] Pose place_neutral(const Clip& clip, const Pose& target);

}  // namespace croquis::loa
