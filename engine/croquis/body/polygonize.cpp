// SPDX-License-Identifier: MIT
// After marching cubes (lorensen1987), the outline of each cube traced over its faces instead of looked up in a table
// (bloomenthal1988): where small cubes stand at a large one, its face is traced in their faces, and both sides agree.
#include "croquis/body/polygonize.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

#include "croquis/body/cell_tree.h"

namespace croquis {
namespace {

/// Corner c of a cube stands at bits (x, y, z) = (c & 1, c >> 1 & 1, c >> 2 & 1). Faces run counter-clockwise from
/// outside.
constexpr int kFaces[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};

class Tracer {
 public:
  Tracer(const ImplicitSurface& surface, double cell) : tree_(surface, cell) {
    for (int level = 0; level <= tree_.deepest(); ++level) waiting_.emplace_back();
  }

  Triangulation run() {
    for (const Cell& cell : tree_.surface_cells()) add(cell);
    for (std::size_t c = 0; c < cells_.size(); ++c) trace(Cell(cells_[c]));  // grows while it is walked
    return std::move(result_);
  }

 private:
  struct Crossing {
    CellIndex low, high;
  };

  [[nodiscard]] CellIndex corner(const Cell& cell, int c) const {
    return {tree_.to_steps(cell.level, cell.at[0] + (c & 1)), tree_.to_steps(cell.level, cell.at[1] + (c >> 1 & 1)),
            tree_.to_steps(cell.level, cell.at[2] + (c >> 2 & 1))};
  }

  void add(const Cell& cell) {
    const std::uint64_t key = tree_.key(cell.at);
    if (waiting_[static_cast<std::size_t>(cell.level)].insert({key, true}).second) cells_.push_back(cell);
  }

  /// Whether a cube around an edge is divided, and with it the edge: from `low` along `axis`, as long as the cubes of
  /// its level.
  [[nodiscard]] bool is_edge_divided(int level, const CellIndex& low, std::size_t axis) const {
    if (level == tree_.deepest()) return false;
    const int shift = tree_.deepest() - level;
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (int around = 0; around < 4; ++around) {
      Cell cell{level, {low[0] >> shift, low[1] >> shift, low[2] >> shift}};
      cell.at[u] -= around & 1;
      cell.at[v] -= around >> 1;
      if (tree_.is_divided(cell)) return true;
    }
    return false;
  }

  /// Appends the nodes of an edge from its first up to, without, its last.
  void add_nodes(int level, const CellIndex& from, const CellIndex& to, std::size_t axis) {
    if (!is_edge_divided(level, from[axis] < to[axis] ? from : to, axis)) {
      outline_.push_back(from);
      return;
    }
    CellIndex middle = from;
    middle[axis] = (from[axis] + to[axis]) / 2;
    add_nodes(level + 1, from, middle, axis);
    add_nodes(level + 1, middle, to, axis);
  }

  /// The vertex where the surface crosses the edge between two nodes of which the first is outside.
  int crossing(const CellIndex& a, const CellIndex& b) {
    const CellIndex low = std::min(a, b), high = std::max(a, b);
    const std::size_t axis = a[0] != b[0] ? 0 : a[1] != b[1] ? 1 : 2;
    const auto [found, is_new] =
        crossings_.try_emplace(4 * tree_.key(low) + axis, static_cast<int>(result_.positions.size()));
    if (is_new) {
      const double at_low = tree_.value(low), at_high = tree_.value(high);
      const double t = std::clamp(at_low / (at_low - at_high), 0.02, 0.98);
      result_.positions.push_back((1.0 - t) * tree_.position(low) + t * tree_.position(high));
      edges_.push_back({low, high});
    }
    return found->second;
  }

  /// What the surface leaves on the face of a cube, or of the part of one that a smaller cube beside it touches: where
  /// the face is ambiguous, the inside corners are kept apart.
  void trace_face(const Cell& cell, int side) {
    const auto axis = static_cast<std::size_t>(side / 2);
    Cell beside = cell;
    beside.at[axis] += side % 2 == 0 ? -1 : 1;
    if (tree_.is_divided(beside)) {
      for (int c = 0; c < 8; ++c) {
        if ((c >> axis & 1) != side % 2) continue;
        trace_face(
            {cell.level + 1, {2 * cell.at[0] + (c & 1), 2 * cell.at[1] + (c >> 1 & 1), 2 * cell.at[2] + (c >> 2 & 1)}},
            side);
      }
      return;
    }
    outline_.clear();
    for (std::size_t c = 0; c < 4; ++c) {
      const int a = kFaces[side][c], b = kFaces[side][(c + 1) & 3];
      add_nodes(cell.level, corner(cell, a), corner(cell, b), (a ^ b) == 1 ? 0 : (a ^ b) == 2 ? 1 : 2);
    }
    const std::size_t count = outline_.size();
    inside_.clear();
    for (const CellIndex& node : outline_) inside_.push_back(tree_.value(node) < 0.0F);
    const std::size_t before = segments_.size();
    for (std::size_t n = 0; n < count; ++n) {
      if (inside_[n] || !inside_[(n + 1) % count]) continue;  // a run of inside nodes begins behind node n ...
      std::size_t end = n + 1;
      while (inside_[(end + 1) % count]) ++end;  // ... and ends with node `end`
      const int from = crossing(outline_[n], outline_[(n + 1) % count]);
      segments_.emplace_back(from, crossing(outline_[(end + 1) % count], outline_[end % count]));
    }
    if (segments_.size() == before) return;
    const Cell leaf = tree_.leaf_of(beside);
    if (leaf.level >= 0) add(leaf);
  }

  void trace(const Cell& cell) {
    segments_.clear();
    for (int side = 0; side < 6; ++side) trace_face(cell, side);
    while (!segments_.empty()) {
      loop_.assign(1, segments_.back().first);
      int at = segments_.back().second;
      segments_.pop_back();
      while (at != loop_.front()) {
        loop_.push_back(at);
        const auto next =
            std::find_if(segments_.begin(), segments_.end(), [&](const auto& segment) { return segment.first == at; });
        at = next->second;
        *next = segments_.back();
        segments_.pop_back();
      }
      fill(cell);
    }
  }

  /// Whether two vertices of the loop lie on one side of the cube.
  [[nodiscard]] bool share_a_side(const Cell& cell, std::size_t a, std::size_t b) const {
    const Crossing &first = edges_[static_cast<std::size_t>(loop_[a])],
                   &second = edges_[static_cast<std::size_t>(loop_[b])];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (int side = 0; side < 2; ++side) {
        const int plane = tree_.to_steps(cell.level, cell.at[axis] + side);
        if (first.low[axis] == plane && first.high[axis] == plane && second.low[axis] == plane &&
            second.high[axis] == plane) {
          return true;
        }
      }
    }
    return false;
  }

  /// Fills the loop: one triangle, two, or a star around its middle. A diagonal that lies on a side of the cube might
  /// be a neighbour's diagonal too and is never taken. Two vertices make no face: the outline went along an edge and
  /// back.
  void fill(const Cell& cell) {
    const auto add_triangle = [&](std::size_t a, std::size_t b, std::size_t c) {
      result_.triangles.push_back({loop_[a], loop_[b], loop_[c]});
    };
    const auto position = [&](std::size_t n) { return result_.positions[static_cast<std::size_t>(loop_[n])]; };
    if (loop_.size() < 3) return;
    if (loop_.size() == 3) return add_triangle(0, 1, 2);
    if (loop_.size() == 4) {
      const bool first = !share_a_side(cell, 0, 2), second = !share_a_side(cell, 1, 3);
      if (first &&
          (!second || (position(0) - position(2)).squaredNorm() <= (position(1) - position(3)).squaredNorm())) {
        add_triangle(0, 1, 2);
        return add_triangle(0, 2, 3);
      }
      if (second) {
        add_triangle(1, 2, 3);
        return add_triangle(1, 3, 0);
      }
    }
    Vec3 middle = Vec3::Zero();
    for (std::size_t n = 0; n < loop_.size(); ++n) middle += position(n);
    const int center = static_cast<int>(result_.positions.size());
    result_.positions.push_back(middle / static_cast<double>(loop_.size()));
    edges_.emplace_back();
    for (std::size_t n = 0; n < loop_.size(); ++n) {
      result_.triangles.push_back({loop_[n], loop_[(n + 1) % loop_.size()], center});
    }
  }

  CellTree tree_;
  std::vector<std::unordered_map<std::uint64_t, bool>> waiting_;  // [level]: cubes that have been in line
  std::vector<Cell> cells_;
  std::unordered_map<std::uint64_t, int> crossings_;
  std::vector<Crossing> edges_;  // per vertex
  std::vector<CellIndex> outline_;
  std::vector<bool> inside_;
  std::vector<std::pair<int, int>> segments_;
  std::vector<int> loop_;
  Triangulation result_;
};

}  // namespace

Triangulation polygonize(const ImplicitSurface& surface, double cell) { return Tracer(surface, cell).run(); }

}  // namespace croquis
