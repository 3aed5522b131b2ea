// SPDX-License-Identifier: MIT
#include "croquis/body/half_edges.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <string>
#include <utility>

#include "croquis/base/error.h"

namespace croquis {

HalfEdges::HalfEdges(int vertex_count, const std::vector<std::array<int, 3>>& triangles)
    : twin_(3 * triangles.size(), -1), out_(static_cast<std::size_t>(vertex_count), -1) {
  origin_.reserve(3 * triangles.size());
  // Sorted by their ends, a half-edge and its twin stand side by side. By the lower end at once: it has few.
  std::vector<std::size_t> first(static_cast<std::size_t>(vertex_count) + 1, 0);
  for (const auto& triangle : triangles) {
    for (std::size_t c = 0; c < 3; ++c)
      ++first[static_cast<std::size_t>(std::min(triangle[c], triangle[(c + 1) % 3])) + 1];
  }
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<std::pair<std::uint64_t, int>> edges(3 * triangles.size());
  std::vector<std::size_t> filled(first.begin(), first.end() - 1);
  for (const auto& triangle : triangles) {
    for (std::size_t c = 0; c < 3; ++c) {
      const int h = static_cast<int>(origin_.size());
      const int a = triangle[c], b = triangle[(c + 1) % 3];
      origin_.push_back(a);
      out_[static_cast<std::size_t>(a)] = h;
      const auto low = static_cast<std::uint64_t>(std::min(a, b)), high = static_cast<std::uint64_t>(std::max(a, b));
      edges[filled[low]++] = {low << 32U | high, h};
    }
  }
  for (std::size_t v = 0; v + 1 < first.size(); ++v) {
    std::sort(edges.begin() + static_cast<std::ptrdiff_t>(first[v]),
              edges.begin() + static_cast<std::ptrdiff_t>(first[v + 1]));
  }
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    if (edges[i].first != edges[i + 1].first) continue;
    const int h = edges[i].second, other = edges[i + 1].second;
    const bool third = i + 2 < edges.size() && edges[i + 2].first == edges[i].first;
    if (third || origin(h) == origin(other)) {
      throw_invalid_argument("HalfEdges: edge " + std::to_string(origin(h)) + "-" + std::to_string(target(h)) +
                             " is no edge between two triangles that turn the same way");
    }
    pair(h, other);
  }
}

void HalfEdges::pair(int h, int other) {
  if (h >= 0) twin_[static_cast<std::size_t>(h)] = other;
  if (other >= 0) twin_[static_cast<std::size_t>(other)] = h;
}

void HalfEdges::outgoing(int v, std::vector<int>& result) const {
  result.clear();
  const int start = out_[static_cast<std::size_t>(v)];
  int h = start;
  do {
    result.push_back(h);
    h = twin(previous(h));
  } while (h >= 0 && h != start);
  if (h == start) return;
  for (h = twin(start); h >= 0; h = twin(h)) {  // met the rim: go round the other way for the rest
    h = next(h);
    result.insert(result.begin(), h);
  }
}

bool HalfEdges::neighbours(int v, std::vector<int>& result) const {
  outgoing(v, result);
  const int last = previous(result.back());
  const bool on_rim = twin(last) < 0;
  for (int& h : result) h = target(h);
  if (on_rim) result.push_back(origin(last));
  return on_rim;
}

bool HalfEdges::is_on_rim(int v) const {
  outgoing(v, scratch_[0]);
  return twin(scratch_[0].front()) < 0;
}

std::vector<int> HalfEdges::valences() const {
  std::vector<int> result(out_.size(), 0);
  for (int h = 0; h < count(); ++h) {
    if (!is_alive(h)) continue;
    ++result[static_cast<std::size_t>(origin(h))];
    if (twin(h) < 0) ++result[static_cast<std::size_t>(target(h))];
  }
  return result;
}

int HalfEdges::split(int h) {
  const int m = vertex_count(), a = origin(h), b = target(h);
  const int t = twin(h);
  const int first = count();
  const auto add = [&](int x, int y, int z) {
    for (const int v : {x, y, z}) {
      origin_.push_back(v);
      twin_.push_back(-1);
    }
  };
  out_.push_back(next(h));
  // (a, b, c) becomes (a, m, c) and (m, b, c).
  const int hn = next(h), c = origin(previous(h)), beyond = twin(hn);
  add(m, b, c);
  origin_[static_cast<std::size_t>(hn)] = m;
  pair(first + 1, beyond);
  pair(first + 2, hn);
  out_[static_cast<std::size_t>(b)] = first + 1;
  out_[static_cast<std::size_t>(c)] = first + 2;
  if (t >= 0) {  // (b, a, d) becomes (b, m, d) and (m, a, d)
    const int tn = next(t), d = origin(previous(t)), beyond_t = twin(tn);
    const int second = count();
    add(m, a, d);
    origin_[static_cast<std::size_t>(tn)] = m;
    pair(second + 1, beyond_t);
    pair(second + 2, tn);
    pair(t, first);
    pair(h, second);
    out_[static_cast<std::size_t>(a)] = second + 1;
    out_[static_cast<std::size_t>(d)] = second + 2;
    out_[static_cast<std::size_t>(b)] = t;
  } else {
    twin_[static_cast<std::size_t>(first)] = -1;
  }
  out_[static_cast<std::size_t>(m)] = hn;
  return m;
}

bool HalfEdges::can_collapse(int h) const {
  const int a = origin(h), b = target(h), t = twin(h);
  auto &around_a = scratch_[1], &around_b = scratch_[2];
  const bool rim_a = neighbours(a, around_a), rim_b = neighbours(b, around_b);
  if (rim_a && (!rim_b || t >= 0)) return false;  // the rim stays where it is; two rims never meet
  std::ptrdiff_t common = 0;
  for (const int v : around_a) common += std::count(around_b.begin(), around_b.end(), v);
  if (common != (t >= 0 ? 2 : 1)) return false;
  const auto keeps_corner = [&](int side) {
    const int c = origin(previous(side));
    if (twin(next(side)) < 0 || twin(previous(side)) < 0) return false;
    neighbours(c, scratch_[0]);
    return scratch_[0].size() > 3;
  };
  return keeps_corner(h) && (t < 0 || keeps_corner(t));
}

void HalfEdges::collapse(int h) {
  const int a = origin(h), b = target(h), t = twin(h);
  std::vector<int>& around = scratch_[0];
  outgoing(a, around);
  for (const int g : around) origin_[static_cast<std::size_t>(g)] = b;
  for (const int side : {h, t}) {
    if (side < 0) continue;
    const int n = next(side), p = previous(side);
    const int c = origin(p), left = twin(n), right = twin(p);
    pair(left, right);
    // left runs c -> b (seen from outside), right runs b -> c.
    out_[static_cast<std::size_t>(c)] = left;
    out_[static_cast<std::size_t>(b)] = right;
    for (const int dead : {side, n, p}) origin_[static_cast<std::size_t>(dead)] = -1;
  }
  out_[static_cast<std::size_t>(a)] = -1;
}

bool HalfEdges::can_flip(int h) const {
  const int t = twin(h);
  if (t < 0) return false;
  const int c = origin(previous(h)), d = origin(previous(t));
  neighbours(c, scratch_[0]);
  if (std::find(scratch_[0].begin(), scratch_[0].end(), d) != scratch_[0].end()) return false;
  for (const int end : {origin(h), target(h)}) {
    neighbours(end, scratch_[0]);
    if (scratch_[0].size() <= 3) return false;
  }
  return true;
}

void HalfEdges::flip(int h) {
  const int t = twin(h), hn = next(h), hp = previous(h), tn = next(t), tp = previous(t);
  const int a = origin(h), b = origin(t), c = origin(hp), d = origin(tp);
  const int ca = twin(hp), ad = twin(tn), db = twin(tp), bc = twin(hn);
  const auto set = [&](int half, int from, int across) {
    origin_[static_cast<std::size_t>(half)] = from;
    out_[static_cast<std::size_t>(from)] = half;
    pair(half, across);
    if (across < 0) twin_[static_cast<std::size_t>(half)] = -1;
  };
  set(h, d, t);  // (d, c, a) and (c, d, b)
  set(hn, c, ca);
  set(hp, a, ad);
  origin_[static_cast<std::size_t>(t)] = c;
  set(tn, d, db);
  set(tp, b, bc);
}

std::vector<std::array<int, 3>> HalfEdges::triangles() const {
  std::vector<std::array<int, 3>> result;
  for (int h = 0; h < count(); h += 3) {
    if (is_alive(h)) result.push_back({origin(h), origin(h + 1), origin(h + 2)});
  }
  return result;
}

}  // namespace croquis
