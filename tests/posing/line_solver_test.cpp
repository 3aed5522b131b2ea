// SPDX-License-Identifier: MIT
#include "croquis/posing/line_solver.h"

#include "support/test_rigs.h"
#include <cmath>

#include <gtest/gtest.h>

#include "croquis/base/error.h"
#include "croquis/math/rotation.h"
#include "croquis/posing/extract_line.h"

namespace croquis {
namespace {

std::vector<Vec2> project_line(const Skeleton& skeleton, const Pose& pose, const BodyLine& line, const Camera& camera) {
  const std::vector<Vec3> x = compute_positions(skeleton, pose);
  std::vector<Vec2> pixels;
  for (const int joint : line.joints) pixels.push_back(*camera.project(x[static_cast<std::size_t>(joint)]));
  return pixels;
}

/// A C about the middle of the picture, opening to the right, `size` pixels across.
Polyline2 c_curve(double size, int count = 96) {
  std::vector<Vec2> points;
  for (int i = 0; i <= 200; ++i) {
    const double angle = kPi * (0.5 + i / 200.0);
    points.emplace_back(512 + size * std::cos(angle), 512 + size * std::sin(angle));
  }
  return Polyline2(Polyline2(points).resampled(count));
}

double largest_turn(const Pose& a, const Pose& b) {
  double most = 0.0;
  for (std::size_t i = 0; i < a.local.size(); ++i) {
    most = std::max(most, a.local[i].rotation.angularDistance(b.local[i].rotation));
  }
  return most;
}

BodyLine foot_to_head(const Skeleton& skeleton) {
  return {"", skeleton.path(skeleton.resolve("leftFoot"), skeleton.resolve("head"))};
}

TEST(LineSolver, AChainTakesTheShapeOfTheStroke) {
  const Skeleton skeleton = make_chain(17, 0.08, 3);
  const BodyLine line{"", skeleton.path(0, 16)};
  const Camera camera;
  const LineSolverResult result = solve_lines(skeleton, {}, rest_pose(skeleton), {{line, c_curve(200)}}, camera);
  EXPECT_EQ(result.report.status, "ok");
  EXPECT_LT(result.fits[0].mean_px, 3.0);
  EXPECT_LT(result.fits[0].tangent_deg, 3.0);
  EXPECT_LT(result.bone_length_drift, 1e-9);
}

TEST(LineSolver, BoneLengthsKeepAndNumbersStayFiniteOnAnyBody) {
  Random random(23);
  for (int round = 0; round < 12; ++round) {
    const std::uint64_t seed = random.bits() | 1U;
    const Skeleton skeleton = round % 3 == 0   ? make_test_humanoid(seed)
                              : round % 3 == 1 ? make_test_quadruped(seed)
                                               : make_chain(60, 0.03, seed);
    const Pose start = random_pose(skeleton, random, 0.3);
    const int from = random.index(skeleton.joint_count()), to = random.index(skeleton.joint_count());
    if (skeleton.path(from, to).size() < 3) continue;
    std::vector<Vec2> points;
    for (int i = 0; i < 4; ++i) points.emplace_back(random.uniform(100, 900), random.uniform(100, 900));
    Camera camera;
    camera.projection = round % 2 == 0 ? Camera::Projection::orthographic : Camera::Projection::perspective;
    const LineInput input{{"", skeleton.path(from, to)}, Polyline2(Polyline2(points).resampled(96))};
    LineSolverOptions options;
    options.iterations = 20;
    const LineSolverResult result = solve_lines(skeleton, {}, start, {input}, camera, options);
    EXPECT_LT(result.bone_length_drift, 1e-9);
    for (const Transform& local : result.pose.local) ASSERT_TRUE(local.is_finite());
    // Joints off the line keep their rotations.
    for (int i = 0; i < skeleton.joint_count(); ++i) {
      if (std::count(input.line.joints.begin(), input.line.joints.end(), i) > 0) continue;
      EXPECT_LT(result.pose.local[static_cast<std::size_t>(i)].rotation.angularDistance(
                    start.local[static_cast<std::size_t>(i)].rotation),
                1e-12);
    }
  }
}

TEST(LineSolver, TheLineThatThePoseHasChangesNothing) {
  Random random(31);
  for (int round = 0; round < 6; ++round) {
    const Skeleton skeleton = make_test_humanoid(round + 1);
    const Pose start = random_pose(skeleton, random, 0.25);
    const BodyLine line = foot_to_head(skeleton);
    Camera camera;
    if (round % 2 == 1) camera.projection = Camera::Projection::perspective;
    const Polyline2 stroke(project_line(skeleton, start, line, camera));
    const LineSolverResult result = solve_lines(skeleton, {}, start, {{line, stroke}}, camera);
    EXPECT_LT(largest_turn(result.pose, start) / kDegree, 0.1) << round;
  }
}

TEST(LineSolver, AMirroredBodyAndStrokeGiveTheMirroredPose) {
  const Skeleton skeleton = make_test_humanoid();
  const BodyLine left{"", skeleton.path(skeleton.resolve("leftFoot"), skeleton.resolve("rightHand"))};
  const BodyLine right{"", skeleton.path(skeleton.resolve("rightFoot"), skeleton.resolve("leftHand"))};
  const Camera camera;
  std::vector<Vec2> mirrored;
  const Polyline2 drawn = c_curve(220);
  for (const Vec2& p : drawn.points()) mirrored.emplace_back(1024 - p.x(), p.y());
  const auto a =
      compute_positions(skeleton, solve_lines(skeleton, {}, rest_pose(skeleton), {{left, c_curve(220)}}, camera).pose);
  const auto b = compute_positions(
      skeleton, solve_lines(skeleton, {}, rest_pose(skeleton), {{right, Polyline2(mirrored)}}, camera).pose);
  for (std::size_t i = 0; i < left.joints.size(); ++i) {
    const Vec3 p = a[static_cast<std::size_t>(left.joints[i])], q = b[static_cast<std::size_t>(right.joints[i])];
    EXPECT_LT((p - Vec3(-q.x(), q.y(), q.z())).norm(), 1e-5);
  }
}

TEST(LineSolver, MovingCameraAndSceneTogetherChangesNothing) {
  const Skeleton skeleton = make_test_humanoid(12);
  const Quat turn(Eigen::AngleAxisd(2.1, Vec3::UnitY()));
  const Vec3 shift(3, 0, -2);
  for (const auto projection : {Camera::Projection::orthographic, Camera::Projection::perspective}) {
    Camera camera;
    camera.projection = projection;
    Pose start = rest_pose(skeleton);
    const LineInput input{foot_to_head(skeleton), c_curve(230)};
    const Pose here = solve_lines(skeleton, {}, start, {input}, camera).pose;
    start.local[0].rotation = turn * start.local[0].rotation;
    start.local[0].translation = turn * start.local[0].translation + shift;
    camera.position = turn * camera.position + shift;
    camera.target = turn * camera.target + shift;
    Pose there = solve_lines(skeleton, {}, start, {input}, camera).pose;
    there.local[0].rotation = turn.conjugate() * there.local[0].rotation;
    EXPECT_LT(largest_turn(here, there), 1e-5);
  }
}

TEST(LineSolver, ResamplingTheStrokeChangesNextToNothing) {
  const Skeleton skeleton = make_test_humanoid(4);
  const Camera camera;
  const Pose start = rest_pose(skeleton);
  for (const HumanoidMap& humanoid : {HumanoidMap{}, recognise_humanoid(skeleton)}) {
    const auto solved = [&](int count) {
      return solve_lines(skeleton, humanoid, start, {{foot_to_head(skeleton), c_curve(230, count)}}, camera).pose;
    };
    const Pose usual = solved(96);
    for (const int count : {32, 48, 97, 384}) EXPECT_LT(largest_turn(usual, solved(count)) / kDegree, 0.1) << count;
  }
}

TEST(LineSolver, AForeshortenedArmBendsAtItsHinge) {
  const Skeleton skeleton = make_test_humanoid(3);
  const HumanoidMap humanoid = recognise_humanoid(skeleton);
  const Pose start = rest_pose(skeleton);
  const BodyLine arm{"", skeleton.path(skeleton.resolve("leftUpperArm"), skeleton.resolve("leftHand"))};
  std::vector<Vec2> points = project_line(skeleton, start, arm, Camera{});
  for (Vec2& p : points) p = points.front() + 0.7 * (p - points.front());
  const Pose pose =
      solve_lines(skeleton, humanoid, start, {{arm, Polyline2(points), LineInput::Direction::forward}}, Camera{}).pose;
  const int elbow = skeleton.resolve("leftLowerArm");
  for (const JointLimit& limit : make_joint_limits(skeleton, humanoid, LimitPreset::anatomical)) {
    if (limit.joint != elbow) continue;
    const Vec3 bent = limit_coordinates(limit, pose.local[static_cast<std::size_t>(elbow)].rotation);
    EXPECT_GT(bent.x(), 0.5);
    EXPECT_LT(std::abs(bent.y()), 0.2 * bent.x());
  }
}

TEST(LineSolver, TheSameInputGivesTheSameOutput) {
  const Skeleton skeleton = make_test_humanoid(4);
  const LineInput input{foot_to_head(skeleton), c_curve(230)};
  const Pose a = solve_lines(skeleton, {}, rest_pose(skeleton), {input}, Camera{}).pose;
  const Pose b = solve_lines(skeleton, {}, rest_pose(skeleton), {input}, Camera{}).pose;
  EXPECT_EQ(largest_turn(a, b), 0.0);
}

TEST(LineSolver, TheDirectionIsFound) {
  const Skeleton skeleton = make_test_humanoid(4);
  const Camera camera;
  std::vector<Vec2> points = project_line(skeleton, rest_pose(skeleton), foot_to_head(skeleton), camera);
  for (Vec2& p : points) p.x() += 0.15 * (p.y() - 500);
  const LineSolverResult up =
      solve_lines(skeleton, {}, rest_pose(skeleton), {{foot_to_head(skeleton), Polyline2(points)}}, camera);
  std::reverse(points.begin(), points.end());
  const LineSolverResult down =
      solve_lines(skeleton, {}, rest_pose(skeleton), {{foot_to_head(skeleton), Polyline2(points)}}, camera);
  EXPECT_TRUE(up.forward[0]);
  EXPECT_FALSE(down.forward[0]);
  EXPECT_LT(largest_turn(up.pose, down.pose), 1e-6);
}

TEST(LineSolver, AShortStrokeForeshortens) {
  const Skeleton skeleton = make_chain(3, 0.4, 9);  // two bones, 0.8 long, flat in the picture
  const LineInput input{{"", {0, 1, 2}},
                        Polyline2(Polyline2({Vec2(512, 900), Vec2(512, 700)}).resampled(50)),
                        LineInput::Direction::forward};
  const LineSolverResult result = solve_lines(skeleton, {}, rest_pose(skeleton), {input}, Camera{});
  EXPECT_LT(result.fits[0].mean_px, 4.0);
  const std::vector<Vec2> joints = project_line(skeleton, result.pose, input.line, Camera{});
  EXPECT_NEAR((joints[2] - joints[0]).norm(), 200.0, 10.0);  // of 409 pixels
}

TEST(LineSolver, BonesKeepTheirLengthsUnderUnevenScale) {
  std::vector<Joint> joints = make_chain(6, 0.2, 5).joints();
  joints[0].rest.scale = Vec3(1, 2, 1);
  const Skeleton skeleton(joints);
  const LineInput input{{"", skeleton.path(0, 5)}, c_curve(200)};
  const LineSolverResult result = solve_lines(skeleton, {}, rest_pose(skeleton), {input}, Camera{});
  EXPECT_EQ(result.report.status, "ok");
  EXPECT_LT(result.bone_length_drift, 1e-9);
  EXPECT_LT(result.fits[0].mean_px, 10.0);
}

TEST(LineSolver, MirroredAndScaledBodiesKeepTheirLengths) {
  std::vector<Joint> joints = make_chain(9, 0.2, 5).joints();
  joints[0].rest.scale = Vec3(-0.5, 0.5, 0.5);
  joints[3].rest.scale = Vec3(2, 2, 2);
  const Skeleton skeleton(joints);
  const LineInput input{{"", skeleton.path(0, 8)}, c_curve(200)};
  const LineSolverResult result = solve_lines(skeleton, {}, rest_pose(skeleton), {input}, Camera{});
  EXPECT_EQ(result.report.status, "ok");
  EXPECT_LT(result.bone_length_drift, 1e-9);
  EXPECT_LT(result.fits[0].mean_px, 10.0);
}

TEST(LineSolver, JointLimitsHoldExactly) {
  Random random(41);
  int bound = 0;
  for (int round = 0; round < 10; ++round) {
    const Skeleton skeleton = make_test_humanoid(round + 1);
    const HumanoidMap humanoid = recognise_humanoid(skeleton);
    LineSolverOptions options, free;
    options.limits = make_joint_limits(skeleton, humanoid, LimitPreset::anatomical);
    options.iterations = free.iterations = 25;
    ASSERT_FALSE(options.limits.empty());
    std::vector<Vec2> points;
    for (int i = 0; i < 4; ++i) points.emplace_back(random.uniform(200, 800), random.uniform(100, 900));
    const BodyLine line =
        round % 2 == 0 ? foot_to_head(skeleton)
                       : BodyLine{"", skeleton.path(skeleton.resolve("rightHand"), skeleton.resolve("leftFoot"))};
    const LineInput input{line, curve_through(points), LineInput::Direction::forward};
    const Pose start = rest_pose(skeleton);
    const LineSolverResult result = solve_lines(skeleton, humanoid, start, {input}, Camera{}, options);
    EXPECT_TRUE(result.limits_widened.empty());
    EXPECT_TRUE(find_limit_violations(options.limits, result.pose).empty());
    EXPECT_TRUE(result.limit_violations.empty());
    EXPECT_LT(result.bone_length_drift, 1e-9);
    const Pose anyhow = solve_lines(skeleton, humanoid, start, {input}, Camera{}, free).pose;
    if (!find_limit_violations(options.limits, anyhow).empty()) ++bound;
  }
  EXPECT_GT(bound, 5);  // the strokes do ask for more than a body can do
}

TEST(LineSolver, AKneeBendsTheRightWayEvenIfTheStrokeDoesNot) {
  const Skeleton skeleton = make_test_humanoid(2);
  const HumanoidMap humanoid = recognise_humanoid(skeleton);
  const BodyLine leg{"", skeleton.path(skeleton.resolve("leftUpperLeg"), skeleton.resolve("leftFoot"))};
  Camera side;  // from the character's left: +Z is to the left of the picture
  side.position = Vec3(5, 1, 0);
  side.target = Vec3(0, 1, 0);
  const auto at = [&](double y, double z) { return *side.project(Vec3(0.09, y, z)); };
  // A shin that would have to swing forward, in front of the knee.
  const LineInput input{leg, Polyline2(Polyline2({at(0.9, 0), at(0.5, 0), at(0.35, 0.38)}).resampled(96)),
                        LineInput::Direction::forward};
  LineSolverOptions options;
  options.limits = make_joint_limits(skeleton, humanoid, LimitPreset::anatomical);
  const LineSolverResult held = solve_lines(skeleton, humanoid, rest_pose(skeleton), {input}, side, options);
  EXPECT_TRUE(find_limit_violations(options.limits, held.pose).empty());
  const Pose broken = solve_lines(skeleton, humanoid, rest_pose(skeleton), {input}, side).pose;
  EXPECT_FALSE(find_limit_violations(options.limits, broken).empty());
  // The neighbours take over: the hip swings the leg forward as far as it helps.
  const auto foot = [&](const Pose& pose) {
    return compute_positions(skeleton, pose)[static_cast<std::size_t>(leg.joints.back())];
  };
  EXPECT_GT(foot(held.pose).z(), 0.15);
}

TEST(LineSolver, AStartOutsideItsLimitsIsNoError) {
  const Skeleton skeleton = make_test_humanoid(2);
  const HumanoidMap humanoid = recognise_humanoid(skeleton);
  LineSolverOptions options;
  options.limits = make_joint_limits(skeleton, humanoid, LimitPreset::anatomical);
  Pose start = rest_pose(skeleton);
  const auto knee = static_cast<std::size_t>(skeleton.resolve("leftLowerLeg"));
  start.local[knee].rotation = start.local[knee].rotation * rotation_from_vector(Vec3(1.1, 0.7, -0.9));
  ASSERT_FALSE(find_limit_violations(options.limits, start).empty());
  const BodyLine line = foot_to_head(skeleton);
  const LineSolverResult same = solve_lines(
      skeleton, humanoid, start, {{line, Polyline2(project_line(skeleton, start, line, Camera{}))}}, Camera{}, options);
  EXPECT_EQ(same.limits_widened, std::vector<int>{static_cast<int>(knee)});
  EXPECT_LT(largest_turn(same.pose, start) / kDegree, 0.1);
}

TEST(LineSolver, PinsHoldOrAreNamed) {
  const Skeleton skeleton = make_test_humanoid(7);
  const Pose start = rest_pose(skeleton);
  const int foot = skeleton.resolve("rightFoot");
  LineSolverOptions options;
  options.pins.push_back({foot, skeleton.rest_position(foot)});
  const BodyLine trunk{"", skeleton.path(0, skeleton.resolve("head"))};
  std::vector<Vec2> points = project_line(skeleton, start, trunk, Camera{});
  for (Vec2& p : points) p += Vec2(0.2 * (600 - p.y()), 20);  // leans over, the hips a little lower
  const LineSolverResult held = solve_lines(skeleton, {}, start, {{trunk, Polyline2(points)}}, Camera{}, options);
  EXPECT_EQ(held.report.status, "ok");
  const Vec3 there = compute_positions(skeleton, held.pose)[static_cast<std::size_t>(foot)];
  EXPECT_LT((there - skeleton.rest_position(foot)).norm(), 1e-4 * skeleton.extent());
  EXPECT_TRUE(held.pins_missed.empty());
  // Two pins that no body can keep at once.
  options.pins.front().position = Vec3(0, 5, 0);
  options.pins.push_back({skeleton.resolve("leftFoot"), Vec3(0, -5, 0)});
  const LineSolverResult missed = solve_lines(skeleton, {}, start, {{trunk, Polyline2(points)}}, Camera{}, options);
  EXPECT_NE(missed.report.status.find("Foot could not be held"), std::string::npos) << missed.report.status;
  EXPECT_FALSE(missed.pins_missed.empty());
  for (const Transform& local : missed.pose.local) EXPECT_TRUE(local.is_finite());
}

TEST(LineSolver, TrimAndExtendKeepBonesAtTheirLength) {
  const Skeleton skeleton = make_chain(9, 0.1, 9);  // 0.8 units: 410 pixels, flat in the picture
  const BodyLine line{"", skeleton.path(0, 8)};
  LineSolverOptions options;
  const auto tip = [&](LengthPolicy policy, double pixels) {
    options.length = policy;
    const LineInput input{line, Polyline2(Polyline2({Vec2(512, 900), Vec2(512 + pixels, 900)}).resampled(96)),
                          LineInput::Direction::forward};
    const Pose pose = solve_lines(skeleton, {}, rest_pose(skeleton), {input}, Camera{}, options).pose;
    return (project_line(skeleton, pose, line, Camera{}).back() - Vec2(512, 900)).norm();
  };
  EXPECT_NEAR(tip(LengthPolicy::fit, 200), 200, 12);
  EXPECT_NEAR(tip(LengthPolicy::extend, 200), 410, 12);
  EXPECT_NEAR(tip(LengthPolicy::scale, 200), 410, 120);  // about its anchor
  EXPECT_NEAR(tip(LengthPolicy::trim, 700), 410, 12);
}

TEST(LineSolver, BadInputIsRefusedOrSurvived) {
  const Skeleton skeleton = make_test_humanoid(1);
  const Pose start = rest_pose(skeleton);
  const Camera camera;
  EXPECT_THROW((void)solve_lines(skeleton, {}, start, {}, camera), Error);
  EXPECT_THROW((void)solve_lines(skeleton, {}, start, {{{"", {0, 3}}, c_curve(200)}}, camera), Error);
  EXPECT_THROW((void)solve_lines(skeleton, {}, start, {{foot_to_head(skeleton), Polyline2({Vec2(5, 5)})}}, camera),
               Error);
  const Skeleton point = make_chain(5, 0.0);
  EXPECT_THROW((void)solve_lines(point, {}, rest_pose(point), {{{"", point.path(0, 4)}, c_curve(200)}}, camera), Error);
  Pose broken = start;
  broken.local[2].rotation.x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW((void)solve_lines(skeleton, {}, broken, {{foot_to_head(skeleton), c_curve(200)}}, camera), Error);
  Camera behind;
  behind.projection = Camera::Projection::perspective;
  behind.position = Vec3(0, 1, -5);
  behind.target = Vec3(0, 1, -9);
  EXPECT_THROW((void)solve_lines(skeleton, {}, start, {{foot_to_head(skeleton), c_curve(200)}}, behind), Error);

  // A loop, a figure of eight, a tiny stroke, a huge one, a zigzag: finite poses, lengths kept.
  std::vector<std::vector<Vec2>> odd(5);
  for (int i = 0; i <= 100; ++i) {
    const double t = 2.0 * kPi * i / 100.0;
    odd[0].emplace_back(512 + 200 * std::cos(t), 512 + 200 * std::sin(t));
    odd[1].emplace_back(512 + 200 * std::sin(t), 512 + 200 * std::sin(2 * t));
    odd[2].emplace_back(512 + 1e-3 * i, 512);
    odd[3].emplace_back(30.0 * i, 900);
    odd[4].emplace_back(400 + 3 * i, i % 2 == 0 ? 300 : 700);
  }
  for (const auto& points : odd) {
    for (const auto projection : {Camera::Projection::orthographic, Camera::Projection::perspective}) {
      Camera view;
      view.projection = projection;
      const LineSolverResult result =
          solve_lines(skeleton, {}, start, {{foot_to_head(skeleton), Polyline2(points)}}, view);
      EXPECT_LT(result.bone_length_drift, 1e-9);
      for (const Transform& local : result.pose.local) ASSERT_TRUE(local.is_finite());
    }
  }
}

}  // namespace
}  // namespace croquis
