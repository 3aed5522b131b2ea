// SPDX-License-Identifier: MIT
#include "croquis/posing/extract_line.h"

#include "support/test_rigs.h"
#include <cmath>

#include <gtest/gtest.h>

#include "croquis/base/error.h"
#include "croquis/posing/line_solver.h"

namespace croquis {
namespace {

Polyline2 arc(double degrees) {
  std::vector<Vec2> points;
  for (int i = 0; i <= 100; ++i) {
    const double angle = degrees * kDegree * i / 100.0;
    points.emplace_back(500 + 200 * std::cos(angle), 500 - 200 * std::sin(angle));
  }
  return Polyline2(points);
}

Polyline2 wave(double waves) {
  std::vector<Vec2> points;
  for (int i = 0; i <= 200; ++i) points.emplace_back(400 + 60 * std::sin(2 * kPi * waves * i / 200.0), 900 - 4.0 * i);
  return Polyline2(points);
}

TEST(ClassifyLine, KnowsStraightCAndS) {
  EXPECT_EQ(classify_line(Polyline2({Vec2(0, 0), Vec2(100, 300)})).shape, LineShape::straight);
  EXPECT_EQ(classify_line(arc(15)).shape, LineShape::straight);
  const LineCharacter c = classify_line(arc(120));
  EXPECT_EQ(c.shape, LineShape::c);
  ASSERT_EQ(c.bends_degrees.size(), 1U);
  EXPECT_NEAR(c.bends_degrees[0], 120, 4);  // counter-clockwise as seen
  EXPECT_NEAR(c.strength, (1 - std::cos(60 * kDegree)) / (120 * kDegree), 0.005);
  EXPECT_EQ(classify_line(wave(1.5)).shape, LineShape::compound);
  std::vector<Vec2> s;  // a quarter left, a quarter right
  for (int i = 0; i <= 50; ++i) s.emplace_back(100 * std::sin(kPi * i / 100.0), -100 * (1 - std::cos(kPi * i / 100.0)));
  for (int i = 49; i >= 0; --i)
    s.emplace_back(200 - s[static_cast<std::size_t>(i)].x(), -200 - s[static_cast<std::size_t>(i)].y());
  const LineCharacter both = classify_line(Polyline2(s));
  EXPECT_EQ(both.shape, LineShape::s);
  ASSERT_EQ(both.bends_degrees.size(), 2U);
  EXPECT_GT(both.bends_degrees[0], 0.0);
  EXPECT_LT(both.bends_degrees[1], 0.0);
}

TEST(ExtractLine, PassesThroughTheJointsAndDrawingItAgainChangesNothing) {
  Random random(8);
  for (int round = 0; round < 5; ++round) {
    const Skeleton skeleton = make_test_humanoid(round + 2);
    const Pose pose = random_pose(skeleton, random, 0.3);
    const BodyLine line{"", skeleton.path(skeleton.resolve("rightFoot"), skeleton.resolve("leftHand"))};
    const Polyline2 drawn = extract_line(skeleton, pose, line, Camera{});
    EXPECT_LT(measure_fit(skeleton, pose, line, drawn, Camera{}).max_px, 3.0);
    const LineSolverResult again = solve_lines(skeleton, {}, pose, {{line, drawn}}, Camera{});
    for (std::size_t i = 0; i < pose.local.size(); ++i) {
      EXPECT_LT(again.pose.local[i].rotation.angularDistance(pose.local[i].rotation) / kDegree, 0.1);
    }
  }
}

TEST(ExaggerateLine, ScalesBendsAndKeepsTheLength) {
  const Polyline2 c = arc(90);
  EXPECT_NEAR(classify_line(exaggerate_line(c, 2.0)).turn_degrees, 180, 6);
  EXPECT_EQ(classify_line(exaggerate_line(c, 0.0)).shape, LineShape::straight);
  EXPECT_NEAR(exaggerate_line(c, 1.7).length(), c.length(), 0.01 * c.length());
  const Polyline2 same = exaggerate_line(c, 1.0);
  for (int i = 0; i <= 10; ++i) {
    EXPECT_LT((same.at(same.length() * i / 10) - c.at(c.length() * i / 10)).norm(), 0.5);
  }
  EXPECT_THROW((void)exaggerate_line(c, 2.5), Error);
}

TEST(CurveThrough, PassesThroughItsPoints) {
  const std::vector<Vec2> points = {Vec2(0, 0), Vec2(50, 10), Vec2(60, 80), Vec2(61, 80), Vec2(200, 90)};
  const Polyline2 curve = curve_through(points, 400);
  for (const Vec2& p : points) EXPECT_LT((curve.at(curve.nearest(p)) - p).norm(), 0.5);
  EXPECT_THROW((void)curve_through({Vec2(1, 1), Vec2(1, 1)}), Error);
}

}  // namespace
}  // namespace croquis
