// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "croquis/picture/image.h"
#include "croquis/project/character.h"
#include "croquis/sketch/stroke.h"
#include "croquis/skinning/skinning.h"

namespace croquis {

struct PictureOptions {
  bool ground = true;        ///< a soft contact shadow on the paper under the figure
  bool skeleton = false;     ///< bones drawn over the body: blue on its left, red on its right, ochre in the middle
  bool transparent = false;  ///< no ground and no background: alpha 0 where nothing is drawn
  SkinningMethod skinning = SkinningMethod::linear;
};

/// One character in a pose.
struct PictureActor {
  const Character* character = nullptr;
  const Pose* pose = nullptr;
};

/// Renders actors through a camera (its width_px x height_px), with the strokes, in the camera's pixels, over them as
/// ink. A character without a mesh (a BVH) is drawn as a figure of tapered capsules, one a bone. The ground lies at
/// y = 0 if the character stands there when opened, else under the lowest point; it is never drawn over the figure.
/// The same input gives the same picture, byte for byte, on one version of the driver. Units and scale do not matter.
///
/// Needs no display and no GPU: a surfaceless EGL context with OpenGL ES 3 (Mesa). The object keeps the context, the
/// compiled shaders and the textures of the last picture: worth having for more than one. Use it from one thread at a
/// time; between calls no context is left current.
class PictureRenderer {
 public:
  /// Throws Error{internal}, saying what is missing, where there is no such context.
  PictureRenderer();
  ~PictureRenderer();
  PictureRenderer(PictureRenderer&&) noexcept;
  PictureRenderer& operator=(PictureRenderer&&) noexcept;

  /// Throws invalid_argument for a camera that cannot be (Camera::check), an actor without character or pose, and a
  /// pose that does not fit or is not finite.
  [[nodiscard]] Image render(const std::vector<PictureActor>& actors, const Camera& camera,
                             const std::vector<Stroke>& strokes = {}, const PictureOptions& options = {});

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// One picture with a renderer of its own.
[[nodiscard]] Image render_picture(const std::vector<PictureActor>& actors, const Camera& camera,
                                   const std::vector<Stroke>& strokes, const PictureOptions& options = {});

}  // namespace croquis
