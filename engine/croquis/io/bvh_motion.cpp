// SPDX-License-Identifier: MIT
#include "croquis/io/bvh_motion.h"

#include <algorithm>
#include <cmath>

#include "croquis/math/rotation.h"

namespace croquis {
namespace {

/// The axes of the rotation channels in the file's order, and then those that have none.
struct RotationOrder {
  std::array<int, 3> axes = {0, 1, 2};
  int count = 0;  // of channels
};

RotationOrder rotation_order(const BvhNode& node) {
  RotationOrder order;
  std::size_t next = 0;
  for (const BvhChannel channel : node.channels) {
    if (channel >= 3) order.axes[next++] = channel - 3;
  }
  order.count = static_cast<int>(next);
  for (int axis = 0; axis < 3; ++axis) {
    if (!node.has(3 + axis)) order.axes[next++] = axis;
  }
  return order;
}

}  // namespace

bool bvh_positions_are_added(const BvhText& text) {
  double positions = 0.0, offsets = 0.0;
  for (int frame = 0; frame < std::min(text.frame_count, kBvhTellingFrames); ++frame) {
    const std::span<const double> row = text.row(frame);
    for (const BvhNode& node : text.nodes) {
      if (node.parent < 0) continue;
      for (std::size_t i = 0; i < node.channels.size(); ++i) {
        if (node.channels[i] >= 3) continue;
        positions += std::abs(row[static_cast<std::size_t>(node.first_channel) + i]);
        offsets += std::abs(node.offset[node.channels[i]]);
      }
    }
  }
  return positions < 0.1 * offsets;
}

Transform bvh_local_transform(const BvhNode& node, std::span<const double> row, bool positions_are_added) {
  Transform local;
  local.translation = node.offset;
  const bool added = positions_are_added && node.parent >= 0;
  for (std::size_t i = 0; i < node.channels.size(); ++i) {
    const double value = row[static_cast<std::size_t>(node.first_channel) + i];
    const BvhChannel channel = node.channels[i];
    if (channel < 3) {
      local.translation[channel] = (added ? node.offset[channel] : 0.0) + value;
    } else {
      // A file may count many turns; within one the conversion to radians is exact to the last digit.
      const double angle = std::remainder(value, 360.0) * kDegree;
      local.rotation = local.rotation * Quat(Eigen::AngleAxisd(angle, Vec3::Unit(channel - 3)));
    }
  }
  local.rotation.normalize();
  return local;
}

void set_bvh_row(const BvhNode& node, const Vec3& translation, const Quat& rotation, bool positions_are_added,
                 std::span<double> row) {
  const RotationOrder order = rotation_order(node);
  Vec3 angles = to_euler(order.axes, rotation);
  // The same rotation has a second set of angles, which needs no third axis where the first one does.
  const Vec3 other(angles[0] + kPi, kPi - angles[1], angles[2] + kPi);
  const auto unheld = [&](const Vec3& a) {
    double sum = 0.0;
    for (int i = order.count; i < 3; ++i) sum += std::abs(std::remainder(a[i], 2.0 * kPi));
    return sum;
  };
  if (unheld(other) < unheld(angles)) angles = other;
  const bool added = positions_are_added && node.parent >= 0;
  int turn = 0;
  for (std::size_t i = 0; i < node.channels.size(); ++i) {
    const BvhChannel channel = node.channels[i];
    double& value = row[static_cast<std::size_t>(node.first_channel) + i];
    if (channel < 3)
      value = translation[channel] - (added ? node.offset[channel] : 0.0);
    else
      value = std::remainder(angles[turn++], 2.0 * kPi) / kDegree;
  }
}

}  // namespace croquis
