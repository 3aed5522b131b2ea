// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "croquis/math/types.h"

namespace croquis {

/// A piece of a file, in bytes from its start; end excluded.
struct TextRange {
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// What one number of a motion row says: 0, 1, 2 = X, Y, Z position, 3, 4, 5 = X, Y, Z rotation.
using BvhChannel = int;
inline constexpr std::array<std::string_view, 6> kBvhChannelNames = {"Xposition", "Yposition", "Zposition",
                                                                     "Xrotation", "Yrotation", "Zrotation"};

/// A ROOT, JOINT or End Site as it stands in the file.
struct BvhNode {
  std::string name;  ///< valid UTF-8 whatever the file holds; empty for an End Site
  int parent = -1;   ///< an earlier node; -1 for a ROOT
  bool end_site = false;
  int line = 0;
  Vec3 offset = Vec3::Zero();        ///< file units
  std::vector<BvhChannel> channels;  ///< in the file's order, no channel twice
  int first_channel = 0;             ///< where they begin in a motion row
  TextRange offset_text;             ///< the three numbers
  TextRange channels_text;           ///< "CHANNELS 3 ..."; empty if there is none

  /// Does it have that channel?
  [[nodiscard]] bool has(BvhChannel channel) const;
};

/// A BVH file as its text says it, every number checked, nothing interpreted yet.
struct BvhText {
  std::vector<BvhNode> nodes;     ///< in the file's order, parents before children
  int channel_count = 0;          ///< numbers in a motion row
  std::size_t hierarchy_end = 0;  ///< bytes of the file up to MOTION (or all)
  std::string new_line = "\n";    ///< the file's own
  std::string frame_time_text;    ///< as it is spelled; empty without a motion
  double frame_time = 0.0;        ///< seconds as stated: may be zero or negative
  int frame_count = 0;            ///< the rows that are there, whatever the file announces
  std::vector<double> values;     ///< frame_count rows of channel_count numbers
  std::vector<std::string> oddities;

  [[nodiscard]] std::span<const double> row(int frame) const {
    const auto width = static_cast<std::size_t>(channel_count);
    return std::span(values).subspan(static_cast<std::size_t>(frame) * width, width);
  }
};

/// Reads every dialect that is met: keywords in any case, tabs, CRLF, a byte order mark, rows broken over several
/// lines, joints without CHANNELS or End Site, several ROOTs, a hierarchy without MOTION, more or fewer rows than
/// announced. Throws Error{bad_file} with the line: a word out of place, a number that is none (nan and inf too) or
/// beyond 1e12, a channel twice on one joint, a row with numbers missing (unless all announced rows stand before it).
/// Stops after `most_frames` rows, without looking at what follows.
[[nodiscard]] BvhText parse_bvh(std::span<const std::byte> bytes, int most_frames = std::numeric_limits<int>::max());

}  // namespace croquis
