// SPDX-License-Identifier: MIT
#include "croquis/posing/live_line.h"

#include "posing/allocation_count.h"
#include "support/test_rigs.h"
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "croquis/base/error.h"

namespace croquis {
namespace {

/// From low on the left, curving up and over to the right, `count` points.
std::vector<Vec2> drawn_stroke(int count) {
  std::vector<Vec2> points;
  for (int i = 0; i < count; ++i) {
    const double t = static_cast<double>(i) / (count - 1);
    points.emplace_back(470 + 120 * t * t, 950 - 760 * t);
  }
  return points;
}

struct Body {
  Skeleton skeleton = make_test_humanoid(3);
  BodyLine line{"", skeleton.path(skeleton.resolve("leftFoot"), skeleton.resolve("head"))};
};

TEST(LiveLine, ThePoseMovesWithThePenAndNeverJumps) {
  const Body body;
  const std::vector<Vec2> stroke = drawn_stroke(300);
  LiveLine live(body.skeleton, {}, rest_pose(body.skeleton), body.line, LineInput::Direction::automatic, Camera{});
  Pose before = live.pose();
  double fastest = 0.0;
  std::size_t when = 0;
  for (std::size_t n = 2; n <= stroke.size(); ++n) {
    const Pose now = live.update(std::span(stroke).first(n));
    const double pixels = (stroke[n - 1] - stroke[n - 2]).norm();
    for (std::size_t i = 0; i < now.local.size(); ++i) {
      const double turn = now.local[i].rotation.angularDistance(before.local[i].rotation) / kDegree;
      if (turn / pixels > fastest) {
        fastest = turn / pixels;
        when = n;
      }
    }
    before = now;
  }
  EXPECT_TRUE(live.forward());
  EXPECT_LT(fastest, 2.6) << "degrees per pixel, at point " << when;
  const LineFit fit = measure_fit(body.skeleton, live.pose(), body.line, Polyline2(stroke), Camera{});
  EXPECT_LT(fit.mean_px, 12.0);
  EXPECT_LT(bone_length_drift(body.skeleton, rest_pose(body.skeleton), live.pose()), 1e-9);
}

TEST(LiveLine, LiftingThePenChangesNothing) {
  const Body body;
  const std::vector<Vec2> stroke = drawn_stroke(120);
  LiveLine live(body.skeleton, {}, rest_pose(body.skeleton), body.line, LineInput::Direction::forward, Camera{});
  for (std::size_t n = 2; n <= stroke.size(); ++n) (void)live.update(std::span(stroke).first(n));
  const Pose down = live.pose();
  const Pose up = live.update(stroke);
  for (std::size_t i = 0; i < up.local.size(); ++i) {
    EXPECT_LT(up.local[i].rotation.angularDistance(down.local[i].rotation), 1e-12);
  }
}

TEST(LiveLine, AStrokeFromTheOtherEndTurnsTheLineRound) {
  const Body body;
  std::vector<Vec2> stroke = drawn_stroke(120);
  std::reverse(stroke.begin(), stroke.end());
  LiveLine live(body.skeleton, {}, rest_pose(body.skeleton), body.line, LineInput::Direction::automatic, Camera{});
  for (std::size_t n = 2; n <= stroke.size(); ++n) (void)live.update(std::span(stroke).first(n));
  EXPECT_FALSE(live.forward());
  EXPECT_LT(measure_fit(body.skeleton, live.pose(), body.line, Polyline2(stroke), Camera{}).mean_px, 15.0);
}

TEST(LiveLine, UpdatesAllocateNothing) {
  if (allocations_so_far() < 0) GTEST_SKIP() << "memory is not counted here";
  const Body body;
  const HumanoidMap humanoid = recognise_humanoid(body.skeleton);
  const std::vector<Vec2> stroke = drawn_stroke(200);
  LineSolverOptions options;
  options.limits = make_joint_limits(body.skeleton, humanoid, LimitPreset::anatomical);
  options.floor = 0.0;
  options.balance = true;
  LiveLine live(body.skeleton, humanoid, rest_pose(body.skeleton), body.line, LineInput::Direction::forward, Camera{},
                options);
  (void)live.update(std::span(stroke).first(10));
  const long before = allocations_so_far();
  for (std::size_t n = 11; n <= stroke.size(); ++n) (void)live.update(std::span(stroke).first(n));
  EXPECT_EQ(allocations_so_far() - before, 0);
  const std::vector<double> counted(100);
  EXPECT_GT(allocations_so_far() - before, 0);
}

TEST(LiveLine, TheOtherFootStandsUntilTheLineIsAJump) {
  const Body body;
  const HumanoidMap humanoid = recognise_humanoid(body.skeleton);
  const Pose start = rest_pose(body.skeleton);
  const int other = body.skeleton.resolve("rightFoot");
  const auto foot = [&](const Pose& pose) {
    return compute_positions(body.skeleton, pose)[static_cast<std::size_t>(other)];
  };
  LineSolverOptions options;
  options.limits = make_joint_limits(body.skeleton, humanoid, LimitPreset::anatomical);
  options.floor = 0.0;
  const Vec2 ankle = *Camera{}.project(body.skeleton.rest_position(body.line.joints.front()));
  const Vec2 head = *Camera{}.project(body.skeleton.rest_position(body.line.joints.back()));
  const auto draw = [&](double lean, double lift) {
    LiveLine live(body.skeleton, humanoid, start, body.line, LineInput::Direction::forward, Camera{}, options);
    std::vector<Vec2> points;
    for (int i = 0; i < 200; ++i) {
      const double t = i / 199.0;
      points.push_back(ankle + t * (head - ankle) + Vec2(lean * t * t, -lift));
      (void)live.update(points);
    }
    return live.pose();
  };
  const Pose leaning = draw(120, 0);
  EXPECT_LT((foot(leaning) - foot(start)).norm(), 0.01);
  const Vec3 moved = compute_positions(body.skeleton, leaning)[static_cast<std::size_t>(body.line.joints.back())] -
                     body.skeleton.rest_position(body.line.joints.back());
  EXPECT_GT(moved.norm(), 0.1);
  EXPECT_GT(foot(draw(0, 400)).y(), foot(start).y() + 0.2);
}

TEST(LiveLine, TheFirstPixelsAskForLittle) {
  const Body body;
  const Pose start = rest_pose(body.skeleton);
  LiveLine live(body.skeleton, {}, start, body.line, LineInput::Direction::forward, Camera{});
  const Vec2 foot = *Camera{}.project(body.skeleton.rest_position(body.line.joints.front()));
  EXPECT_EQ(live.update(std::vector<Vec2>{foot}).local[0].rotation.coeffs(), start.local[0].rotation.coeffs());
  // Two pixels to the side: the body does not fall over.
  const Pose pose = live.update(std::vector<Vec2>{foot, foot + Vec2(2, 0)});
  const Vec3 head = compute_positions(body.skeleton, pose)[static_cast<std::size_t>(body.line.joints.back())];
  EXPECT_LT((head - body.skeleton.rest_position(body.line.joints.back())).norm(), 0.1);
}

TEST(LiveLine, BadPointsAreRefusedAndThePoseStays) {
  const Body body;
  LiveLine live(body.skeleton, {}, rest_pose(body.skeleton), body.line, LineInput::Direction::forward, Camera{});
  const Pose before = live.update(drawn_stroke(50));
  EXPECT_THROW((void)live.update(std::vector<Vec2>{Vec2(1, 1), Vec2(std::numeric_limits<double>::quiet_NaN(), 2)}),
               Error);
  EXPECT_EQ(before.local[3].rotation.coeffs(), live.pose().local[3].rotation.coeffs());
}

}  // namespace
}  // namespace croquis
