// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "croquis/math/types.h"

namespace croquis {

/// A camera: where it stands, how it projects, and the picture it fills. Pixels: x to the right, y down, (0, 0) the
/// top-left corner of the picture. All lengths in scene units.
struct Camera {
  enum class Projection { perspective, orthographic };

  Projection projection = Projection::orthographic;
  Vec3 position = Vec3(0, 1, 5);
  Vec3 target = Vec3(0, 1, 0);
  Vec3 up = Vec3::UnitY();
  double fov_degrees = 27.0;  ///< perspective: the vertical angle, in (0, 180)
  double height = 2.0;        ///< orthographic: the height of the view in scene units, > 0
  int width_px = 1024;
  int height_px = 1024;

  /// Throws invalid_argument, naming the field, unless every number is finite and in range, position and target
  /// differ and `up` is not along the view.
  void check() const;

  /// World to view: x right, y up, the camera looks along -z.
  [[nodiscard]] Affine view_from_world() const;
  /// OpenGL clip space (depth -1..1); near and far enclose a sphere of `scene_radius` about `scene_centre`.
  [[nodiscard]] Mat4 clip_from_view(const Vec3& scene_centre, double scene_radius) const;
  /// The picture position of a point; nothing for a point that a perspective camera has behind it.
  [[nodiscard]] std::optional<Vec2> project(const Vec3& world) const;
  /// Scene units per pixel at the depth of `world` (orthographic: everywhere the same).
  [[nodiscard]] double units_per_pixel(const Vec3& world) const;
  [[nodiscard]] friend bool operator==(const Camera&, const Camera&) = default;
  /// Unit vector from the camera into the scene through its centre.
  [[nodiscard]] Vec3 forward() const { return (target - position).normalized(); }
  /// The ray through a pixel; `direction` is a unit vector.
  struct Ray {
    Vec3 origin;
    Vec3 direction;
  };
  [[nodiscard]] Ray ray(const Vec2& pixel) const;
  /// Where the ray through `pixel` meets the plane {x : normal . (x - point) = 0}; nothing if it never does.
  [[nodiscard]] std::optional<Vec3> unproject(const Vec2& pixel, const Vec3& point, const Vec3& normal) const;
};

/// The views that have names.
enum class View { front, back, left, right, top, three_quarter };
[[nodiscard]] std::optional<View> parse_view(std::string_view name);  // "three-quarter" for three_quarter
[[nodiscard]] std::string_view to_string(View view);
[[nodiscard]] std::vector<View> all_views();

/// The orthographic camera of a named view of something that occupies `box` and faces `front` (horizontal, world
/// space): the whole box is in the picture with a 10 % margin. `left` shows the character's left side; in `top` its
/// front points down the picture. An empty or flat box is framed as if it were 1 unit high.
[[nodiscard]] Camera make_view_camera(View view, const Box& box, const Vec3& front, int width_px, int height_px);

}  // namespace croquis
