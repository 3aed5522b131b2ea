// SPDX-License-Identifier: MIT
#include "croquis/math/camera.h"

#include "support/random_math.h"

#include <gtest/gtest.h>

#include "croquis/base/error.h"

namespace croquis {
namespace {

const Box kBox(Vec3(-0.5, 0, -0.2), Vec3(0.5, 1.8, 0.2));

TEST(Camera, UnprojectionUndoesProjection) {
  Random random(1);
  for (const auto projection : {Camera::Projection::orthographic, Camera::Projection::perspective}) {
    Camera camera;
    camera.projection = projection;
    camera.position = Vec3(1, 2, 6);
    camera.width_px = 800;
    camera.height_px = 600;
    for (int i = 0; i < 50; ++i) {
      const Vec3 point = random_vector(random);
      const auto pixel = camera.project(point);
      ASSERT_TRUE(pixel);
      const auto back = camera.unproject(*pixel, point, camera.forward());
      ASSERT_TRUE(back);
      EXPECT_LT((*back - point).norm(), 1e-9);
    }
  }
}

TEST(Camera, ClipSpaceAgreesWithPixels) {
  for (const auto projection : {Camera::Projection::orthographic, Camera::Projection::perspective}) {
    Camera camera;
    camera.projection = projection;
    const Vec3 point(0.3, 0.7, -0.4);
    const Vec3 view = camera.view_from_world() * point;
    const Vec4 clip = camera.clip_from_view(Vec3(0, 1, 0), 3.0) * view.homogeneous();
    const Vec3 ndc = clip.head<3>() / clip.w();
    const Vec2 pixel(0.5 * (ndc.x() + 1) * camera.width_px, 0.5 * (1 - ndc.y()) * camera.height_px);
    EXPECT_LT((pixel - *camera.project(point)).norm(), 1e-9);
    EXPECT_LT(std::abs(ndc.z()), 1.0);
  }
}

TEST(Camera, APointBehindAPerspectiveCameraHasNoPicture) {
  Camera camera;
  camera.projection = Camera::Projection::perspective;
  EXPECT_FALSE(camera.project(camera.position + Vec3(0, 0, 1)));
}

TEST(Camera, NamedViewsFrameTheBoxWithATenthAround) {
  for (const View view : all_views()) {
    const Camera camera = make_view_camera(view, kBox, Vec3::UnitZ(), 1024, 768);
    EXPECT_NO_THROW(camera.check());
    Box seen;
    for (int c = 0; c < 8; ++c) {
      const Vec2 p = *camera.project(kBox.corner(static_cast<Box::CornerType>(c)));
      seen.extend(Vec3(p.x() / camera.width_px, p.y() / camera.height_px, 0.0));
    }
    EXPECT_GE(seen.min().minCoeff(), 0.0) << to_string(view);
    EXPECT_NEAR(std::min(seen.min().x(), seen.min().y()), 0.1, 1e-9) << to_string(view);
    EXPECT_NEAR(std::max(seen.max().x(), seen.max().y()), 0.9, 1e-9) << to_string(view);
    EXPECT_EQ(parse_view(to_string(view)), view);
  }
}

TEST(Camera, FrontIsTheFrontOfTheCharacter) {
  const Vec3 nose(0, 1.6, -0.2);  // of a character that faces -Z
  const Camera front = make_view_camera(View::front, kBox, -Vec3::UnitZ(), 100, 100);
  EXPECT_GT(front.forward().z(), 0.9);
  // Its left hand (+Y x -Z = -X) is on the right of the picture.
  EXPECT_GT(front.project(Vec3(-0.5, 1, 0))->x(), front.project(nose)->x());
  const Camera left = make_view_camera(View::left, kBox, Vec3::UnitZ(), 100, 100);
  EXPECT_LT(left.forward().x(), -0.9);
}

TEST(Camera, CheckNamesTheField) {
  Camera camera;
  camera.up = camera.forward();
  EXPECT_THROW(camera.check(), Error);
  camera = Camera();
  camera.target = camera.position;
  EXPECT_THROW(camera.check(), Error);
  camera = Camera();
  camera.fov_degrees = 180;
  EXPECT_THROW(camera.check(), Error);
}

TEST(Camera, AnEmptyOrFlatBoxStillHasAView) {
  for (const View view : all_views()) {
    EXPECT_NO_THROW(make_view_camera(view, Box(), Vec3::UnitZ(), 10, 10).check());
    EXPECT_NO_THROW(make_view_camera(view, Box(Vec3::Ones(), Vec3::Ones()), Vec3::Zero(), 10, 10).check());
  }
}

}  // namespace
}  // namespace croquis
