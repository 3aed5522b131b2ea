// SPDX-License-Identifier: MIT
#include "cli/pictures.h"

namespace croquis::cli {

Bytes picture_of(const std::vector<Actor>& actors, const Camera& camera, const std::vector<Stroke>& strokes,
                 const PictureOptions& options) {
  std::vector<PictureActor> shown;
  for (const Actor& actor : actors) shown.push_back({actor.character.get(), &actor.pose});
  return encode_png(render_picture(shown, camera, strokes, options));
}

}  // namespace croquis::cli
