// SPDX-License-Identifier: MIT
#include "croquis/picture/ground.h"

#include <algorithm>
#include <cmath>

namespace croquis {
namespace {

constexpr double kLeastElevation = 9.0 * kDegree;  ///< the ground is never seen flatter than this
constexpr int kCellsAcross = 320;

/// A grid of floats over the ground.
struct Grid {
  int width, depth;
  std::vector<float> values;
  Grid(int w, int d, float value)
      : width(w), depth(d), values(static_cast<std::size_t>(w) * static_cast<std::size_t>(d), value) {}
  [[nodiscard]] float& at(int x, int z) { return values[static_cast<std::size_t>(z * width + x)]; }
};

/// Writes the least height over the floor into each cell whose centre a triangle covers; corners are (column, row,
/// height). Triangles smaller than a cell count where their corner lies.
void rasterise_lowest(Grid& grid, const Vec3f& a, const Vec3f& b, const Vec3f& c) {
  const auto put = [&](int x, int z, float height) {
    if (x < 0 || z < 0 || x >= grid.width || z >= grid.depth) return;
    grid.at(x, z) = std::min(grid.at(x, z), height);
  };
  put(static_cast<int>(std::floor(a.x())), static_cast<int>(std::floor(a.y())), a.z());
  const float area = (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
  if (std::abs(area) < 1e-12F) return;
  const int x0 = std::max(0, static_cast<int>(std::floor(std::min({a.x(), b.x(), c.x()}))));
  const int x1 = std::min(grid.width - 1, static_cast<int>(std::floor(std::max({a.x(), b.x(), c.x()}))));
  const int z0 = std::max(0, static_cast<int>(std::floor(std::min({a.y(), b.y(), c.y()}))));
  const int z1 = std::min(grid.depth - 1, static_cast<int>(std::floor(std::max({a.y(), b.y(), c.y()}))));
  for (int z = z0; z <= z1; ++z) {
    for (int x = x0; x <= x1; ++x) {
      const float px = static_cast<float>(x) + 0.5F - a.x(), pz = static_cast<float>(z) + 0.5F - a.y();
      const float v = (px * (c.y() - a.y()) - pz * (c.x() - a.x())) / area;
      const float w = (pz * (b.x() - a.x()) - px * (b.y() - a.y())) / area;
      if (v >= 0.0F && w >= 0.0F && v + w <= 1.0F) put(x, z, a.z() + v * (b.z() - a.z()) + w * (c.z() - a.z()));
    }
  }
}

/// Three box blurs one after the other: near enough a Gaussian of this standard deviation, in cells.
void blur(Grid& grid, double sigma) {
  const int radius = static_cast<int>(std::lround(0.5 * (std::sqrt(4.0 * sigma * sigma + 1.0) - 1.0)));
  if (radius < 1) return;
  const auto run = [&](float* first, int count, std::ptrdiff_t stride, std::vector<float>& line) {
    line.resize(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) line[static_cast<std::size_t>(i)] = first[i * stride];
    float sum = 0.0F;
    for (int i = -radius; i < count; ++i) {
      if (i + radius < count) sum += line[static_cast<std::size_t>(i + radius)];
      if (i - radius - 1 >= 0) sum -= line[static_cast<std::size_t>(i - radius - 1)];
      if (i >= 0) first[i * stride] = std::max(0.0F, sum / static_cast<float>(2 * radius + 1));
    }
  };
  std::vector<float> line;
  for (int pass = 0; pass < 3; ++pass) {
    for (int z = 0; z < grid.depth; ++z) run(&grid.at(0, z), grid.width, 1, line);
    for (int x = 0; x < grid.width; ++x) run(&grid.at(x, 0), grid.depth, grid.width, line);
  }
}

}  // namespace

float smooth_step(float low, float high, float value) {
  const float t = std::clamp((value - low) / (high - low), 0.0F, 1.0F);
  return t * t * (3.0F - 2.0F * t);
}

Vec3 key_light_direction(const Camera& camera) {
  const Affine view = camera.view_from_world();
  const Vec3 right = view.linear().row(0);
  const Vec3 up = view.linear().row(1);
  const Vec3 back = view.linear().row(2);
  // Towards the viewer along the ground; from straight above this is the foot of the picture, where no lamp hangs:
  // there the light moves round to the head.
  Vec3 level(back.x(), 0.0, back.z());
  const Vec3 from_up(-up.x(), 0.0, -up.z());
  const double steep = std::abs(back.y());
  level = (level.norm() > 0.05 ? level : from_up).stableNormalized();
  const double t = std::clamp((steep - 0.75) / 0.2, 0.0, 1.0);
  Vec3 side(right.x(), 0.0, right.z());
  side = side.norm() > 1e-3 ? Vec3(side.normalized()) : Vec3(Vec3::UnitY().cross(level));
  return (-0.55 * side + 1.05 * Vec3::UnitY() + (0.6 - 1.0 * t) * level).normalized();
}

GroundShade::GroundShade(const Scene& scene, const Vec3& towards_light) {
  if (scene.vertices.empty()) return;
  const auto floor = static_cast<float>(scene.floor);
  const Vec3f drift = (towards_light / std::max(towards_light.y(), 0.2)).cast<float>();  // of a shadow, per height
  const auto cast = [&](const Vec3f& p) { return Vec3f(p - (p.y() - floor) * drift); };
  Box box;
  for (const SceneVertex& vertex : scene.vertices) {
    box.extend(Vec3(vertex.position.cast<double>()));
    box.extend(Vec3(cast(vertex.position).cast<double>()));
  }
  constexpr double kMargin = 0.45;
  left_ = std::max(box.min().x() - kMargin, -6.0);
  back_ = std::max(box.min().z() - kMargin, -6.0);
  const double across = std::min(box.max().x() + kMargin, 6.0) - left_;
  const double deep = std::min(box.max().z() + kMargin, 6.0) - back_;
  cell_ = std::max(across, deep) / kCellsAcross;
  width_ = std::max(1, static_cast<int>(std::ceil(across / cell_)));
  depth_ = std::max(1, static_cast<int>(std::ceil(deep / cell_)));

  constexpr float kNothing = 1e9F;
  Grid under(width_, depth_, kNothing);   // the lowest thing over each cell
  Grid shaded(width_, depth_, kNothing);  // the lowest thing between each cell and the light
  const auto cell = [&](const Vec3f& p, float height) {
    return Vec3f(static_cast<float>((p.x() - left_) / cell_), static_cast<float>((p.z() - back_) / cell_), height);
  };
  std::vector<Vec3f> below, along;
  for (const SceneVertex& vertex : scene.vertices) {
    const float height = std::max(0.0F, vertex.position.y() - floor);
    below.push_back(cell(vertex.position, height));
    along.push_back(cell(cast(vertex.position), height));
  }
  for (std::size_t i = 0; i + 2 < scene.triangles.size(); i += 3) {
    const std::uint32_t a = scene.triangles[i], b = scene.triangles[i + 1], c = scene.triangles[i + 2];
    rasterise_lowest(under, below[a], below[b], below[c]);
    rasterise_lowest(shaded, along[a], along[b], along[c]);
  }

  // What touches hides the sky in a narrow, deep seam; what hovers in a wide, faint pool.
  Grid seam(width_, depth_, 0.0F), pool(width_, depth_, 0.0F), sharp(width_, depth_, 0.0F), soft(width_, depth_, 0.0F),
      height(width_, depth_, 0.0F);
  for (std::size_t i = 0; i < under.values.size(); ++i) {
    if (under.values[i] < kNothing) {
      seam.values[i] = std::exp(-under.values[i] / 0.05F);
      pool.values[i] = std::exp(-under.values[i] / 0.30F);
    }
    if (shaded.values[i] < kNothing) {
      sharp.values[i] = soft.values[i] = 1.0F;
      height.values[i] = std::min(shaded.values[i], 2.0F);
    }
  }
  blur(seam, 0.026 / cell_);
  blur(pool, 0.11 / cell_);
  blur(sharp, 0.016 / cell_);
  blur(soft, 0.075 / cell_);
  blur(height, 0.075 / cell_);
  values_.resize(under.values.size());
  for (std::size_t i = 0; i < values_.size(); ++i) {
    const float h = soft.values[i] > 1e-4F ? height.values[i] / soft.values[i] : 1.0F;
    const float t = smooth_step(0.0F, 0.8F, h);
    values_[i].shadow =
        ((1.0F - t) * sharp.values[i] + t * soft.values[i]) * (1.0F - 0.55F * smooth_step(0.1F, 1.6F, h));
    values_[i].contact = 1.0F - (1.0F - 0.85F * seam.values[i]) * (1.0F - 0.6F * pool.values[i]);
  }
}

GroundShade::Value GroundShade::at(double x, double z) const {
  const double u = (x - left_) / cell_ - 0.5, v = (z - back_) / cell_ - 0.5;
  if (!(u > 0.0 && v > 0.0 && u < width_ - 1 && v < depth_ - 1)) return {};
  const int i = static_cast<int>(u), j = static_cast<int>(v);
  const auto s = static_cast<float>(u - i), t = static_cast<float>(v - j);
  const Value* a = values_.data() + static_cast<std::ptrdiff_t>(j) * width_ + i;
  const Value* b = a + width_;
  const auto mix = [&](float p, float q, float r, float w) {
    return (1.0F - t) * ((1.0F - s) * p + s * q) + t * ((1.0F - s) * r + s * w);
  };
  return {mix(a[0].shadow, a[1].shadow, b[0].shadow, b[1].shadow),
          mix(a[0].contact, a[1].contact, b[0].contact, b[1].contact)};
}

Mat3 ground_from_pixel(const Scene& scene, const Camera& camera) {
  const double elevation = std::asin(std::clamp(-camera.forward().y(), -1.0, 1.0));
  if (elevation < -5.0 * kDegree) return Mat3::Zero();
  const Affine world_from_view = camera.view_from_world().inverse();
  const Vec3 right = world_from_view.linear().col(0);
  const Vec3 centre(0.0, scene.floor, 0.0);
  // Tilting the ground towards the viewer about its middle, left to right.
  const double tilt = std::max(0.0, kLeastElevation - elevation);
  const Vec3 axis = Vec3(right.x(), 0.0, right.z()).stableNormalized();
  const Mat3 tilted = Eigen::AngleAxisd(tilt, axis).toRotationMatrix();
  const Vec3 normal = tilted * Vec3::UnitY();

  // The ray through a pixel, linear in (x, y, 1): origins and directions, scene space.
  const double h = camera.projection == Camera::Projection::perspective ? std::tan(0.5 * camera.fov_degrees * kDegree)
                                                                        : 0.5 * camera.height;
  const double step = 2.0 * h / camera.height_px;
  Mat3 view_from_pixel;
  view_from_pixel << step, 0.0, -0.5 * step * camera.width_px,  //
      0.0, -step, 0.5 * step * camera.height_px,                //
      0.0, 0.0, camera.projection == Camera::Projection::perspective ? -1.0 : 0.0;
  const Mat3 turned = world_from_view.linear() * view_from_pixel;
  const Eigen::RowVector3d one(0.0, 0.0, 1.0);
  const Vec3 eye = scene.from_world(camera.position);
  Mat3 hit;  // (point - centre) * w
  Eigen::RowVector3d w;
  if (camera.projection == Camera::Projection::perspective) {
    const double drop = normal.dot(centre - eye);
    if (std::abs(drop) < 1e-9) return Mat3::Zero();
    w = normal.transpose() * turned / drop;
    hit = (eye - centre) * w + turned;
  } else {
    const Vec3 forward = camera.forward();
    const Mat3 origin = turned / scene.radius + (eye - centre) * one;
    hit = origin - forward * (normal.transpose() * origin) / normal.dot(forward);
    w = one;
  }
  const Mat3 flat = tilted.transpose() * hit;
  Mat3 result;
  result.row(0) = flat.row(0) + centre.x() * w;
  result.row(1) = flat.row(2) + centre.z() * w;
  result.row(2) = w;
  return result;
}

}  // namespace croquis
