// SPDX-License-Identifier: MIT
#pragma once

#include "croquis/io/bvh_text.h"
#include "croquis/math/transform.h"

namespace croquis {

inline constexpr int kBvhTellingFrames = 64;

/// Whether the positions of this file's joints lie about zero and are meant to be added to the OFFSETs (MakeHuman
/// writes so), rather than replacing them as nearly everywhere: taken over all joints but the ROOTs and the End Sites,
/// they are less than a tenth of the OFFSETs in size.
[[nodiscard]] bool bvh_positions_are_added(const BvhText& text);

/// parent_from_joint of a node in a motion row. Axes without a channel keep their OFFSET, or turn by nothing.
[[nodiscard]] Transform bvh_local_transform(const BvhNode& node, std::span<const double> row, bool positions_are_added);

/// The other way round: sets the node's numbers in `row` from parent_from_joint's translation and rotation, as far as
/// it has channels for them.
void set_bvh_row(const BvhNode& node, const Vec3& translation, const Quat& rotation, bool positions_are_added,
                 std::span<double> row);

}  // namespace croquis
