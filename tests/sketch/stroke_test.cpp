// SPDX-License-Identifier: MIT
#include "croquis/sketch/stroke.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "croquis/base/error.h"
#include "croquis/base/random.h"
#include "croquis/sketch/smoothing.h"

namespace croquis {
namespace {

Stroke stroke_through(const std::vector<Vec2>& points, bool raw_pen = false) {
  Stroke stroke;
  stroke.raw_pen = raw_pen;
  for (const Vec2& point : points) stroke.samples.push_back({point, 0.01 * static_cast<double>(stroke.samples.size())});
  return stroke;
}

double distance_to(const Polyline2& line, const Vec2& point) { return (line.at(line.nearest(point)) - point).norm(); }

/// A C-curve of radius 200 about (500, 500), sampled at the given fractions.
Vec2 on_arc(double t) {
  const double angle = kPi * (0.5 + t);
  return Vec2(500, 500) + 200.0 * Vec2(std::cos(angle), std::sin(angle));
}

std::string refusal(const Stroke& stroke) {
  try {
    check_stroke(stroke, Camera{});
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::invalid_argument);
    return error.what();
  }
  return "";
}

TEST(Stroke, BadStrokesAreRefusedWithTheReason) {
  EXPECT_NE(refusal(Stroke{}).find("two distinct points"), std::string::npos);
  EXPECT_NE(refusal(stroke_through({Vec2(3, 3), Vec2(3, 3), Vec2(3, 3)})).find("two distinct points"),
            std::string::npos);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(refusal(stroke_through({Vec2(3, 3), Vec2(nan, 3)})).find("point 1 is not finite"), std::string::npos);
  EXPECT_NE(refusal(stroke_through({Vec2(3, 3), Vec2(2049, 3)})).find("outside the view"), std::string::npos);
  EXPECT_EQ(refusal(stroke_through({Vec2(3, 3), Vec2(2047, 3)})), "");
}

TEST(Stroke, TheSpeedOfThePenDoesNotMatter) {
  std::vector<Vec2> even, uneven;
  for (int i = 0; i <= 400; ++i) {
    const double t = i / 400.0;
    even.push_back(on_arc(t));
    uneven.push_back(on_arc(t * t));
  }
  const Polyline2 a = clean_stroke(stroke_through(even)), b = clean_stroke(stroke_through(uneven));
  ASSERT_EQ(a.points().size(), 128U);
  for (std::size_t i = 0; i < a.points().size(); ++i) EXPECT_LT((a.points()[i] - b.points()[i]).norm(), 0.05);
  for (std::size_t i = 1; i < a.points().size(); ++i) {
    EXPECT_NEAR(a.arc()[i] - a.arc()[i - 1], a.length() / 127, 0.01);
  }
}

TEST(Stroke, APathFromADrawingProgramIsNotTouched) {
  const std::vector<Vec2> hooked = {Vec2(104, 100), Vec2(100, 100), Vec2(500, 100), Vec2(500, 400)};
  const Polyline2 line = clean_stroke(stroke_through(hooked));
  EXPECT_EQ(line.points().front(), hooked.front());
  EXPECT_EQ(line.points().back(), hooked.back());
  EXPECT_LT(distance_to(line, Vec2(500, 100)), 3.0);
}

TEST(Stroke, HooksOfARawPenAreCutOff) {
  std::vector<Vec2> points = {Vec2(104, 101), Vec2(102, 100.5)};
  for (int i = 0; i <= 100; ++i) points.emplace_back(100 + 4 * i, 100);
  points.emplace_back(497, 103);
  points.emplace_back(495, 104);
  const Polyline2 line = clean_stroke(stroke_through(points, true));
  EXPECT_LT((line.points().front() - Vec2(100, 100)).norm(), 1.0);
  EXPECT_LT((line.points().back() - Vec2(500, 100)).norm(), 1.0);
  EXPECT_NEAR(line.length(), 400.0, 2.0);
}

TEST(Stroke, JitterGoesAndTheShapeStays) {
  Random random(7);
  std::vector<Vec2> points;
  for (int i = 0; i <= 300; ++i) points.push_back(on_arc(i / 300.0) + Vec2(random.normal(), random.normal()));
  EXPECT_NEAR(estimate_jitter(points), 1.0, 0.25);
  const Polyline2 line = clean_stroke(stroke_through(points, true));
  EXPECT_EQ(line.points().front(), points.front());
  EXPECT_EQ(line.points().back(), points.back());
  double before = 0.0, after = 0.0;
  for (int i = 10; i <= 290; ++i) {
    const auto k = static_cast<std::size_t>(i);
    before += std::abs((points[k] - Vec2(500, 500)).norm() - 200.0) / 281;
  }
  for (int i = 5; i < 123; ++i) {
    after += std::abs((line.points()[static_cast<std::size_t>(i)] - Vec2(500, 500)).norm() - 200.0) / 118;
  }
  EXPECT_LT(after, 0.6 * before);
  EXPECT_NEAR(line.length(), 200 * kPi, 12.0);  // the raw samples are far longer
}

TEST(Stroke, CornersOfARawPenStayCorners) {
  Random random(11);
  std::vector<Vec2> points;
  for (int i = 0; i < 150; ++i) points.emplace_back(100 + 2 * i + 0.5 * random.normal(), 100 + 0.5 * random.normal());
  for (int i = 0; i <= 150; ++i) points.emplace_back(400 + 0.5 * random.normal(), 100 + 2 * i + 0.5 * random.normal());
  const Polyline2 line = clean_stroke(stroke_through(points, true));
  EXPECT_LT(distance_to(line, Vec2(400, 100)), 3.0);
}

TEST(Stroke, ASmoothRawStrokeComesBackUnchanged) {
  std::vector<Vec2> points;
  for (int i = 0; i <= 60; ++i) points.push_back(on_arc(i / 60.0));
  const Polyline2 line = clean_stroke(stroke_through(points, true));
  for (const Vec2& point : line.points()) EXPECT_NEAR((point - Vec2(500, 500)).norm(), 200.0, 0.2);
}

TEST(Stroke, AHundredThousandPointsAreNoTrouble) {
  std::vector<Vec2> points;
  Random random(3);
  for (int i = 0; i <= 100000; ++i) points.push_back(on_arc(i / 1e5) + 0.7 * Vec2(random.normal(), random.normal()));
  const Polyline2 line = clean_stroke(stroke_through(points, true));
  EXPECT_EQ(line.points().size(), 128U);
  for (const Vec2& point : line.points()) EXPECT_NEAR((point - Vec2(500, 500)).norm(), 200.0, 5.0);
}

TEST(DrawingPlane, FreeFacesTheCameraAndGroundStandsUpright) {
  Camera camera;
  camera.position = Vec3(0, 3, 4);
  camera.target = Vec3(0, 0, 0);
  EXPECT_TRUE(drawing_plane_normal(DrawingPlane::free, camera).isApprox(Vec3(0, 0.6, 0.8)));
  EXPECT_TRUE(drawing_plane_normal(DrawingPlane::ground, camera).isApprox(Vec3(0, 0, 1)));
  camera.position = Vec3(0, 5, 0);
  camera.up = Vec3(0, 0, -1);
  EXPECT_THROW((void)drawing_plane_normal(DrawingPlane::ground, camera), Error);
  camera.position = Vec3(0, 5, 0.05);
  EXPECT_THROW((void)drawing_plane_normal(DrawingPlane::ground, camera), Error) << "as good as from straight above";
  camera.position = Vec3(0, 5, 0.5);
  EXPECT_NO_THROW((void)drawing_plane_normal(DrawingPlane::ground, camera));
}

TEST(DrawingPlane, UnprojectedPointsLieOnThePlaneAndProjectBack) {
  for (const auto projection : {Camera::Projection::orthographic, Camera::Projection::perspective}) {
    Camera camera;
    camera.projection = projection;
    camera.position = Vec3(1, 3, 4);
    const Vec3 centre(0.1, 0.9, -0.2);
    const std::vector<Vec2> pixels = {Vec2(100, 200), Vec2(700, 300), Vec2(512, 900)};
    for (const auto plane : {DrawingPlane::free, DrawingPlane::ground}) {
      const std::vector<Vec3> points = unproject_stroke(pixels, camera, plane, centre);
      for (std::size_t i = 0; i < pixels.size(); ++i) {
        EXPECT_NEAR(drawing_plane_normal(plane, camera).dot(points[i] - centre), 0.0, 1e-9);
        EXPECT_LT((*camera.project(points[i]) - pixels[i]).norm(), 1e-6);
      }
    }
  }
}

TEST(DrawingPlane, ARayThatMissesThePlaneIsRefused) {
  Camera camera;  // a wide view from high above: the upper rays never come down to an upright plane behind the camera
  camera.projection = Camera::Projection::perspective;
  camera.fov_degrees = 120;
  camera.position = Vec3(0, 5, 0.5);
  camera.target = Vec3(0, 0, 0);
  EXPECT_THROW((void)unproject_stroke({Vec2(512, 1023)}, camera, DrawingPlane::ground, Vec3(0, 0, 0)), Error);
}

}  // namespace
}  // namespace croquis
