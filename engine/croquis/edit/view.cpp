// SPDX-License-Identifier: MIT
#include "croquis/edit/view.h"

#include <utility>
#include <vector>

#include "croquis/base/error.h"
#include "croquis/skinning/skinning.h"

namespace croquis {

Box posed_box(const Character& character, const Pose& pose) {
  std::vector<std::vector<Vec3f>> positions;
  for (PosedPart& part : pose_character(character, pose)) positions.push_back(std::move(part.positions));
  return bounding_box(character, pose, positions);
}

Camera make_named_view(const std::vector<Actor>& actors, View view, int width_px, int height_px) {
  if (actors.empty()) throw_invalid_argument("make_named_view: there is no actor to look at");
  Box box;
  for (const Actor& actor : actors) box.extend(posed_box(*actor.character, actor.pose));
  return make_view_camera(view, box, actors.front().character->front, width_px, height_px);
}

}  // namespace croquis
