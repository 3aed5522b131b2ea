// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "croquis/math/types.h"

namespace croquis {

/// A triangle mesh that can be edited locally. Half-edge h belongs to triangle h / 3 and runs from origin(h) to
/// origin(next(h)); twin(h) runs the other way in the neighbouring triangle, or is -1 at a rim. Triangles and vertices
/// that have gone keep their numbers until `triangles` collects what is left.
class HalfEdges {
 public:
  /// Throws invalid_argument unless the triangles form an oriented manifold (with or without rim).
  HalfEdges(int vertex_count, const std::vector<std::array<int, 3>>& triangles);

  [[nodiscard]] static int next(int h) { return h % 3 == 2 ? h - 2 : h + 1; }
  [[nodiscard]] static int previous(int h) { return h % 3 == 0 ? h + 2 : h - 1; }
  [[nodiscard]] int origin(int h) const { return origin_[static_cast<std::size_t>(h)]; }
  [[nodiscard]] int target(int h) const { return origin(next(h)); }
  [[nodiscard]] int twin(int h) const { return twin_[static_cast<std::size_t>(h)]; }
  [[nodiscard]] int count() const { return static_cast<int>(origin_.size()); }
  [[nodiscard]] int vertex_count() const { return static_cast<int>(out_.size()); }
  [[nodiscard]] bool is_alive(int h) const { return origin(h) >= 0; }
  [[nodiscard]] bool is_vertex_alive(int v) const { return out_[static_cast<std::size_t>(v)] >= 0; }

  /// The half-edges that leave v, in order around it.
  void outgoing(int v, std::vector<int>& result) const;
  /// The vertices around v, each once; whether it is on the rim.
  bool neighbours(int v, std::vector<int>& result) const;
  [[nodiscard]] bool is_on_rim(int v) const;
  /// How many vertices stand around each vertex; 0 for those that have gone.
  [[nodiscard]] std::vector<int> valences() const;

  /// Puts a new vertex, whose number is returned, in the middle of an edge.
  int split(int h);
  /// Whether the edge can be drawn together without spoiling the manifold, and doing so: target(h) stays, origin(h)
  /// goes.
  [[nodiscard]] bool can_collapse(int h) const;
  void collapse(int h);
  /// Whether the edge can be turned to join the two opposite corners, and doing so.
  [[nodiscard]] bool can_flip(int h) const;
  void flip(int h);

  [[nodiscard]] std::vector<std::array<int, 3>> triangles() const;

 private:
  void pair(int h, int other);

  std::vector<int> origin_, twin_, out_;
  mutable std::vector<int> scratch_[3];
};

}  // namespace croquis
