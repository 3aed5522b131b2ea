// SPDX-License-Identifier: MIT
// Incremental remeshing after botsch2004, with the sizing and the projection taken from the implicit surface itself.
#include "croquis/body/remesh.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "croquis/body/half_edges.h"

namespace croquis {
namespace {

struct Vertex {
  Vec3 position;
  Vec3 normal = Vec3::Zero();
  double length = 0.01;  ///< wanted length of its edges
  bool on_rim = false;
};

constexpr double kThin = 24.0 * kDegree;     ///< triangles with a smaller angle are mended at the end ...
constexpr double kTooThin = 21.0 * kDegree;  ///< ... and may not stay if the angle is as small as this

double smallest_angle(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = (b - a).normalized(), bc = (c - b).normalized(), ca = (a - c).normalized();
  const double most = std::max({-ab.dot(ca), -ab.dot(bc), -bc.dot(ca)});  // the cosine of the smallest angle
  return std::acos(std::clamp(most, -1.0, 1.0));
}

class Remesher {
 public:
  Remesher(const ImplicitSurface& surface, const Triangulation& mesh, int most_vertices)
      : surface_(surface), edges_(static_cast<int>(mesh.positions.size()), mesh.triangles) {
    for (int v = 0; v < std::ssize(mesh.positions); ++v) {
      vertices_.push_back({mesh.positions[static_cast<std::size_t>(v)]});
      vertices_.back().on_rim = edges_.is_vertex_alive(v) && edges_.is_on_rim(v);
    }
    for (Vertex& v : vertices_) project(v);
    // An equilateral mesh with edges of length l has a vertex per sqrt(3) / 2 l^2.
    double expected = 0.0;
    for (const auto& [a, b, c] : mesh.triangles) {
      const double length = (vertex(a).length + vertex(b).length + vertex(c).length) / 3.0;
      expected += 0.5 * area_vector(a, b, c).norm() / (0.866 * length * length);
    }
    scale_ = std::max(1.0, std::sqrt(expected / most_vertices));
    for (Vertex& v : vertices_) v.length *= scale_;
  }

  Triangulation run(const RemeshOptions& options) {
    for (int round = 0; round < options.rounds; ++round) {
      smooth_lengths();
      if (round > 0) split_long();
      collapse_short();
      flip();
      relax();
    }
    for (int round = 0; round < options.final_rounds; ++round) {
      flip();
      relax();
    }
    // Where mending is stuck, as it may be in a crease, moving everything a little lets it go on.
    for (int attempt = 0; attempt < 4; ++attempt) {
      for (int round = 0; round < 4 && mend_thin() > 0; ++round) {
      }
      if (!has_thinner(kTooThin)) break;
      flip();
      relax();
    }
    return collect();
  }

 private:
  Vertex& vertex(int v) { return vertices_[static_cast<std::size_t>(v)]; }
  [[nodiscard]] const Vertex& vertex(int v) const { return vertices_[static_cast<std::size_t>(v)]; }
  [[nodiscard]] double length_of(int h) const {
    return (vertex(edges_.target(h)).position - vertex(edges_.origin(h)).position).norm();
  }
  [[nodiscard]] double wanted(int h) const {
    return 0.5 * (vertex(edges_.target(h)).length + vertex(edges_.origin(h)).length);
  }
  [[nodiscard]] Vec3 area_vector(int a, int b, int c) const {
    return (vertex(b).position - vertex(a).position).cross(vertex(c).position - vertex(a).position);
  }

  void project(Vertex& v) {
    for (int step = 0; step < 2; ++step) {
      const FieldSample field = surface_.sample(v.position);
      Vec3 gradient = field.gradient;
      if (v.on_rim) gradient.x() = 0.0;
      const double steepness = gradient.squaredNorm();
      v.length = scale_ * field.detail;
      if (steepness < 1e-4) break;
      const double reach = field.detail / std::sqrt(steepness);
      v.position -= std::clamp(field.value / steepness, -reach, reach) * gradient;
      v.normal = gradient / std::sqrt(steepness);
      if (std::abs(field.value) < 0.02 * field.detail) break;  // what is left after the step is of second order
    }
  }

  void smooth_lengths() {
    for (int round = 0; round < 3; ++round) {
      for (int v = 0; v < edges_.vertex_count(); ++v) {
        if (!edges_.is_vertex_alive(v)) continue;
        edges_.neighbours(v, around_);
        double sum = 0.0, least = 1e9;
        for (const int n : around_) {
          sum += vertex(n).length;
          least = std::min(least, vertex(n).length);
        }
        const double mean = 0.5 * vertex(v).length + 0.5 * sum / static_cast<double>(around_.size());
        vertex(v).length = std::min(mean, 1.3 * least);
      }
    }
  }

  void split_long() {
    const int count = edges_.count();
    for (int h = 0; h < count; ++h) {
      if (!edges_.is_alive(h) || h < edges_.twin(h) || length_of(h) < 4.0 / 3.0 * wanted(h)) continue;
      Vertex middle;
      middle.position = 0.5 * (vertex(edges_.origin(h)).position + vertex(edges_.target(h)).position);
      middle.on_rim = edges_.twin(h) < 0;
      project(middle);
      edges_.split(h);
      vertices_.push_back(middle);
    }
  }

  // An edge that joins two vertices of the rim but is not part of it would be doubled by the mirror.
  [[nodiscard]] bool can_flip(int h) const {
    if (!edges_.can_flip(h)) return false;
    const int c = edges_.origin(HalfEdges::previous(h)), d = edges_.origin(HalfEdges::previous(edges_.twin(h)));
    return !vertex(c).on_rim || !vertex(d).on_rim;
  }

  bool can_collapse(int h) {
    if (!edges_.can_collapse(h)) return false;
    const int a = edges_.origin(h), b = edges_.target(h);
    if (vertex(a).on_rim || !vertex(b).on_rim) return true;
    const int left = edges_.origin(HalfEdges::previous(h)), right = edges_.origin(HalfEdges::previous(edges_.twin(h)));
    edges_.neighbours(a, around_);
    return std::none_of(around_.begin(), around_.end(),
                        [&](int v) { return v != b && v != left && v != right && vertex(v).on_rim; });
  }

  /// No triangle around origin(h) may turn over or grow an edge that would have to be split again.
  bool collapse_keeps_shape(int h) {
    const int a = edges_.origin(h), b = edges_.target(h);
    edges_.outgoing(a, around_);
    for (const int g : around_) {
      const int c = edges_.target(g), d = edges_.origin(HalfEdges::previous(g));
      const double far = (vertex(c).position - vertex(b).position).norm();
      if (c != b && far > 4.0 / 3.0 * 0.5 * (vertex(c).length + vertex(b).length)) return false;
      if (c == b || d == b) continue;
      const Vec3 before = area_vector(a, c, d), after = area_vector(b, c, d);
      if (before.dot(after) < 0.3 * before.norm() * after.norm()) return false;
      if (after.dot(vertex(b).normal) < 0.2 * after.norm()) return false;
    }
    return true;
  }

  void collapse_short() {
    for (int h = 0; h < edges_.count(); ++h) {
      if (!edges_.is_alive(h) || length_of(h) > 0.8 * wanted(h)) continue;
      if (!can_collapse(h) || !collapse_keeps_shape(h)) continue;
      edges_.collapse(h);
    }
  }

  void flip() {
    const auto squared = [](int x) { return x * x; };
    std::vector<int> valences = edges_.valences();
    const auto valence = [&](int v) -> int& { return valences[static_cast<std::size_t>(v)]; };
    const auto valence_excess = [&](int v) { return valence(v) - (vertex(v).on_rim ? 4 : 6); };
    for (int h = 0; h < edges_.count(); ++h) {
      const int t = edges_.is_alive(h) ? edges_.twin(h) : -1;
      if (t < 0 || h < t) continue;
      const int a = edges_.origin(h), b = edges_.target(h);
      const int c = edges_.origin(HalfEdges::previous(h)), d = edges_.origin(HalfEdges::previous(t));
      const int ea = valence_excess(a), eb = valence_excess(b), ec = valence_excess(c), ed = valence_excess(d);
      const int before = squared(ea) + squared(eb) + squared(ec) + squared(ed);
      const int after = squared(ea - 1) + squared(eb - 1) + squared(ec + 1) + squared(ed + 1);
      if (after >= before || !can_flip(h)) continue;
      const Vec3 n = area_vector(a, b, c) + area_vector(b, a, d);
      const Vec3 first = area_vector(d, c, a), second = area_vector(c, d, b);
      const double size = n.norm();
      if (first.dot(n) < 0.5 * first.norm() * size || second.dot(n) < 0.5 * second.norm() * size) continue;
      edges_.flip(h);
      --valence(a), --valence(b), ++valence(c), ++valence(d);
    }
  }

  void relax() {
    std::vector<Vec3> moved(vertices_.size());
    for (int v = 0; v < edges_.vertex_count(); ++v) {
      if (!edges_.is_vertex_alive(v)) continue;
      const Vertex& here = vertex(v);
      edges_.neighbours(v, around_);
      Vec3 sum = Vec3::Zero();
      double weights = 0.0;
      for (std::size_t n = 0; n < around_.size(); ++n) {
        if (here.on_rim && n > 0 && n + 1 < around_.size()) continue;  // along the rim only
        const Vertex& other = vertex(around_[n]);
        const double weight = 1.0 / other.length;
        sum += weight * other.position;
        weights += weight;
      }
      Vec3 step = sum / weights - here.position;
      step -= step.dot(here.normal) * here.normal;
      if (here.on_rim) step.x() = 0.0;
      moved[static_cast<std::size_t>(v)] = here.position + 0.7 * step;
    }
    for (int v = 0; v < edges_.vertex_count(); ++v) {
      if (!edges_.is_vertex_alive(v)) continue;
      vertex(v).position = moved[static_cast<std::size_t>(v)];
      project(vertex(v));
    }
  }

  [[nodiscard]] double smallest_angle(int a, int b, int c) const {
    return croquis::smallest_angle(vertex(a).position, vertex(b).position, vertex(c).position);
  }

  [[nodiscard]] bool has_thinner(double angle) const {
    for (int h = 0; h < edges_.count(); h += 3) {
      if (edges_.is_alive(h) && smallest_angle(edges_.origin(h), edges_.origin(h + 1), edges_.origin(h + 2)) < angle) {
        return true;
      }
    }
    return false;
  }

  /// The smallest angle around v if it stood at `place`; 0 if a triangle would turn its back to the surface.
  double angle_around(int v, const Vec3& place) {
    double least = kPi;
    edges_.outgoing(v, around_);
    for (const int g : around_) {
      const Vec3 &b = vertex(edges_.target(g)).position, &c = vertex(edges_.origin(HalfEdges::previous(g))).position;
      least = std::min(least, croquis::smallest_angle(place, b, c));
      if ((b - place).cross(c - place).dot(vertex(v).normal) <= 0.0) return 0.0;
    }
    return least;
  }

  bool flip_mends(int h, double before) {
    const int t = edges_.twin(h);
    if (t < 0 || !can_flip(h)) return false;
    const int a = edges_.origin(h), b = edges_.target(h);
    const int c = edges_.origin(HalfEdges::previous(h)), d = edges_.origin(HalfEdges::previous(t));
    before = std::min(before, smallest_angle(b, a, d));
    if (std::min(smallest_angle(d, c, a), smallest_angle(c, d, b)) < 1.1 * before) return false;
    const Vec3 normal = vertex(a).normal + vertex(b).normal + vertex(c).normal + vertex(d).normal;
    if (area_vector(d, c, a).dot(normal) <= 0.0 || area_vector(c, d, b).dot(normal) <= 0.0) return false;
    edges_.flip(h);
    return true;
  }

  bool collapse_mends(int h, double before) {
    if (!can_collapse(h)) return false;
    const int a = edges_.origin(h), b = edges_.target(h);
    double after = kPi;
    edges_.outgoing(a, around_);
    for (const int g : around_) {
      const int c = edges_.target(g), d = edges_.origin(HalfEdges::previous(g));
      if (c == b || d == b) continue;
      after = std::min(after, smallest_angle(b, c, d));
      if (area_vector(b, c, d).dot(vertex(b).normal + vertex(c).normal + vertex(d).normal) <= 0.0) return false;
    }
    if (after < std::max(1.1 * before, 0.5 * kThin)) return false;
    edges_.collapse(h);
    return true;
  }

  /// Moves a vertex to the place among a few around it whose triangles are best.
  bool shift_mends(int v) {
    Vertex best = vertex(v);
    double angle = 1.02 * angle_around(v, best.position);
    edges_.neighbours(v, around_);
    const std::vector<int> near = around_;
    const Vec3 here = vertex(v).position;
    bool moved = false;
    for (const int n : near) {
      for (const double part : {-0.25, 0.25}) {
        Vertex tried = vertex(v);
        tried.position = here + part * (vertex(n).position - here);
        if (tried.on_rim) tried.position.x() = here.x();
        project(tried);
        const double tried_angle = angle_around(v, tried.position);
        if (tried_angle <= angle) continue;
        angle = tried_angle;
        best = tried;
        moved = true;
      }
    }
    vertex(v) = best;
    return moved;
  }

  /// Turns, draws together or shifts what is left of thin triangles; how many it changed.
  int mend_thin() {
    int mended = 0;
    for (int first = 0; first < edges_.count(); first += 3) {
      if (!edges_.is_alive(first)) continue;
      const int a = edges_.origin(first), b = edges_.origin(first + 1), c = edges_.origin(first + 2);
      const double angle = smallest_angle(a, b, c);
      if (angle > kThin) continue;
      std::array<int, 3> sides{first, first + 1, first + 2};
      std::sort(sides.begin(), sides.end(), [&](int g, int h) { return length_of(g) < length_of(h); });
      bool changed = flip_mends(sides[2], angle) || flip_mends(sides[1], angle) || collapse_mends(sides[0], angle);
      if (!changed && edges_.twin(sides[0]) >= 0) changed = collapse_mends(edges_.twin(sides[0]), angle);
      for (const int v : {a, b, c}) changed = (!changed && shift_mends(v)) || changed;
      mended += changed ? 1 : 0;
    }
    return mended;
  }

  Triangulation collect() const {
    Triangulation result;
    std::vector<int> index(vertices_.size(), -1);
    result.triangles = edges_.triangles();
    for (auto& triangle : result.triangles) {
      for (int& v : triangle) {
        int& number = index[static_cast<std::size_t>(v)];
        if (number < 0) {
          number = static_cast<int>(result.positions.size());
          result.positions.push_back(vertex(v).position);
          if (surface_.mirrored() && vertex(v).on_rim) result.positions.back().x() = 0.0;
        }
        v = number;
      }
    }
    return result;
  }

  const ImplicitSurface& surface_;
  double scale_ = 1.0;
  HalfEdges edges_;
  std::vector<Vertex> vertices_;
  std::vector<int> around_;
};

}  // namespace

Triangulation remesh(const ImplicitSurface& surface, const Triangulation& mesh, const RemeshOptions& options) {
  return Remesher(surface, mesh, options.most_vertices).run(options);
}

}  // namespace croquis
