// SPDX-License-Identifier: MIT
#pragma once

#include "croquis/io/character_file.h"

namespace croquis {

/// Reads a BVH. The skeleton stands at rest with zero rotations, every joint at its OFFSET (the root too), in the
/// file's units; an End Site is a joint named `<parent>_end`, so that a hand or a head has a bone to pose. The motion
/// is one linear clip. Rotation channels multiply in the order they stand on each joint,
///     R = R_first * R_second * R_third,
/// and position channels replace the OFFSET (for files whose positions lie about zero instead of about the OFFSETs
/// they are added to it; a root's always replace). Several ROOTs hang under a helper. A file may be as odd as
/// parse_bvh allows. Throws Error{bad_file} with the line.
[[nodiscard]] Character read_bvh(std::span<const std::byte> bytes, std::string_view file_name);

/// The character in `pose` as a BVH of one frame. From a BVH source the hierarchy comes back byte for byte, so that
/// joints, End Sites, channels, offsets, names and units stay. From any other source: every joint that is not a mere
/// helper, rest orientations turned to the world's axes, positions and ZXY rotations on the root, ZXY rotations on the
/// others, End Sites on the leaves; a leaf named `<parent>_end` becomes its parent's End Site. Numbers have 9
/// significant digits. Throws Error{unsupported}, naming the joint, where the pose moves a joint against its parent (a
/// stretched bone) that has no position channels, unless options.add_positions gives it some; where a joint has fewer
/// than three rotation channels and the pose turns it about another axis; and for PoseForm::baked.
[[nodiscard]] Bytes write_bvh(const Character& character, const Pose& pose, const WriteOptions& options = {});

}  // namespace croquis
