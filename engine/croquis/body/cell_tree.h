// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "croquis/body/implicit_surface.h"

namespace croquis {

/// A cube of a CellTree: at level l the root cubes' edge is halved l times. Of a node of the lattice: its place in
/// steps of the deepest level.
using CellIndex = std::array<int, 3>;

struct Cell {
  int level = 0;
  CellIndex at{0, 0, 0};  ///< in cubes of its level
};

/// Cubes around a surface, halved again and again where a form that reaches into them asks for detail (`cell` times the
/// wanted edge length, or the gap that must stay open) and the surface is near; with the field's values at their
/// corners. Neighbours may be of very different size.
class CellTree {
 public:
  CellTree(const ImplicitSurface& surface, double cell);
  CellTree(const CellTree&) = delete;
  CellTree& operator=(const CellTree&) = delete;

  /// The undivided cubes that the surface goes through.
  [[nodiscard]] const std::vector<Cell>& surface_cells() const { return surface_cells_; }
  /// Whether the cube of that level and place has been divided; false where there is none.
  [[nodiscard]] bool is_divided(const Cell& cell) const { return is_set(divided_, cell); }
  /// The undivided cube that holds a cube of the lattice that is not divided; level -1 if it lies outside.
  [[nodiscard]] Cell leaf_of(Cell cell) const;

  [[nodiscard]] int deepest() const { return deepest_; }
  /// What is `steps` cubes of a level away from the origin, in steps of the deepest level.
  [[nodiscard]] int to_steps(int level, int steps) const { return steps << (deepest_ - level); }
  [[nodiscard]] float value(const CellIndex& node);
  [[nodiscard]] Vec3 position(const CellIndex& node) const { return origin_ + step_ * Vec3(node[0], node[1], node[2]); }
  /// A number that is the node's alone.
  [[nodiscard]] std::uint64_t key(const CellIndex& node) const;

 private:
  using Flags = std::vector<std::vector<bool>>;  // [level][cube]
  struct Reach {
    Box box;      // where a form shapes the surface
    double size;  // the largest cube that it bears
  };

  [[nodiscard]] bool is_inside(const Cell& cell) const;
  [[nodiscard]] std::size_t number(const Cell& cell) const;
  [[nodiscard]] bool is_set(const Flags& flags, const Cell& cell) const;
  [[nodiscard]] bool is_crossed(const Cell& cell);
  void divide(const Cell& cell, std::size_t first_reach, bool even_if_far);
  void reach_beyond(const Cell& cell);
  void grow_table();

  const ImplicitSurface& surface_;
  std::vector<Reach> reaches_;
  Vec3 origin_ = Vec3::Zero();
  double step_ = 1.0;  // the edge of the smallest cubes
  int deepest_ = 0;
  std::vector<CellIndex> counts_;  // [level] cubes along each axis
  Flags divided_, far_;
  std::vector<Cell> near_, surface_cells_;
  std::vector<int> reaching_;  // a stack: what reaches into the cubes that are being divided
  // Node -> value, by open addressing: a body asks for some ten thousands.
  struct Entry {
    std::uint64_t key = ~std::uint64_t{0};
    float value = 0.0F;
  };
  std::vector<Entry> table_;
  std::size_t stored_ = 0;
};

}  // namespace croquis
