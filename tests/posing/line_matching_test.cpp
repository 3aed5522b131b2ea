// SPDX-License-Identifier: MIT
#include "croquis/posing/line_matching.h"

#include "support/test_rigs.h"
#include <cmath>

#include <gtest/gtest.h>

#include "croquis/base/error.h"
#include "croquis/math/rotation.h"

namespace croquis {
namespace {

/// A picture in which one unit is 512 pixels, of the plane z = 0, centred on (0, 1).
Camera front_camera() { return Camera{}; }

Vec2 pixel(const Vec3& point) { return *front_camera().project(point); }

Polyline2 drawn(const std::vector<Vec3>& points, int count = 0) {
  std::vector<Vec2> pixels;
  for (const Vec3& point : points) pixels.push_back(pixel(point));
  const Polyline2 line(pixels);
  return count > 0 ? Polyline2(line.resampled(count)) : line;
}

/// A quarter circle of radius r from `from`, starting upward and bending to +x.
std::vector<Vec3> quarter(const Vec3& from, double r, int count = 64) {
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i) {
    const double angle = 0.5 * kPi * i / (count - 1);
    points.push_back(from + r * Vec3(1.0 - std::cos(angle), std::sin(angle), 0));
  }
  return points;
}

std::vector<int> all_joints(const Skeleton& skeleton) {
  std::vector<int> joints;
  for (int i = 0; i < skeleton.joint_count(); ++i) joints.push_back(i);
  return joints;
}

/// A chain below a root of two branches, so that its first joint is no body root and may turn.
Skeleton forked_chain(int count, std::uint64_t seed) {
  std::vector<PlacedJoint> placed = {{"root", -1, Vec3(0, 0.4, 0)}, {"other", 0, Vec3(0.3, 0.4, 0)}};
  for (int i = 0; i < count; ++i) {
    placed.push_back({"joint" + std::to_string(i), i == 0 ? 0 : i + 1, Vec3(0, 0.5 + 0.1 * i, 0)});
  }
  return make_skeleton(placed, seed);
}
SkeletonSegment chain_of(const Skeleton& skeleton) { return skeleton.path(2, skeleton.joint_count() - 1); }

TEST(LineMatching, NearMovesEachJointToItsNearestPoint) {
  const Skeleton skeleton = make_chain(3, 0.5);
  MatchOptions options;
  options.method = MatchMethod::near;
  const std::vector<SkeletonSegment> segments = {{0, 1, 2}};
  const MatchResult result = match_line(skeleton, rest_pose(skeleton), segments,
                                        drawn({Vec3(0.25, -1, 0), Vec3(0.25, 0.75, 0)}), front_camera(), options);
  const std::vector<Vec3> positions = compute_positions(skeleton, result.pose);
  EXPECT_LT((positions[0] - Vec3(0.25, 0.0, 0)).norm(), 1e-9);
  EXPECT_LT((positions[1] - Vec3(0.25, 0.5, 0)).norm(), 1e-9);
  EXPECT_LT((positions[2] - Vec3(0.25, 0.75, 0)).norm(), 1e-9);
  EXPECT_NE(result.status.find("stretched by up to 50 %"), std::string::npos) << result.status;
  EXPECT_NEAR(result.fit.mean_px, 0.0, 1e-6);
}

TEST(LineMatching, CurvilinearTakesThePointsByIndexAsPrinted) {
  const Skeleton skeleton = make_chain(4, 0.5);
  MatchOptions options;
  options.method = MatchMethod::curvilinear;
  const std::vector<SkeletonSegment> segments = {{0, 1, 2, 3}};
  // K = 8 points, k = 4 joints: joint i takes point 2 i.
  std::vector<Vec3> points;
  for (int i = 0; i < 8; ++i) points.emplace_back(0.1 * i * i / 8, 0.2 * i, 0);
  const MatchResult result =
      match_line(skeleton, rest_pose(skeleton), segments, drawn(points), front_camera(), options);
  const std::vector<Vec3> positions = compute_positions(skeleton, result.pose);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_LT((positions[i] - points[2 * i]).norm(), 1e-9);
}

TEST(LineMatching, RotationLaysAChainAlongALineOfItsLength) {
  const Skeleton skeleton = forked_chain(21, 5);
  const SkeletonSegment segment = chain_of(skeleton);
  const std::vector<Vec3> arc = quarter(Vec3(0, 0.5, 0), 2.0 / (0.5 * kPi));
  const std::vector<SkeletonSegment> segments = {segment};
  const MatchResult result = match_line(skeleton, rest_pose(skeleton), segments, drawn(arc), front_camera());
  EXPECT_EQ(result.status, "ok");
  EXPECT_LT(result.bone_length_drift, 1e-12);
  EXPECT_LT(result.fit.mean_px, 1.0);
  EXPECT_LT(result.fit.tangent_deg, 1.0);
  EXPECT_TRUE(result.forward);
}

TEST(LineMatching, BoneLengthsKeepOnRandomBodies) {
  Random random(17);
  for (int round = 0; round < 20; ++round) {
    const Skeleton skeleton = make_test_humanoid(random.bits() | 1U);
    const Pose start = random_pose(skeleton, random, 0.5);
    std::vector<Vec2> points;
    for (int i = 0; i < 6; ++i) points.emplace_back(random.uniform(200, 800), random.uniform(200, 800));
    const BodyLine line{"", skeleton.path(*skeleton.find("leftFoot").begin(), *skeleton.find("head_end").begin())};
    for (const auto method : {MatchMethod::rotation, MatchMethod::rotation_index}) {
      for (const auto root : {RootMode::lock, RootMode::tangent}) {
        MatchOptions options;
        options.method = method;
        options.root = root;
        const MatchResult result =
            match_line(skeleton, start, line, Polyline2(Polyline2(points).resampled(50)), front_camera(), options);
        EXPECT_LT(result.bone_length_drift, 1e-9);
        EXPECT_LT((result.pose.local[0].translation - start.local[0].translation).norm(), 1e-12);
        if (root == RootMode::lock) {
          EXPECT_LT(result.pose.local[0].rotation.angularDistance(start.local[0].rotation), 1e-9);
        }
      }
    }
  }
}

TEST(LineMatching, TheLineThatThePoseHasChangesNothing) {
  const Skeleton skeleton = forked_chain(9, 3);
  Random random(4);
  Pose start = rest_pose(skeleton);  // bent within the picture's plane, so that the line tells all of it
  std::vector<Affine> model = compute_model_transforms(skeleton, start);
  for (int i = 2; i < skeleton.joint_count(); ++i) {
    const Quat above = rotation_of(model[static_cast<std::size_t>(skeleton.parent(i))]);
    Quat& local = start.local[static_cast<std::size_t>(i)].rotation;
    local = above.conjugate() * Quat(Eigen::AngleAxisd(random.uniform(-0.4, 0.4), Vec3::UnitZ())) * above * local;
    model = compute_model_transforms(skeleton, start);
  }
  std::vector<Vec3> joints;
  for (const int joint : chain_of(skeleton)) joints.emplace_back(model[static_cast<std::size_t>(joint)].translation());
  const std::vector<SkeletonSegment> segments = {chain_of(skeleton)};
  const MatchResult result = match_line(skeleton, start, segments, drawn(joints), front_camera());
  for (std::size_t i = 0; i < start.local.size(); ++i) {
    EXPECT_LT(result.pose.local[i].rotation.angularDistance(start.local[i].rotation), 1e-6);
  }
}

TEST(LineMatching, ArcLengthMatchingDoesNotKnowThePensSpeed) {
  const Skeleton skeleton = forked_chain(12, 8);
  const std::vector<SkeletonSegment> segments = {chain_of(skeleton)};
  const std::vector<Vec3> even = quarter(Vec3(0, 0.5, 0), 0.7, 400);
  std::vector<Vec3> uneven;  // the same points, ever fewer of them toward the end
  for (std::size_t i = 0; i < even.size(); i += 1 + i / 40) uneven.push_back(even[i]);
  uneven.push_back(even.back());
  MatchOptions options;
  const auto turned = [&](MatchMethod method) {
    options.method = method;
    const Pose a = match_line(skeleton, rest_pose(skeleton), segments, drawn(even), front_camera(), options).pose;
    const Pose b = match_line(skeleton, rest_pose(skeleton), segments, drawn(uneven), front_camera(), options).pose;
    double most = 0.0;
    for (std::size_t i = 0; i < a.local.size(); ++i) {
      most = std::max(most, a.local[i].rotation.angularDistance(b.local[i].rotation));
    }
    return most;
  };
  EXPECT_LT(turned(MatchMethod::rotation), 0.01);
  EXPECT_GT(turned(MatchMethod::rotation_index), 0.05);  // the printed method does
}

TEST(LineMatching, AMirroredLineGivesTheMirroredPose) {
  const Skeleton skeleton = forked_chain(9, 0);
  const std::vector<SkeletonSegment> segments = {chain_of(skeleton)};
  std::vector<Vec3> points = quarter(Vec3(0, 0.5, 0), 0.6), mirrored = points;
  for (Vec3& point : mirrored) point.x() = -point.x();
  for (const auto method : {MatchMethod::rotation, MatchMethod::rotation_index, MatchMethod::near}) {
    MatchOptions options;
    options.method = method;
    const auto a = compute_positions(
        skeleton, match_line(skeleton, rest_pose(skeleton), segments, drawn(points), front_camera(), options).pose);
    const auto b = compute_positions(
        skeleton, match_line(skeleton, rest_pose(skeleton), segments, drawn(mirrored), front_camera(), options).pose);
    for (std::size_t i = 2; i < a.size(); ++i) EXPECT_LT((a[i] - Vec3(-b[i].x(), b[i].y(), b[i].z())).norm(), 1e-9);
  }
}

TEST(LineMatching, MovingCameraAndSceneTogetherChangesNothing) {
  const Skeleton skeleton = make_test_humanoid(2);
  const BodyLine line{"", skeleton.path(*skeleton.find("rightFoot").begin(), *skeleton.find("head").begin())};
  const Polyline2 stroke = drawn(quarter(Vec3(-0.2, 0.1, 0), 1.2));
  const MatchResult here = match_line(skeleton, rest_pose(skeleton), line, stroke, front_camera());
  const Quat turn(Eigen::AngleAxisd(1.1, Vec3::UnitY()));
  const Vec3 shift(3, 0.5, -2);
  Pose start = rest_pose(skeleton);
  start.local[0].rotation = turn * start.local[0].rotation;
  start.local[0].translation = turn * start.local[0].translation + shift;
  Camera camera = front_camera();
  camera.position = turn * camera.position + shift;
  camera.target = turn * camera.target + shift;
  const MatchResult there = match_line(skeleton, start, line, stroke, camera);
  for (std::size_t i = 1; i < start.local.size(); ++i) {
    // Box centres differ, so the planes do, in depth only; an orthographic picture does not show it.
    EXPECT_LT(there.pose.local[i].rotation.angularDistance(here.pose.local[i].rotation), 1e-6) << i;
  }
}

TEST(LineMatching, TheTangentRootTurnsItsUpAxisToTheLine) {
  const Skeleton skeleton = make_test_humanoid(6);
  const BodyLine line{"", skeleton.path(0, *skeleton.find("head_end").begin())};
  MatchOptions options;
  options.root = RootMode::tangent;
  const Vec3 direction = Vec3(0.5, 1, 0).normalized();
  const Vec3 hips = skeleton.rest_position(0);
  const MatchResult result =
      match_line(skeleton, rest_pose(skeleton), line, drawn({hips, hips + 0.8 * direction}), front_camera(), options);
  const Affine model = compute_model_transforms(skeleton, result.pose)[0];
  const Vec3 up = rotation_of(model) * (rotation_of(skeleton.rest_model(0)).conjugate() * Vec3::UnitY());
  EXPECT_LT((up - direction).norm(), 1e-6);
}

TEST(LineMatching, DirectionRulesChooseTheSide) {
  const Skeleton skeleton = forked_chain(9, 1);
  const std::vector<SkeletonSegment> segments = {chain_of(skeleton)};  // points up from (0, 0.5), 0.8 long
  // Up for 0.3, down for 0.8: by scalar product the segment stays up (and folds, the side being short for it: a limit
  // of the method), by length it turns down.
  const Polyline2 stroke = drawn({Vec3(0, 0.8, 0), Vec3(0, -0.3, 0)}, 111);
  MatchOptions options;
  const auto tip = [&](DirectionRule rule) {
    options.direction = rule;
    const MatchResult result = match_line(skeleton, rest_pose(skeleton), segments, stroke, front_camera(), options);
    return compute_positions(skeleton, result.pose).back().y();
  };
  EXPECT_GT(tip(DirectionRule::scalar_product), 0.5);
  EXPECT_NEAR(tip(DirectionRule::length), -0.3, 1e-6);
  EXPECT_NEAR(tip(DirectionRule::forward), -0.3, 1e-6);
  EXPECT_GT(tip(DirectionRule::backward), 0.5);
}

TEST(LineMatching, ABodyLineMeansItsOwnOrder) {
  const Skeleton skeleton = forked_chain(9, 1);
  SkeletonSegment down = chain_of(skeleton);
  const BodyLine up_line{"up", down};
  std::reverse(down.begin(), down.end());
  const BodyLine down_line{"down", down};
  MatchOptions options;
  options.direction = DirectionRule::forward;
  const Polyline2 stroke = drawn({Vec3(0, 0.5, 0), Vec3(0.8, 0.5, 0)});
  const auto a = match_line(skeleton, rest_pose(skeleton), up_line, stroke, front_camera(), options);
  const Polyline2 back = drawn({Vec3(0.8, 0.5, 0), Vec3(0, 0.5, 0)});
  const auto b = match_line(skeleton, rest_pose(skeleton), down_line, back, front_camera(), options);
  EXPECT_TRUE(a.forward);
  EXPECT_TRUE(b.forward);
  EXPECT_LT((compute_positions(skeleton, a.pose).back() - Vec3(0.8, 0.5, 0)).norm(), 1e-9);
  EXPECT_LT((compute_positions(skeleton, b.pose).back() - Vec3(0.8, 0.5, 0)).norm(), 1e-9);
}

TEST(LineMatching, DegenerateInputIsHandled) {
  const Skeleton skeleton = make_chain(4);
  const Pose rest = rest_pose(skeleton);
  const std::vector<SkeletonSegment> segments = {all_joints(skeleton)};
  const Polyline2 stroke = drawn({Vec3(0, 0, 0), Vec3(0.3, 0.1, 0)});
  EXPECT_THROW((void)match_line(skeleton, rest, std::vector<SkeletonSegment>{}, stroke, front_camera()), Error);
  EXPECT_THROW((void)match_line(skeleton, rest, std::vector<SkeletonSegment>{{1}}, stroke, front_camera()), Error);
  EXPECT_THROW((void)match_line(skeleton, rest, std::vector<SkeletonSegment>{{0, 2}}, stroke, front_camera()), Error);
  EXPECT_THROW((void)match_line(skeleton, rest, segments, Polyline2({Vec2(5, 5)}), front_camera()), Error);

  const Skeleton point = make_chain(4, 0.0);  // all bones of no length
  const MatchResult result = match_line(point, rest_pose(point), segments, stroke, front_camera());
  for (const Transform& local : result.pose.local) EXPECT_TRUE(local.is_finite());

  // A line that lies wholly beyond the tip, and one that runs back through the root.
  for (const auto& odd : {drawn({Vec3(0, 5, 0), Vec3(0, 6, 0)}), drawn({Vec3(0, 0.3, 0), Vec3(0, -0.3, 0)})}) {
    for (const auto method :
         {MatchMethod::near, MatchMethod::curvilinear, MatchMethod::rotation_index, MatchMethod::rotation}) {
      MatchOptions options;
      options.method = method;
      for (const Transform& local : match_line(skeleton, rest, segments, odd, front_camera(), options).pose.local) {
        EXPECT_TRUE(local.is_finite());
      }
    }
  }
}

TEST(LineMatching, NamesOfMethodsReadBack) {
  for (const auto method :
       {MatchMethod::near, MatchMethod::curvilinear, MatchMethod::rotation_index, MatchMethod::rotation}) {
    EXPECT_EQ(parse_match_method(to_string(method)), method);
  }
  EXPECT_FALSE(parse_match_method("nearest"));
}

}  // namespace
}  // namespace croquis
