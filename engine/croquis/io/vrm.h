// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "croquis/io/gltf_document.h"
#include "croquis/rig/humanoid.h"

namespace croquis {

enum class VrmKind {
  none,
  vrm0,       ///< extension VRM; faces -Z
  vrm1,       ///< extension VRMC_vrm; faces +Z
  animation,  ///< extension VRMC_vrm_animation (.vrma)
};

/// What a VRM file says about itself.
struct VrmInfo {
  VrmKind kind = VrmKind::none;
  std::vector<std::pair<HumanoidBone, int>> bones;  ///< bone -> node; the names of VRM 0.x thumbs brought to 1.0
  std::optional<Licence> licence;                   ///< from its meta, or a plain glTF's asset.copyright
};

/// Throws bad_file for a node that is not there; a bone that is not known or stands twice becomes an oddity.
[[nodiscard]] VrmInfo read_vrm(const GltfDocument& document, std::vector<std::string>& oddities);

}  // namespace croquis
