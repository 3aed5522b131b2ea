// SPDX-License-Identifier: MIT
#include "croquis/picture/ground.h"

#include <gtest/gtest.h>

#include "croquis/base/random.h"

namespace croquis {
namespace {

/// A box on (or over) the floor, as a scene.
Scene box_scene(double height_over_floor) {
  Scene scene;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3f p((corner & 1) ? 0.2F : -0.2F, (corner & 2) ? 0.5F : -0.5F, (corner & 4) ? 0.2F : -0.2F);
    scene.vertices.push_back({p, p.normalized(), Vec2f::Zero()});
  }
  for (const std::uint32_t i :
       {0, 1, 2, 1, 3, 2, 4, 6, 5, 5, 6, 7, 0, 4, 1, 1, 4, 5, 2, 3, 6, 3, 7, 6, 0, 2, 4, 2, 6, 4, 1, 5, 3, 3, 5, 7}) {
    scene.triangles.push_back(i);
  }
  scene.floor = -0.5 - height_over_floor;
  return scene;
}

Camera camera_at(const Vec3& position, Camera::Projection projection) {
  Camera camera;
  camera.projection = projection;
  camera.position = position;
  camera.target = Vec3(0.1, 1.0, -0.2);
  camera.width_px = 300;
  camera.height_px = 200;
  return camera;
}

TEST(Ground, lies_where_the_camera_sees_it) {
  Scene scene;
  scene.centre = Vec3(0.3, 0.9, -0.1);
  scene.radius = 1.7;
  scene.floor = (0.0 - 0.9) / 1.7;
  Random random(3);
  for (const auto projection : {Camera::Projection::orthographic, Camera::Projection::perspective}) {
    for (const Vec3& position : {Vec3(2, 3, 4), Vec3(-5, 4, 1), Vec3(0.1, 6, -0.1)}) {
      const Camera camera = camera_at(position, projection);
      const Mat3 ground = ground_from_pixel(scene, camera);
      for (int i = 0; i < 20; ++i) {
        const Vec3 world(random.uniform(-1, 1), 0.0, random.uniform(-1, 1));
        const auto pixel = camera.project(world);
        ASSERT_TRUE(pixel);
        const Vec3 hit = ground * Vec3(pixel->x(), pixel->y(), 1.0);
        const Vec3 expected = scene.from_world(world);
        EXPECT_GT(hit.z(), 0.0);
        EXPECT_NEAR(hit.x() / hit.z(), expected.x(), 1e-9);
        EXPECT_NEAR(hit.y() / hit.z(), expected.z(), 1e-9);
      }
    }
  }
}

TEST(Ground, is_tilted_into_view_where_it_would_be_a_line) {
  Scene scene;
  const Camera level = camera_at(Vec3(0.1, 1.0, 5.0), Camera::Projection::orthographic);
  const Mat3 ground = ground_from_pixel(scene, level);
  const auto z_at = [&](double y) {
    const Vec3 hit = ground * Vec3(150, y, 1);
    return hit.y() / hit.z();
  };
  EXPECT_GT(z_at(180), z_at(120));  // lower in the picture is nearer
  EXPECT_TRUE(ground.allFinite());
  EXPECT_TRUE(ground_from_pixel(scene, camera_at(Vec3(0, -4, 5), Camera::Projection::orthographic)).isZero());
}

TEST(Ground, is_darkest_where_it_is_touched) {
  const Vec3 light = Vec3(-0.4, 1.0, 0.3).normalized();
  const GroundShade standing(box_scene(0.0), light), hovering(box_scene(0.5), light);
  EXPECT_GT(standing.at(0, 0).contact, 0.7F);
  EXPECT_LT(hovering.at(0, 0).contact, 0.4F);
  EXPECT_GT(standing.at(0.25, 0).contact, standing.at(0.5, 0).contact);
  EXPECT_EQ(standing.at(5, 0).contact, 0.0F);
  EXPECT_EQ(standing.at(5, 0).shadow, 0.0F);
}

TEST(Ground, has_its_shadow_away_from_the_light_and_softer_with_height) {
  const Vec3 light = Vec3(-0.5, 1.0, 0.0).normalized();
  const GroundShade shade(box_scene(0.0), light);
  EXPECT_GT(shade.at(0.35, 0).shadow, 0.5F);
  EXPECT_LT(shade.at(-0.35, 0).shadow, 0.1F);
  const auto steepest = [&](const GroundShade& s) {  // of the shadow's side
    float most = 0.0F;
    for (double z = 0.0; z < 0.6; z += 0.02) most = std::max(most, s.at(0.25, z).shadow - s.at(0.25, z + 0.02).shadow);
    return most;
  };
  EXPECT_GT(steepest(shade), 1.3F * steepest(GroundShade(box_scene(0.4), light)));
}

TEST(Light, comes_from_above_and_from_the_left_of_the_picture) {
  for (const Vec3& position : {Vec3(0, 1, 5), Vec3(5, 2, 0.3), Vec3(-3, 4, -3), Vec3(0, 1.1, -6)}) {
    const Camera camera = camera_at(position, Camera::Projection::perspective);
    const Vec3 light = key_light_direction(camera);
    EXPECT_NEAR(light.norm(), 1.0, 1e-12);
    EXPECT_GT(light.y(), 0.5);
    const Vec3 seen = camera.view_from_world().linear() * light;
    EXPECT_LT(seen.x(), -0.2);
  }
  Camera top = camera_at(Vec3(0.1, 6, -0.2), Camera::Projection::orthographic);
  top.up = Vec3(0, 0, -1);
  const Vec3 seen = top.view_from_world().linear() * key_light_direction(top);
  EXPECT_LT(seen.x(), -0.2);
  EXPECT_GT(seen.y(), 0.1);  // from the head of the picture
}

}  // namespace
}  // namespace croquis
