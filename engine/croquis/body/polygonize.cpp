// SPDX-License-Identifier: MIT
// After marching cubes (lorensen1987); tracing the outline of each cell over its faces instead of looking it up in a
// table keeps neighbouring cells in agreement (bloomenthal1988).
#include "croquis/body/polygonize.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace croquis {
namespace {

constexpr int kBlock = 3;  // blocks of at most so many cells a side are not halved any more

/// Corner c of a cell stands at bits (x, y, z) = (c & 1, c >> 1 & 1, c >> 2 & 1). Faces run counter-clockwise from
/// outside.
constexpr int kFaces[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};

/// Whether two edges of a cell (8 * corner + corner) lie in one face: whether their four corners agree in x, y or z.
bool share_a_face(int edge_a, int edge_b) {
  const int corners[4] = {edge_a / 8, edge_a % 8, edge_b / 8, edge_b % 8};
  int all = 7, none = 7;
  for (const int c : corners) {
    all &= c;
    none &= ~c;
  }
  return (all | none) != 0;
}

/// The planes of the grid across one axis.
std::vector<double> place_planes(const ImplicitSurface& surface, const Box& box, int axis, double cell) {
  struct Span {
    double low, high, detail;
  };
  std::vector<Span> spans;
  for (const Form* form : surface.forms()) {
    const Box b = box_of(*form);
    const double margin = 0.5 * form->blend + 2.0 * form->detail;
    const double finest = form->gap > 0.0 ? std::min(form->gap / cell, form->detail) : form->detail;
    spans.push_back({b.min()[axis] - margin, b.max()[axis] + margin, finest});
  }
  std::vector<double> planes{box.min()[axis]};
  while (planes.back() < box.max()[axis]) {
    double step = 0.0;
    // A step must suit the place where it ends, too.
    double detail = 1e9, reach = planes.back();
    for (int look = 0; look < 2; ++look) {
      for (const Span& span : spans) {
        if (span.low <= reach && span.high >= planes.back()) detail = std::min(detail, span.detail);
      }
      step = cell * std::min(detail, box.sizes().maxCoeff());
      reach = planes.back() + step;
    }
    planes.push_back(planes.back() + step);
  }
  return planes;
}

class Grid {
  using Index = std::array<int, 3>;

 public:
  Grid(const ImplicitSurface& surface, double cell) : surface_(surface) {
    Box box;
    for (const Form* form : surface.forms()) {
      if (form->carve) continue;
      Box b = box_of(*form);
      const Vec3 margin = Vec3::Constant(0.5 * form->blend + 2.0 * form->detail);
      box.extend(Vec3(b.min() - margin));
      box.extend(Vec3(b.max() + margin));
    }
    if (surface.mirrored()) box.min().x() = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
      planes_[axis] = place_planes(surface, box, axis, cell);
      count_[axis] = static_cast<int>(planes_[axis].size());
    }
    values_.assign(
        static_cast<std::size_t>(count_[0]) * static_cast<std::size_t>(count_[1]) * static_cast<std::size_t>(count_[2]),
        std::nanf(""));
    marched_.assign(values_.size(), false);
  }

  Triangulation march() {
    march_block({0, 0, 0}, {count_[0] - 1, count_[1] - 1, count_[2] - 1});
    while (!beyond_.empty()) {
      const Index cell = beyond_.back();
      beyond_.pop_back();
      march_cell(cell[0], cell[1], cell[2]);
    }
    return std::move(result_);
  }

 private:
  [[nodiscard]] Vec3 at(int i, int j, int k) const {
    return {planes_[0][static_cast<std::size_t>(i)], planes_[1][static_cast<std::size_t>(j)],
            planes_[2][static_cast<std::size_t>(k)]};
  }
  [[nodiscard]] std::size_t node(int i, int j, int k) const {
    return static_cast<std::size_t>(i) +
           static_cast<std::size_t>(count_[0]) *
               (static_cast<std::size_t>(j) + static_cast<std::size_t>(count_[1]) * static_cast<std::size_t>(k));
  }
  double value(int i, int j, int k) {
    float& stored = values_[node(i, j, k)];
    if (std::isnan(stored)) stored = static_cast<float>(surface_.sample(at(i, j, k)).value);
    return stored;
  }

  /// The cells from `low` up to `high`, unless the surface is far from all of them; in halves while they are many.
  void march_block(const Index& low, const Index& high) {
    const Vec3 a = at(low[0], low[1], low[2]), b = at(high[0], high[1], high[2]);
    // The field is no exact distance, hence the margin; what it still hides is reached from the cells beside it.
    if (std::abs(surface_.sample(0.5 * (a + b)).value) > 0.8 * (b - a).norm()) return;
    std::size_t widest = 0;
    for (std::size_t axis = 1; axis < 3; ++axis) {
      if (high[axis] - low[axis] > high[widest] - low[widest]) widest = axis;
    }
    if (high[widest] - low[widest] > kBlock) {
      Index middle_high = high, middle_low = low;
      middle_high[widest] = middle_low[widest] = (low[widest] + high[widest]) / 2;
      march_block(low, middle_high);
      march_block(middle_low, high);
      return;
    }
    for (int k = low[2]; k < high[2]; ++k) {
      for (int j = low[1]; j < high[1]; ++j) {
        for (int i = low[0]; i < high[0]; ++i) march_cell(i, j, k);
      }
    }
  }

  /// The vertex where the surface crosses the edge between two corners of a cell.
  int crossing(int i, int j, int k, int corner_a, int corner_b) {
    if (corner_a > corner_b) std::swap(corner_a, corner_b);
    const int ia = i + (corner_a & 1), ja = j + (corner_a >> 1 & 1), ka = k + (corner_a >> 2 & 1);
    const int ib = i + (corner_b & 1), jb = j + (corner_b >> 1 & 1), kb = k + (corner_b >> 2 & 1);
    const std::size_t axis = ib > ia ? 0 : jb > ja ? 1 : 2;
    const auto [found, is_new] =
        crossings_.try_emplace(3 * node(ia, ja, ka) + axis, static_cast<int>(result_.positions.size()));
    if (is_new) {
      const double va = value(ia, ja, ka), vb = value(ib, jb, kb);
      const double t = std::clamp(va / (va - vb), 0.02, 0.98);
      result_.positions.push_back((1.0 - t) * at(ia, ja, ka) + t * at(ib, jb, kb));
    }
    return found->second;
  }

  void march_cell(int i, int j, int k) {
    if (marched_[node(i, j, k)]) return;
    marched_[node(i, j, k)] = true;
    int inside = 0;
    for (int c = 0; c < 8; ++c) {
      if (value(i + (c & 1), j + (c >> 1 & 1), k + (c >> 2 & 1)) < 0.0) inside |= 1 << c;
    }
    if (inside == 0 || inside == 255) return;
    for (int side = 0; side < 6; ++side) {
      Index cell{i, j, k};
      int& moved = cell[static_cast<std::size_t>(side / 2)];
      moved += side % 2 == 0 ? -1 : 1;
      if (moved < 0 || moved + 1 >= count_[side / 2] || marched_[node(cell[0], cell[1], cell[2])]) continue;
      int in = 0;
      for (const int c : kFaces[side]) in += inside >> c & 1;
      if (in != 0 && in != 4) beyond_.push_back(cell);
    }
    // Each crossed edge (named by its two corners, 8 * a + b with a < b) leads on to one other within the cell.
    int next[64];
    std::fill(std::begin(next), std::end(next), -1);
    for (const auto& face : kFaces) {
      const auto is_in = [&](int c) { return (inside >> face[c & 3] & 1) != 0; };
      const auto edge = [&](int c) {
        const int a = face[c & 3], b = face[(c + 1) & 3];
        return 8 * std::min(a, b) + std::max(a, b);
      };
      for (int c = 0; c < 4; ++c) {
        if (is_in(c) || !is_in(c + 1)) continue;  // a run of inside corners begins behind edge c ...
        int end = c + 1;
        while (is_in(end + 1)) ++end;  // ... and ends before edge `end`
        next[edge(c)] = edge(end);
      }
    }
    for (int start = 0; start < 64; ++start) {
      if (next[start] < 0) continue;
      std::vector<int>& loop = loop_;
      loop.clear();
      for (int e = start; next[e] >= 0;) {
        loop.push_back(e);
        const int following = next[e];
        next[e] = -1;
        e = following;
      }
      close(i, j, k, loop);
    }
  }

  /// Fills a loop: one triangle, two, or a star around its middle. A diagonal that lies in a face of the cell might be
  /// a neighbour's diagonal too and is never taken.
  void close(int i, int j, int k, const std::vector<int>& loop) {
    corners_.clear();
    for (const int e : loop) corners_.push_back(crossing(i, j, k, e / 8, e % 8));
    const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
      result_.triangles.push_back({corners_[a], corners_[b], corners_[c]});
    };
    if (corners_.size() == 3) return add(0, 1, 2);
    if (corners_.size() == 4) {
      const bool first = !share_a_face(loop[0], loop[2]), second = !share_a_face(loop[1], loop[3]);
      const auto apart = [&](std::size_t a, std::size_t b) {
        return (result_.positions[static_cast<std::size_t>(corners_[a])] -
                result_.positions[static_cast<std::size_t>(corners_[b])])
            .squaredNorm();
      };
      if (first && (!second || apart(0, 2) <= apart(1, 3))) {
        add(0, 1, 2);
        return add(0, 2, 3);
      }
      if (second) {
        add(1, 2, 3);
        return add(1, 3, 0);
      }
    }
    Vec3 middle = Vec3::Zero();
    for (const int v : corners_) middle += result_.positions[static_cast<std::size_t>(v)];
    const int center = static_cast<int>(result_.positions.size());
    result_.positions.push_back(middle / static_cast<double>(corners_.size()));
    for (std::size_t c = 0; c < corners_.size(); ++c) {
      result_.triangles.push_back({corners_[c], corners_[(c + 1) % corners_.size()], center});
    }
  }

  const ImplicitSurface& surface_;
  std::vector<double> planes_[3];
  int count_[3] = {0, 0, 0};
  std::vector<float> values_;  // per node; not a number: not asked for yet
  std::vector<bool> marched_;  // per cell, by its lowest node
  std::vector<Index> beyond_;  // cells that the surface goes on into
  std::unordered_map<std::size_t, int> crossings_;
  std::vector<int> loop_, corners_;
  Triangulation result_;
};

}  // namespace

Triangulation polygonize(const ImplicitSurface& surface, double cell) { return Grid(surface, cell).march(); }

}  // namespace croquis
