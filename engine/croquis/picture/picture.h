// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "croquis/project/character.h"
#include "croquis/sketch/stroke.h"
#include "croquis/skinning/skinning.h"

namespace croquis {

/// 8-bit RGBA, row by row from the top.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;
};

struct PictureOptions {
  bool ground = true;        ///< paper-like ground with a soft contact shadow
  bool skeleton = false;     ///< bones drawn over the body
  bool transparent = false;  ///< no ground and no background: alpha 0 where nothing is drawn
  SkinningMethod skinning = SkinningMethod::linear;
};

/// One character in a pose.
struct PictureActor {
  const Character* character = nullptr;
  const Pose* pose = nullptr;
};

/// Renders actors through a camera (its width_px x height_px), with the strokes, in the camera's pixels, over them as
/// ink. Needs no display and no GPU: a surfaceless EGL context (Mesa). Throws Error{internal} if there is none.
[[nodiscard]] Image render_picture(const std::vector<PictureActor>& actors, const Camera& camera,
                                   const std::vector<Stroke>& strokes, const PictureOptions& options = {});

[[nodiscard]] Bytes encode_png(const Image& image);

}  // namespace croquis
