// SPDX-License-Identifier: MIT
#include "croquis/posing/line_likeness.h"

#include <cmath>

#include <gtest/gtest.h>

namespace croquis {
namespace {

/// Three joints, 100 pixels apart, one above the other at x = 500 in the usual view (1024 pixels over 2 units).
struct Upright {
  std::vector<Vec3> positions;
  Camera camera;
  Upright() {
    camera.projection = Camera::Projection::orthographic;
    camera.height = 2.0;
    const double pixel = 2.0 / camera.height_px;
    for (int k = 0; k < 3; ++k) {
      const auto ray = camera.ray(Vec2(500, 700 - 100 * k));
      positions.emplace_back(ray.origin + ray.direction);
    }
    EXPECT_NEAR((positions[1] - positions[0]).norm(), 100 * pixel, 1e-9);
  }
};

TEST(LineLikeness, AStrokeOnTheLineDiffersInNothing) {
  const Upright body;
  const auto seen = see_line({}, body.positions, {"", {0, 1, 2}}, body.camera);
  ASSERT_TRUE(seen);
  EXPECT_NEAR(seen->length, 200, 1e-6);
  EXPECT_NEAR(seen->reach, 200, 1e-6);
  const Polyline2 stroke({Vec2(500, 700), Vec2(500, 500)});
  const Unlikeness u = compare_line(*seen, stroke, true, 400);
  for (int part = 0; part < kBodyParts; ++part) {
    EXPECT_NEAR(u.away[static_cast<std::size_t>(part)], 0, 1e-9);
    EXPECT_NEAR(u.aside[static_cast<std::size_t>(part)], 0, 1e-9);
  }
  EXPECT_NEAR(u.too_long + u.longer + u.shorter, 0, 1e-9);
  // The other way round its ends are 200 pixels from where they are drawn, the middle is right: 400/3 of 400 in the
  // mean.
  const Unlikeness back = compare_line(*seen, stroke, false, 400);
  EXPECT_NEAR(back.away[0], 1.0 / 3.0, 1e-9);
  EXPECT_NEAR(back.aside[0], 0, 1e-9);
}

TEST(LineLikeness, DistancesAndLengthsAreMeasuredInBodySizesAndLogarithms) {
  const Upright body;
  const auto seen = see_line({}, body.positions, {"", {0, 1, 2}}, body.camera);
  ASSERT_TRUE(seen);
  const Unlikeness beside = compare_line(*seen, Polyline2({Vec2(540, 700), Vec2(540, 500)}), true, 400);
  EXPECT_NEAR(beside.away[0], 0.1, 1e-9);
  EXPECT_NEAR(beside.aside[0], 0.1, 1e-9);
  const Unlikeness twice = compare_line(*seen, Polyline2({Vec2(500, 700), Vec2(500, 300)}), true, 400);
  EXPECT_NEAR(twice.longer, std::log(2.0), 1e-9);
  EXPECT_NEAR(twice.too_long, std::log(2.0), 1e-9);
  EXPECT_EQ(twice.shorter, 0.0);
  const Unlikeness half = compare_line(*seen, Polyline2({Vec2(500, 700), Vec2(500, 600)}), true, 400);
  EXPECT_NEAR(half.shorter, std::log(2.0), 1e-9);
  EXPECT_EQ(half.longer, 0.0);
}

TEST(LineLikeness, ALineWithoutLengthOrBehindTheCameraIsNotSeen) {
  const Upright body;
  const std::vector<Vec3> dot(3, body.positions[0]);
  EXPECT_FALSE(see_line({}, dot, {"", {0, 1, 2}}, body.camera));
  Camera inside;
  inside.projection = Camera::Projection::perspective;
  inside.position = body.positions[2] + Vec3(0, 0, -1);
  inside.target = inside.position + Vec3(0, 0, -1);
  EXPECT_FALSE(see_line({}, body.positions, {"", {0, 1, 2}}, inside));
}

}  // namespace
}  // namespace croquis
