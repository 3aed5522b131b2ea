// SPDX-License-Identifier: MIT
#include "croquis/project/set_down.h"

#include <utility>
#include <vector>

#include "croquis/base/error.h"

namespace croquis {

Character set_down(Character character, const Vec3& shift) {
  if (!shift.allFinite()) throw_invalid_argument("set_down: the shift is not finite");
  std::vector<Joint> joints = character.skeleton.joints();
  joints.front().rest.translation += shift;
  character.start.local.front().translation += shift;
  character.skeleton = Skeleton(std::move(joints));
  return character;
}

}  // namespace croquis
