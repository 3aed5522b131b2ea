// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>

#include "croquis/body/body.h"
#include "croquis/math/camera.h"
#include "croquis/project/project.h"
#include "croquis/skinning/skinning.h"

namespace CLI {
class App;
}

namespace croquis::cli {

/// --view, --camera and --size: from where something is seen.
struct ViewOptions {
  std::string view = "front";
  std::string camera_file;
  std::string size = "1024x1024";

  void add_to(CLI::App& command);
  /// The camera that they mean for actors that stand as they do now.
  [[nodiscard]] Camera camera(const std::vector<Actor>& actors) const;
};

/// --heads, --shoulders, ...: the proportions of a built-in character.
struct ProportionOptions {
  Proportions proportions;
  bool given = false;

  void add_to(CLI::App& command);
  /// Throws invalid_argument if proportions were given for what is no built-in character.
  void check(const std::string& file) const;
};

/// "linear" or "dual-quaternion".
[[nodiscard]] SkinningMethod parse_skinning(const std::string& word);

}  // namespace croquis::cli
