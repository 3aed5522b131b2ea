// SPDX-License-Identifier: MIT
#pragma once

#include "loa/clips.h"
#include <vector>

#include "croquis/math/camera.h"
#include "croquis/math/polyline.h"
#include "croquis/rig/body_line.h"

namespace croquis::loa {

/// One question to a method: this start pose, this stroke, this view; and the answer that is known.
struct Draw {
  const Clip* clip = nullptr;
  BodyLine line;
  Pose truth, start;
  Camera camera;
  Polyline2 stroke{{Vec2::Zero()}};
  std::vector<double> truth_along;  ///< part of the stroke's length at which each joint of the line truly lies
};

struct DrawOptions {
  int poses = 60;
  std::uint64_t seed = 1;
  int views = 2;               ///< per pose and line
  double noise_percent = 0.0;  ///< smooth hand noise: root mean square distance from the true line, per cent of H
};

struct DrawSet {
  std::vector<Clip> clips;
  std::vector<Draw> draws;
  int too_short = 0;  ///< lines shorter than 0.15 H in the picture, left out
  int too_easy = 0;   ///< the start is nearer than 6 % of H, left out
  std::vector<std::string> notes;
};

[[nodiscard]] DrawSet make_draws(const std::filesystem::path& folder, const DrawOptions& options);

}  // namespace croquis::loa
