// SPDX-License-Identifier: MIT
// What every answer of the line solver promises, on bodies of every kind and on files that people use.
#include "support/data.h"
#include "support/test_rigs.h"
#include <chrono>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "croquis/base/error.h"
#include "croquis/math/rotation.h"
#include "croquis/posing/extract_line.h"
#include "croquis/posing/line_solver.h"
#include "croquis/posing/live_line.h"
#include "croquis/rig/joint_limits.h"

namespace croquis {
namespace {

/// A hand without humanoid names: five fingers that all hang on one joint.
Skeleton make_flat_hand(std::uint64_t seed) {
  std::vector<PlacedJoint> placed{{"wrist", -1, Vec3::Zero()}};
  for (int finger = 0; finger < 5; ++finger) {
    const double side = 0.03 * (finger - 2);
    for (int k = 0; k < 4; ++k) {
      const int parent = k == 0 ? 0 : static_cast<int>(placed.size()) - 1;
      placed.push_back({"f" + std::to_string(finger) + std::to_string(k), parent, Vec3(side, 0.08 + 0.03 * k, 0)});
    }
  }
  return make_skeleton(placed, seed);
}

Skeleton make_body(int kind, std::uint64_t seed) {
  switch (kind) {
    case 0:
      return make_test_humanoid(seed);
    case 1:
      return make_test_quadruped(seed);
    case 2:
      return make_chain(60, 0.03, seed);
    case 3:
      return make_flat_hand(seed);
    default:
      return make_chain(7, 0.2, seed);
  }
}

Camera camera_on(const Skeleton& skeleton, const Pose& pose, bool perspective, double azimuth) {
  Vec3 centre = Vec3::Zero();
  for (const Vec3& x : compute_positions(skeleton, pose)) centre += x / skeleton.joint_count();
  Camera camera;
  camera.target = centre;
  camera.height = 2.0 * skeleton.extent();
  camera.projection = perspective ? Camera::Projection::perspective : Camera::Projection::orthographic;
  camera.position = centre + 4.0 * skeleton.extent() * Vec3(std::sin(azimuth), 0.2, std::cos(azimuth));
  return camera;
}

/// A path of three joints or more; none if the body has no such path.
BodyLine random_line(const Skeleton& skeleton, Random& random) {
  for (int attempt = 0; attempt < 50; ++attempt) {
    std::vector<int> path = skeleton.path(random.index(skeleton.joint_count()), random.index(skeleton.joint_count()));
    if (path.size() >= 3) return {"", std::move(path)};
  }
  return {};
}

Polyline2 scribble(Random& random, int corners) {
  std::vector<Vec2> points;
  for (int i = 0; i < corners; ++i) points.emplace_back(random.uniform(150, 870), random.uniform(150, 870));
  return curve_through(points);
}

void expect_promises(const Skeleton& skeleton, const LineSolverResult& result, const LineSolverOptions& options,
                     const Pose& start) {
  for (const Transform& local : result.pose.local) ASSERT_TRUE(local.is_finite());
  EXPECT_LT(bone_length_drift(skeleton, start, result.pose), 1e-9);
  EXPECT_TRUE(std::isfinite(result.report.residual));
  // A limit may only be broken where the start pose broke it.
  const std::vector<int> before = find_limit_violations(options.limits, start);
  for (const int joint : find_limit_violations(options.limits, result.pose)) {
    EXPECT_EQ(std::count(before.begin(), before.end(), joint), 1) << skeleton.reference(joint);
  }
  const std::vector<Vec3> x = compute_positions(skeleton, result.pose);
  for (const PosePin& pin : options.pins) {
    const bool missed = std::count(result.pins_missed.begin(), result.pins_missed.end(), pin.joint) > 0;
    const double miss = (x[static_cast<std::size_t>(pin.joint)] - pin.position).norm();
    EXPECT_EQ(missed, miss > 1e-4 * skeleton.extent());
    if (missed) {
      EXPECT_NE(result.report.status, "ok");
    }
  }
}

TEST(Guarantees, HoldOnEveryKindOfBody) {
  Random random(2026);
  for (int round = 0; round < 30; ++round) {
    const std::uint64_t seed = random.bits() | 1U;
    SCOPED_TRACE("kind " + std::to_string(round % 5) + ", seed " + std::to_string(seed));
    Random own(seed);
    const Skeleton skeleton = make_body(round % 5, seed);
    const HumanoidMap humanoid = recognise_humanoid(skeleton);
    const Pose start = random_pose(skeleton, own, 0.3);
    const Camera camera = camera_on(skeleton, start, round % 2 == 1, own.uniform(0, 6.28));
    LineInput input{random_line(skeleton, own), scribble(own, 2 + own.index(4))};
    LineSolverOptions options;
    options.iterations = 8;
    options.limits = make_joint_limits(skeleton, humanoid, LimitPreset::anatomical);
    options.length = static_cast<LengthPolicy>(own.index(4));
    options.move_body = own.index(2) == 0;
    options.lock_root = own.index(3) == 0;
    if (own.index(2) == 0) options.floor = own.uniform(-0.2, 0.2);
    options.balance = own.index(2) == 0;
    if (own.index(2) == 0) {
      const int joint = own.index(skeleton.joint_count());
      options.pins.push_back({joint, compute_positions(skeleton, start)[static_cast<std::size_t>(joint)]});
    }
    const LineSolverResult result = solve_lines(skeleton, humanoid, start, {input}, camera, options);
    expect_promises(skeleton, result, options, start);
    if (round % 6 != 0) continue;
    const LineSolverResult again = solve_lines(skeleton, humanoid, start, {input}, camera, options);
    for (std::size_t i = 0; i < start.local.size(); ++i) {
      ASSERT_EQ(result.pose.local[i].rotation.coeffs(), again.pose.local[i].rotation.coeffs());
    }
  }
}

TEST(Guarantees, RedrawingTheLineOfAPoseChangesNothing) {
  Random random(7);
  for (int round = 0; round < 20; ++round) {
    const std::uint64_t seed = random.bits() | 1U;
    SCOPED_TRACE("kind " + std::to_string(round % 5) + ", seed " + std::to_string(seed));
    Random own(seed);
    const Skeleton skeleton = make_body(round % 5, seed);
    const Pose start = random_pose(skeleton, own, 0.2);
    const Camera camera = camera_on(skeleton, start, round % 2 == 1, own.uniform(0, 6.28));
    const BodyLine line = random_line(skeleton, own);
    LineSolverOptions options;
    options.iterations = 10;
    const Polyline2 stroke = extract_line(skeleton, start, line, camera);
    const LineSolverResult result =
        solve_lines(skeleton, {}, start, {{line, stroke, LineInput::Direction::forward}}, camera, options);
    for (std::size_t i = 0; i < start.local.size(); ++i) {
      EXPECT_LT(result.pose.local[i].rotation.angularDistance(start.local[i].rotation) / kDegree, 0.1);
    }
  }
}

TEST(Guarantees, OtherPosesAreDistinctAndKeepThePromises) {
  const Skeleton skeleton = make_test_humanoid(3);
  const HumanoidMap humanoid = recognise_humanoid(skeleton);
  const Pose start = rest_pose(skeleton);
  const BodyLine arm{"", skeleton.path(skeleton.resolve("leftUpperArm"), skeleton.resolve("leftHand"))};
  std::vector<Vec2> points = extract_line(skeleton, start, arm, Camera{}).points();
  for (Vec2& p : points) p = points.front() + 0.6 * (p - points.front());  // must foreshorten
  LineSolverOptions options;
  options.limits = make_joint_limits(skeleton, humanoid, LimitPreset::anatomical);
  const LineInput input{arm, Polyline2(points), LineInput::Direction::forward};
  const auto found = solve_alternatives(skeleton, humanoid, start, {input}, Camera{}, options, 4);
  ASSERT_GE(found.size(), 2U);
  ASSERT_LE(found.size(), 4U);
  const LineSolverResult alone = solve_lines(skeleton, humanoid, start, {input}, Camera{}, options);
  for (std::size_t i = 0; i < found.size(); ++i) {
    expect_promises(skeleton, found[i], options, start);
    EXPECT_LT(found[i].fits[0].mean_px, 15.0) << i;
    for (std::size_t j = 0; j < i; ++j) {
      double apart = 0.0;
      const auto a = compute_positions(skeleton, found[i].pose), b = compute_positions(skeleton, found[j].pose);
      for (std::size_t k = 0; k < a.size(); ++k) apart = std::max(apart, (a[k] - b[k]).norm());
      EXPECT_GT(apart, 0.01);
    }
  }
  for (std::size_t i = 0; i < start.local.size(); ++i) {
    EXPECT_LT(found[0].pose.local[i].rotation.angularDistance(alone.pose.local[i].rotation), 1e-12);
  }
  EXPECT_THROW((void)solve_alternatives(skeleton, humanoid, start, {input}, Camera{}, options, 0), Error);
}

TEST(Guarantees, NobodyIsTurnedUpsideDownForAnUprightLine) {
  Random random(99);
  for (int round = 0; round < 10; ++round) {
    const Skeleton skeleton = make_test_humanoid(random.bits() | 1U);
    const HumanoidMap humanoid = recognise_humanoid(skeleton);
    const Pose start = rest_pose(skeleton);
    const BodyLine line{"", skeleton.path(skeleton.resolve("leftFoot"), skeleton.resolve("head"))};
    std::vector<Vec2> points = extract_line(skeleton, start, line, Camera{}).points();
    const double bend = random.uniform(-150, 150), lean = random.uniform(-0.4, 0.4);
    const double low = points.front().y(), high = points.back().y();
    for (Vec2& p : points) {
      const double t = (p.y() - low) / (high - low);
      p.x() += bend * std::sin(kPi * t) + lean * (p.y() - low);
    }
    if (round % 2 == 1) std::reverse(points.begin(), points.end());
    LineSolverOptions options;
    options.limits = make_joint_limits(skeleton, humanoid, LimitPreset::anatomical);
    const LineSolverResult result =
        solve_lines(skeleton, humanoid, start, {{line, Polyline2(points)}}, Camera{}, options);
    EXPECT_EQ(result.forward[0], round % 2 == 0);
    const auto x = compute_positions(skeleton, result.pose);
    EXPECT_GT(x[static_cast<std::size_t>(line.joints.back())].y(),
              x[static_cast<std::size_t>(line.joints.front())].y());
  }
}

/// Strokes that nobody should draw, and bodies that nobody should look at like that.
TEST(Guarantees, BadInputGivesAnErrorOrAFinitePoseInBoundedTime) {
  const Skeleton skeleton = make_test_humanoid(5);
  const Pose start = rest_pose(skeleton);
  const BodyLine line{"", skeleton.path(skeleton.resolve("leftFoot"), skeleton.resolve("head"))};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto solve = [&](const Polyline2& stroke, const Camera& camera = {}) {
    return solve_lines(skeleton, {}, start, {{line, stroke}}, camera);
  };
  EXPECT_THROW((void)solve(Polyline2({Vec2(500, 500)})), Error);
  EXPECT_THROW((void)solve(Polyline2({Vec2(500, 500), Vec2(500, 500)})), Error);
  EXPECT_THROW((void)solve(Polyline2({Vec2(500, 500), Vec2(nan, 400), Vec2(500, 300)})), Error);
  EXPECT_THROW((void)solve(Polyline2({Vec2(500, 500), Vec2(std::numeric_limits<double>::infinity(), 4)})), Error);

  std::vector<Vec2> many, loop, eight;
  for (int i = 0; i < 100000; ++i) many.emplace_back(512 + 100 * std::sin(i * 3e-5), 900 - 0.007 * i);
  for (int i = 0; i <= 200; ++i) {
    const double t = 2 * kPi * i / 200.0;
    loop.emplace_back(512 + 200 * std::cos(t), 512 + 200 * std::sin(t));
    eight.emplace_back(512 + 200 * std::sin(t), 512 + 200 * std::sin(2 * t));
  }
  Camera above;  // the body seen end-on
  above.position = Vec3(0, 6, 0);
  above.target = Vec3(0, 1, 0);
  above.up = Vec3(0, 0, -1);
  const auto begin = std::chrono::steady_clock::now();
  for (const auto* points : {&many, &loop, &eight}) {
    for (const Camera& camera : {Camera{}, above}) {
      const LineSolverResult result = solve(Polyline2(*points), camera);
      for (const Transform& local : result.pose.local) ASSERT_TRUE(local.is_finite());
      EXPECT_LT(result.bone_length_drift, 1e-9);
    }
  }
  EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(), 20.0);

  // A stroke of a hundredth of a pixel, and one far outside the picture, are drawn lines all the same.
  for (const Polyline2& stroke :
       {Polyline2({Vec2(500, 500), Vec2(500, 500.01)}), Polyline2({Vec2(9e5, 0), Vec2(9e5, 900)})}) {
    for (const Transform& local : solve(stroke).pose.local) ASSERT_TRUE(local.is_finite());
  }

  // Bones without length, all of them or some.
  const Skeleton dot(std::vector<Joint>{{"a", -1, {}}, {"b", 0, {}}, {"c", 1, {}}});
  EXPECT_THROW((void)solve_lines(dot, {}, rest_pose(dot), {{{"", {0, 1, 2}}, Polyline2(loop)}}, Camera{}), Error);
  Joint step{"c", 1, {}};
  step.rest.translation = Vec3(0, 0.5, 0);
  const Skeleton half(std::vector<Joint>{{"a", -1, {}}, {"b", 0, {}}, step});
  const LineSolverResult result =
      solve_lines(half, {}, rest_pose(half), {{{"", {0, 1, 2}}, Polyline2(loop)}}, Camera{});
  for (const Transform& local : result.pose.local) ASSERT_TRUE(local.is_finite());

  LineInput unread{line, Polyline2(loop)};
  unread.pressure = {1.0, 2.0};
  EXPECT_THROW((void)solve_lines(skeleton, {}, start, {unread}, Camera{}), Error);
  unread.pressure.clear();
  unread.weight = -1.0;
  EXPECT_THROW((void)solve_lines(skeleton, {}, start, {unread}, Camera{}), Error);
  LineSolverOptions options;
  options.floor = nan;
  EXPECT_THROW((void)solve_lines(skeleton, {}, start, {{line, Polyline2(loop)}}, Camera{}, options), Error);
  options.floor.reset();
  options.pins.push_back({0, Vec3::Zero(), Quat(0, 0, 0, 0)});
  EXPECT_THROW((void)solve_lines(skeleton, {}, start, {{line, Polyline2(loop)}}, Camera{}, options), Error);
}

}  // namespace
}  // namespace croquis
