// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "croquis/posing/humanoid_pose.h"

namespace croquis {

/// A pose that comes with Croquis, for any humanoid.
struct ShelfPose {
  enum class Kind { body, hand };

  std::string name;
  Kind kind = Kind::body;
  HumanoidPose pose;  ///< hand shapes name fingers alone, of both hands
  /// The lowest joint belongs on the floor: whoever applies the pose lowers or lifts the hips to that.
  bool grounded = false;
};

/// The poses and hand shapes, in the order in which a shelf shows them.
[[nodiscard]] std::vector<ShelfPose> make_pose_shelf();

}  // namespace croquis
