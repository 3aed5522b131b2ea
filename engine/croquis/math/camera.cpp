// SPDX-License-Identifier: MIT
#include "croquis/math/camera.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/base/text.h"

namespace croquis {
namespace {

constexpr std::array<std::pair<View, std::string_view>, 6> kViewNames{{{View::front, "front"},
                                                                       {View::back, "back"},
                                                                       {View::left, "left"},
                                                                       {View::right, "right"},
                                                                       {View::top, "top"},
                                                                       {View::three_quarter, "three-quarter"}}};

/// Half the height of the view at unit distance (perspective) or everywhere (orthographic).
double half_height(const Camera& camera) {
  return camera.projection == Camera::Projection::perspective ? std::tan(0.5 * camera.fov_degrees * kDegree)
                                                              : 0.5 * camera.height;
}

void want(bool holds, std::string_view field, const std::string& wanted) {
  if (!holds) throw_invalid_argument("camera " + std::string(field) + ": wanted " + wanted);
}

}  // namespace

void Camera::check() const {
  want(position.allFinite(), "position", "three finite numbers");
  want(target.allFinite(), "target", "three finite numbers");
  want(up.allFinite(), "up", "three finite numbers");
  want((target - position).norm() > 1e-9, "target", "a point other than the position");
  want((target - position).normalized().cross(up.stableNormalized()).norm() > 1e-6, "up",
       "a direction that is not along the view");
  want(fov_degrees > 0.0 && fov_degrees < 180.0, "fov_degrees",
       "an angle between 0 and 180, got " + format_double(fov_degrees));
  want(height > 0.0 && std::isfinite(height), "height", "a positive length, got " + format_double(height));
  constexpr int kMost = 16384;
  want(width_px >= 1 && width_px <= kMost, "width", "1 to 16384 pixels, got " + std::to_string(width_px));
  want(height_px >= 1 && height_px <= kMost, "height_px", "1 to 16384 pixels, got " + std::to_string(height_px));
}

Affine Camera::view_from_world() const {
  const Vec3 back = -forward();
  const Vec3 right = up.cross(back).normalized();
  Affine view = Affine::Identity();
  view.linear().row(0) = right;
  view.linear().row(1) = back.cross(right);
  view.linear().row(2) = back;
  view.translation() = -(view.linear() * position);
  return view;
}

Mat4 Camera::clip_from_view(const Vec3& scene_centre, double scene_radius) const {
  const double distance = -(view_from_world() * scene_centre).z();
  const double radius = std::max(scene_radius, 1e-6);
  const double aspect = static_cast<double>(width_px) / height_px;
  const double h = half_height(*this);
  const double far = distance + radius;
  Mat4 clip = Mat4::Zero();
  clip(1, 1) = 1.0 / h;
  clip(0, 0) = 1.0 / (h * aspect);
  if (projection == Projection::orthographic) {
    const double near = distance - radius;
    clip(2, 2) = -2.0 / (far - near);
    clip(2, 3) = -(far + near) / (far - near);
    clip(3, 3) = 1.0;
  } else {
    const double safe_far = std::max(far, 1e-3 * radius);
    const double near = std::max(distance - radius, 1e-3 * safe_far);
    clip(2, 2) = -(safe_far + near) / (safe_far - near);
    clip(2, 3) = -2.0 * safe_far * near / (safe_far - near);
    clip(3, 2) = -1.0;
  }
  return clip;
}

std::optional<Vec2> Camera::project(const Vec3& world) const {
  const Vec3 v = view_from_world() * world;
  double scale = 0.5 * height_px / half_height(*this);
  if (projection == Projection::perspective) {
    if (v.z() > -1e-9) return std::nullopt;
    scale /= -v.z();
  }
  return Vec2(0.5 * width_px + scale * v.x(), 0.5 * height_px - scale * v.y());
}

double Camera::units_per_pixel(const Vec3& world) const {
  const double at_unit = 2.0 * half_height(*this) / height_px;
  if (projection == Projection::orthographic) return at_unit;
  return at_unit * std::max(1e-9, -(view_from_world() * world).z());
}

Camera::Ray Camera::ray(const Vec2& pixel) const {
  const double scale = 2.0 * half_height(*this) / height_px;
  const double x = (pixel.x() - 0.5 * width_px) * scale;
  const double y = (0.5 * height_px - pixel.y()) * scale;
  const Affine world_from_view = view_from_world().inverse();
  if (projection == Projection::orthographic) return {world_from_view * Vec3(x, y, 0.0), forward()};
  return {position, (world_from_view.linear() * Vec3(x, y, -1.0)).normalized()};
}

std::optional<Vec3> Camera::unproject(const Vec2& pixel, const Vec3& point, const Vec3& normal) const {
  const Ray r = ray(pixel);
  const double slope = normal.dot(r.direction);
  if (std::abs(slope) < 1e-9 * normal.norm()) return std::nullopt;
  const double distance = normal.dot(point - r.origin) / slope;
  if (projection == Projection::perspective && distance <= 0.0) return std::nullopt;
  return r.origin + distance * r.direction;
}

std::optional<View> parse_view(std::string_view name) {
  for (const auto& [view, text] : kViewNames) {
    if (name == text) return view;
  }
  return std::nullopt;
}

std::string_view to_string(View view) { return kViewNames[static_cast<std::size_t>(view)].second; }

std::vector<View> all_views() {
  std::vector<View> views;
  for (const auto& named : kViewNames) views.push_back(named.first);
  return views;
}

Camera make_view_camera(View view, const Box& box, const Vec3& front, int width_px, int height_px) {
  const bool empty = box.isEmpty() || !box.min().allFinite() || !box.max().allFinite();
  const Vec3 centre = empty ? Vec3::Zero() : Vec3(box.center());
  const Vec3 level = Vec3(front.x(), 0.0, front.z());
  const Vec3 facing = level.norm() > 1e-9 ? Vec3(level.normalized()) : Vec3::UnitZ();
  const Vec3 left = Vec3::UnitY().cross(facing);  // the character's left: +X for one that faces +Z

  Camera camera;
  Vec3 towards_camera = facing;
  switch (view) {
    case View::front:
      break;
    case View::back:
      towards_camera = -facing;
      break;
    case View::left:
      towards_camera = left;
      break;
    case View::right:
      towards_camera = -left;
      break;
    case View::top:
      towards_camera = Vec3::UnitY();
      camera.up = -facing;
      break;
    case View::three_quarter:
      towards_camera = (facing + left + 0.35 * Vec3::UnitY()).normalized();
      break;
  }
  camera.width_px = width_px;
  camera.height_px = height_px;
  camera.target = centre;
  camera.position = centre + towards_camera;  // a unit away, for the axes below
  const Affine axes = camera.view_from_world();

  Box seen;
  if (!empty) {
    for (int corner = 0; corner < 8; ++corner) {
      seen.extend(Vec3(axes * box.corner(static_cast<Box::CornerType>(corner))));
    }
  }
  constexpr double kMargin = 1.0 / 0.8;  // 10 % of the picture on every side
  const double aspect = static_cast<double>(width_px) / height_px;
  const Vec3 size = empty ? Vec3::Zero() : Vec3(seen.sizes());
  camera.height = kMargin * std::max(size.y(), size.x() / aspect);
  if (!(camera.height > 1e-9)) camera.height = 1.0;
  camera.position = centre + towards_camera * (empty ? 1.0 : std::max(1e-6, 2.0 * box.sizes().norm()));
  return camera;
}

}  // namespace croquis
