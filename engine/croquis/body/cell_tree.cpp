// SPDX-License-Identifier: MIT
#include "croquis/body/cell_tree.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace croquis {
namespace {

constexpr int kMostLevels = 11;
constexpr double kFinest =
    0.9;  ///< no form asks for cubes smaller than this times the wanted edge length, save for gaps
/// How far from its middle a cube may have surface, in diagonals. For an exact distance it would be a half; the field
/// is none, hence the margin. What it still hides is reached from the cubes beside it.
constexpr double kNear = 0.6;

}  // namespace

CellTree::CellTree(const ImplicitSurface& surface, double cell) : surface_(surface) {
  Box all;
  double finest = 1e9;
  for (const Form* form : surface.forms()) {
    const Box b = box_of(*form);
    const Vec3 margin = Vec3::Constant(0.5 * form->blend + 2.0 * form->detail);
    // A form thinner than its cubes would break into pieces.
    const double thin = std::visit([](const auto& shape) { return shape.least_radius(); }, form->shape);
    double size = std::min(cell * form->detail, std::max(thin, kFinest * form->detail));
    if (form->gap > 0.0) size = std::min(size, form->gap);
    reaches_.push_back({{Vec3(b.min() - margin), Vec3(b.max() + margin)}, size});
    finest = std::min({finest, size, kFinest * form->detail});
    if (!form->carve) all.extend(reaches_.back().box);
  }
  if (surface.mirrored()) all.min().x() = 0.0;
  const double longest = all.sizes().maxCoeff();
  while (deepest_ < kMostLevels && finest * std::ldexp(1.0, deepest_) < longest) ++deepest_;
  step_ = std::max(finest, longest * std::ldexp(1.0, -deepest_));
  origin_ = all.min();
  for (int level = 0; level <= deepest_; ++level) {
    const double size = step_ * std::ldexp(1.0, deepest_ - level);
    CellIndex count;
    for (int axis = 0; axis < 3; ++axis) {
      count[static_cast<std::size_t>(axis)] = static_cast<int>(std::floor(all.sizes()[axis] / size)) + 1;
    }
    counts_.push_back(count);
    const std::size_t cubes =
        static_cast<std::size_t>(count[0]) * static_cast<std::size_t>(count[1]) * static_cast<std::size_t>(count[2]);
    divided_.emplace_back(level < deepest_ ? cubes : 0, false);
    far_.emplace_back(level < deepest_ ? cubes : 0, false);
  }
  table_.resize(std::size_t{1} << 16U);
  reaching_.resize(reaches_.size());
  std::iota(reaching_.begin(), reaching_.end(), 0);
  for (int k = 0; k < counts_[0][2]; ++k) {
    for (int j = 0; j < counts_[0][1]; ++j) {
      for (int i = 0; i < counts_[0][0]; ++i) divide({0, {i, j, k}}, 0, true);
    }
  }
  for (std::size_t c = 0; c < near_.size(); ++c) {  // grows while it is walked
    if (!is_crossed(near_[c])) continue;
    surface_cells_.push_back(near_[c]);
    reach_beyond(near_[c]);
  }
}

bool CellTree::is_inside(const Cell& cell) const {
  const CellIndex& count = counts_[static_cast<std::size_t>(cell.level)];
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (cell.at[axis] < 0 || cell.at[axis] >= count[axis]) return false;
  }
  return true;
}

std::size_t CellTree::number(const Cell& cell) const {
  const CellIndex& count = counts_[static_cast<std::size_t>(cell.level)];
  return static_cast<std::size_t>(cell.at[0]) +
         static_cast<std::size_t>(count[0]) *
             (static_cast<std::size_t>(cell.at[1]) +
              static_cast<std::size_t>(count[1]) * static_cast<std::size_t>(cell.at[2]));
}

bool CellTree::is_set(const Flags& flags, const Cell& cell) const {
  return cell.level < deepest_ && is_inside(cell) && flags[static_cast<std::size_t>(cell.level)][number(cell)];
}

Cell CellTree::leaf_of(Cell cell) const {
  if (!is_inside(cell)) return {-1, {}};
  while (cell.level > 0) {
    const Cell above{cell.level - 1, {cell.at[0] >> 1, cell.at[1] >> 1, cell.at[2] >> 1}};
    if (is_divided(above)) break;
    cell = above;
  }
  return cell;
}

std::uint64_t CellTree::key(const CellIndex& node) const {
  return (static_cast<std::uint64_t>(node[0]) << 40U) | (static_cast<std::uint64_t>(node[1]) << 20U) |
         static_cast<std::uint64_t>(node[2]);
}

float CellTree::value(const CellIndex& node) {
  const std::uint64_t wanted = key(node);
  const std::size_t mask = table_.size() - 1;
  std::size_t place = (wanted * 0x9E3779B97F4A7C15U >> 32U) & mask;
  while (table_[place].key != wanted) {
    if (table_[place].key == Entry{}.key) {
      const float value = static_cast<float>(surface_.sample(position(node)).value);
      table_[place] = {wanted, value};
      if (2 * ++stored_ > table_.size()) grow_table();
      return value;
    }
    place = (place + 1) & mask;
  }
  return table_[place].value;
}

void CellTree::grow_table() {
  std::vector<Entry> old(2 * table_.size());
  std::swap(old, table_);
  for (const Entry& entry : old) {
    if (entry.key == Entry{}.key) continue;
    std::size_t place = (entry.key * 0x9E3779B97F4A7C15U >> 32U) & (table_.size() - 1);
    while (table_[place].key != Entry{}.key) place = (place + 1) & (table_.size() - 1);
    table_[place] = entry;
  }
}

bool CellTree::is_crossed(const Cell& cell) {
  const double far = 2.0 * kNear * std::sqrt(3.0) * step_ * std::ldexp(1.0, deepest_ - cell.level);
  int inside = 0;
  for (const int c : {0, 7, 1, 6, 2, 5, 3, 4}) {
    const float at_corner =
        value({to_steps(cell.level, cell.at[0] + (c & 1)), to_steps(cell.level, cell.at[1] + (c >> 1 & 1)),
               to_steps(cell.level, cell.at[2] + (c >> 2 & 1))});
    if (std::abs(at_corner) > far) return false;
    if (at_corner < 0.0F) ++inside;
  }
  return inside != 0 && inside != 8;
}

/// Of the forms, only those on the stack from `first_reach` on reach into the cube.
void CellTree::divide(const Cell& cell, std::size_t first_reach, bool even_if_far) {
  if (!is_inside(cell)) return;
  const double size = step_ * std::ldexp(1.0, deepest_ - cell.level);
  const Vec3 low = origin_ + size * Vec3(cell.at[0], cell.at[1], cell.at[2]);
  const Box box(low, Vec3(low + Vec3::Constant(size)));
  const std::size_t end = reaching_.size();
  double bearable = 1e9;
  for (std::size_t r = first_reach; r < end; ++r) {
    const Reach& reach = reaches_[static_cast<std::size_t>(reaching_[r])];
    if (!reach.box.intersects(box)) continue;
    reaching_.push_back(reaching_[r]);
    bearable = std::min(bearable, reach.size);
  }
  if (cell.level == deepest_ || size <= bearable * 1.0001) {
    reaching_.resize(end);
    near_.push_back(cell);
    return;
  }
  const int half = to_steps(cell.level + 1, 1);
  const CellIndex middle{to_steps(cell.level, cell.at[0]) + half, to_steps(cell.level, cell.at[1]) + half,
                         to_steps(cell.level, cell.at[2]) + half};
  const std::size_t level = static_cast<std::size_t>(cell.level), place = number(cell);
  if (!even_if_far && std::abs(value(middle)) > kNear * std::sqrt(3.0) * size) {
    far_[level][place] = true;
    reaching_.resize(end);
    return;
  }
  far_[level][place] = false;
  divided_[level][place] = true;
  for (int c = 0; c < 8; ++c) {
    divide({cell.level + 1, {2 * cell.at[0] + (c & 1), 2 * cell.at[1] + (c >> 1 & 1), 2 * cell.at[2] + (c >> 2 & 1)}},
           end, false);
  }
  reaching_.resize(end);
}

/// Divides the large cubes beside a cell that were thought to be far from the surface, where it goes on into them.
void CellTree::reach_beyond(const Cell& cell) {
  for (int side = 0; side < 6; ++side) {
    const auto axis = static_cast<std::size_t>(side / 2);
    int inside = 0;
    for (int c = 0; c < 8; ++c) {
      if ((c >> axis & 1) != side % 2) continue;
      const CellIndex node{to_steps(cell.level, cell.at[0] + (c & 1)), to_steps(cell.level, cell.at[1] + (c >> 1 & 1)),
                           to_steps(cell.level, cell.at[2] + (c >> 2 & 1))};
      if (value(node) < 0.0F) ++inside;
    }
    if (inside == 0 || inside == 4) continue;
    Cell beside = cell;
    beside.at[axis] += side % 2 == 0 ? -1 : 1;
    while (!is_divided(beside)) {
      const Cell leaf = leaf_of(beside);
      if (leaf.level < 0 || !is_set(far_, leaf)) break;
      divide(leaf, 0, true);
    }
  }
}

}  // namespace croquis
