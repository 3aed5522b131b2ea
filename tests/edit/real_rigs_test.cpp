// SPDX-License-Identifier: MIT
// What every answer of the line solver promises (tests/posing/guarantees_test.cpp), on rigs that people use.
#include "support/data.h"
#include "support/random_math.h"
#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "croquis/base/error.h"
#include "croquis/edit/frame.h"
#include "croquis/io/character_file.h"
#include "croquis/posing/extract_line.h"
#include "croquis/posing/line_solver.h"
#include "croquis/posing/live_line.h"
#include "croquis/rig/joint_limits.h"

namespace croquis {
namespace {

constexpr std::array kRigs{"gltf/cesium_man.gltf",
                           "gltf/rigged_figure.glb",
                           "gltf/fox_khronos.glb",
                           "gltf/m2m_snake.glb",
                           "gltf/kaykit_knight.glb",
                           "gltf/quaternius_man_casual.glb",
                           "gltf/webxr_hand_left.glb",
                           "gltf/momentum_sort_joints_297.glb",
                           "vrm/cryptovoxels_vrm0.vrm",
                           "vrm/debug_robot_vrm1.vrm",
                           "bvh/cmu_01_01.bvh",
                           "bvh/bandai1_walk_normal_001.bvh",
                           "bvh/pybvh_mixed_orders_60.bvh",
                           "bvh/rokoko_jesse_dance.bvh"};

std::optional<Character> open_rig(const std::string& name) {
  const auto path = data_file(name);
  if (!path) return std::nullopt;
  Character character = read_character(load_bytes(*path), path->filename().string(), [&](std::string_view uri) {
    const std::vector<std::byte> bytes = load_bytes(path->parent_path() / std::string(uri));
    return Bytes(bytes.begin(), bytes.end());
  });
  if (!character.clips.empty() && character.clips.front().frame_count() > 1) {
    return character_at_frame(std::move(character), 1);  // zero rotations of motion capture are no pose
  }
  return character;
}

Camera camera_on(const Skeleton& skeleton, const Pose& pose, bool perspective, double azimuth) {
  const std::vector<Vec3> x = compute_positions(skeleton, pose);
  Vec3 centre = Vec3::Zero();
  for (const Vec3& p : x) centre += p / skeleton.joint_count();
  double size = 0.0;
  for (const Vec3& p : x) size = std::max(size, 2.0 * (p - centre).norm());
  Camera camera;
  camera.target = centre;
  camera.height = 1.5 * size;
  camera.projection = perspective ? Camera::Projection::perspective : Camera::Projection::orthographic;
  camera.position = centre + 3.0 * size * Vec3(std::sin(azimuth), 0.2, std::cos(azimuth));
  return camera;
}

/// What a person might draw over a line: its own curve, bent and leaning.
Polyline2 bent(const Polyline2& own, Random& random) {
  const double bend = random.uniform(-0.25, 0.25) * own.length(), lean = random.uniform(-0.3, 0.3);
  std::vector<Vec2> points = own.points();
  const Vec2 first = points.front();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(points.size() - 1);
    const Vec2 off = points[i] - first;
    points[i] += Vec2(bend * std::sin(kPi * t), 0) + lean * Vec2(-off.y(), off.x());
  }
  return Polyline2(Polyline2(points).resampled(96));
}

double largest_turn(const Pose& a, const Pose& b) {
  double most = 0.0;
  for (std::size_t i = 0; i < a.local.size(); ++i) {
    most = std::max(most, a.local[i].rotation.angularDistance(b.local[i].rotation));
  }
  return most / kDegree;
}

class RealRigs : public testing::TestWithParam<const char*> {};

TEST_P(RealRigs, KeepThePromisesOfEveryAnswer) {
  const std::optional<Character> character = open_rig(GetParam());
  if (!character) GTEST_SKIP() << GetParam() << " is not there";
  const Skeleton& skeleton = character->skeleton;
  const Pose& start = character->start;
  const std::vector<BodyLine> lines = standard_body_lines(skeleton, character->humanoid);
  if (lines.empty()) GTEST_SKIP() << "joints that all hang on one make no line";
  Random random(11);
  int drawn = 0;
  const int rounds = skeleton.joint_count() > 200 ? 3 : 6;  // three strands of a hundred joints take their time
  for (int round = 0; round < rounds; ++round) {
    const BodyLine& line = lines[static_cast<std::size_t>(random.index(std::min(8, static_cast<int>(lines.size()))))];
    SCOPED_TRACE(line.name + ", round " + std::to_string(round));
    const Camera camera = camera_on(skeleton, start, round % 2 == 1, random.uniform(0, 6.28));
    Polyline2 own({Vec2::Zero()});
    try {
      own = extract_line(skeleton, start, line, camera);
    } catch (const Error&) {
      continue;  // seen end-on
    }
    ++drawn;
    LineSolverOptions options;
    options.limits = make_joint_limits(skeleton, character->humanoid, LimitPreset::anatomical, start);
    const LineInput input{line, bent(own, random), LineInput::Direction::forward};
    const LineSolverResult result = solve_lines(skeleton, character->humanoid, start, {input}, camera, options);
    for (const Transform& local : result.pose.local) ASSERT_TRUE(local.is_finite());
    EXPECT_LT(result.bone_length_drift, 1e-9);
    const std::vector<int> before = find_limit_violations(options.limits, start);
    for (const int joint : find_limit_violations(options.limits, result.pose)) {
      EXPECT_EQ(std::count(before.begin(), before.end(), joint), 1) << skeleton.reference(joint);
    }
    // The same input gives the same output, more samples hardly another, and the line that a pose has changes nothing.
    const LineSolverResult again = solve_lines(skeleton, character->humanoid, start, {input}, camera, options);
    EXPECT_EQ(result.pose, again.pose);
    const LineInput redrawn{line, own, LineInput::Direction::forward};
    EXPECT_LT(largest_turn(solve_lines(skeleton, character->humanoid, start, {redrawn}, camera, options).pose, start),
              0.1);
    // A pen that draws it, point by point, moves the same bones by as little each time and lengthens none.
    LiveLine live(skeleton, character->humanoid, start, line, LineInput::Direction::forward, camera, options);
    const std::vector<Vec2> points = input.stroke.resampled(40);
    for (std::size_t n = 2; n <= points.size(); n += 6) (void)live.update(std::span(points).first(n));
    EXPECT_LT(bone_length_drift(skeleton, start, live.pose()), 1e-9);
    for (const Transform& local : live.pose().local) ASSERT_TRUE(local.is_finite());
  }
  EXPECT_GT(drawn, 1);
}

std::string test_name(const testing::TestParamInfo<const char*>& info) {
  std::string name(info.param);
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Files, RealRigs, testing::ValuesIn(kRigs), test_name);

}  // namespace
}  // namespace croquis
