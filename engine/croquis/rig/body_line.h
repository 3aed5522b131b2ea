// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "croquis/rig/humanoid.h"
#include "croquis/rig/skeleton.h"

namespace croquis {

/// Joints j_0, ..., j_{k-1}, k > 1, each the parent of the next (source: the lines-of-action report, section II-B).
using SkeletonSegment = std::vector<int>;

/// A path in the joint tree, in the order in which a stroke passes it. It may climb to a common ancestor and descend
/// again, so it is one segment, or two that share their root.
struct BodyLine {
  std::string name;
  std::vector<int> joints;  ///< neighbours are parent and child, either way round; at least two, no joint twice
};

/// The selection rule of the report (section IV-B): every selected joint whose parent is not selected is a root, each
/// selected child of a root starts a segment, and segments go on through single selected children. Throws
/// invalid_argument, naming the joint, if a selected joint that is no root has two selected children, if a joint is
/// selected alone, or if nothing is selected. Segments come out in index order of their roots and children.
[[nodiscard]] std::vector<SkeletonSegment> segments_of_selection(const Skeleton& skeleton,
                                                                 std::span<const int> selection);

/// The path through the named joints in the order given, joints left out between two neighbours filled in. Throws
/// invalid_argument, naming the joint, if the way comes back to a joint it has passed.
[[nodiscard]] BodyLine make_body_line(const Skeleton& skeleton, std::span<const int> joints);

/// The one or two segments that a body line consists of, the one that climbs turned round: both start at the topmost
/// joint of the line.
[[nodiscard]] std::vector<SkeletonSegment> segments_of_line(const Skeleton& skeleton, const BodyLine& line);

/// The body lines that this skeleton offers, the default one first. Of a humanoid (named by their ends and parts): hips
/// to head, feet to head, hand to hand, foot to hand, trunk, arms, legs; of any other tree: its longest path, and the
/// paths between its ends and from the root to its ends ("tail_end-head", ...), at most 64.
[[nodiscard]] std::vector<BodyLine> standard_body_lines(const Skeleton& skeleton, const HumanoidMap& humanoid);

/// The standard line of that name; throws invalid_argument with the names there are.
[[nodiscard]] BodyLine find_body_line(const Skeleton& skeleton, const HumanoidMap& humanoid, std::string_view name);

}  // namespace croquis
