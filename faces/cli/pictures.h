// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "croquis/picture/picture.h"
#include "croquis/project/project.h"

namespace croquis::cli {

/// A PNG of actors as they stand, with strokes over them.
[[nodiscard]] Bytes picture_of(const std::vector<Actor>& actors, const Camera& camera,
                               const std::vector<Stroke>& strokes, const PictureOptions& options);

}  // namespace croquis::cli
