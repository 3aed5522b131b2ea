// SPDX-License-Identifier: MIT
// What the line solver keeps beside the line: floor, feet, balance, limbs apart, pins with a direction.
#include "support/test_rigs.h"
#include <cmath>

#include <gtest/gtest.h>

#include "croquis/posing/body_shape.h"
#include "croquis/posing/extract_line.h"
#include "croquis/posing/line_scene.h"
#include "croquis/posing/line_solver.h"
#include "croquis/posing/pose_edit.h"
#include "croquis/posing/standing.h"
#include "croquis/solve/derivative_check.h"

namespace croquis {
namespace {

struct Person {
  explicit Person(std::uint64_t seed = 3)
      : skeleton(make_test_humanoid(seed)), humanoid(recognise_humanoid(skeleton)), start(rest_pose(skeleton)) {}
  [[nodiscard]] BodyLine line(const char* from, const char* to) const {
    return {"", skeleton.path(skeleton.resolve(from), skeleton.resolve(to))};
  }
  [[nodiscard]] Vec3 at(const Pose& pose, const char* joint) const {
    return compute_positions(skeleton, pose)[static_cast<std::size_t>(skeleton.resolve(joint))];
  }
  /// The line that the start pose has, its points moved.
  template <class Move>
  [[nodiscard]] LineInput drawn(const BodyLine& body_line, const Camera& camera, Move move) const {
    std::vector<Vec2> points = extract_line(skeleton, start, body_line, camera).points();
    for (Vec2& point : points) point = move(point);
    return {body_line, Polyline2(points), LineInput::Direction::forward};
  }
  Skeleton skeleton;
  HumanoidMap humanoid;
  Pose start;
};

TEST(BodyTerms, SlopesAgreeWithDifferences) {
  Random random(77);
  int floors = 0, overlaps = 0, balances = 0;
  for (int round = 0; round < 12; ++round) {
    const std::uint64_t seed = random.bits() | 1U;
    const Person person(seed);
    LineInput input = person.drawn(person.line("leftFoot", "rightHand"), Camera{}, [](const Vec2& p) { return p; });
    LineSolverOptions options;
    options.floor = 0.05;
    options.balance = true;
    options.move_body = true;
    options.weights.pin = options.weights.pin_turn = options.weights.floor = 2.0;
    const int hand = person.skeleton.resolve("leftHand");
    options.pins.push_back({hand, Vec3(0.2, 1, 0.3), random_rotation(random)});
    LineScene scene(person.skeleton, person.humanoid, person.start, {input}, Camera{}, options);
    LineProblem& problem = scene.problem;
    for (auto& pair : problem.body.pairs) pair.apart *= 2.0;  // so that some do touch
    LineState base = problem.start_state(), moved = base;
    Eigen::VectorXd step(problem.unknowns());
    for (int i = 0; i < problem.unknowns(); ++i) step[i] = 0.7 * random.uniform(-1, 1);
    for (std::size_t k = 0; k < problem.paths[0].nodes.size(); ++k)
      step[problem.paths[0].column + static_cast<int>(k)] = 0.0;
    problem.advance(problem.start_state(), step, base);
    Eigen::VectorXd residuals;
    Eigen::MatrixXd slopes;
    problem.list_residuals(base, residuals, &slopes);
    // The last residuals are the body's: floor, pairs, balance.
    const auto count = static_cast<Eigen::Index>(problem.body.floor.size() + problem.body.pairs.size() + 1);
    const Eigen::VectorXd own = residuals.tail(count);
    floors += static_cast<int>((own.head(std::ssize(problem.body.floor)).array() != 0.0).count());
    overlaps += static_cast<int>(
        (own.segment(std::ssize(problem.body.floor), std::ssize(problem.body.pairs)).array() != 0.0).count());
    balances += own[count - 1] != 0.0 ? 1 : 0;
    LineModel model;
    problem.prepare(model);
    problem.linearise(base, model);
    EXPECT_NEAR(problem.energy(base), 0.5 * residuals.squaredNorm(), 1e-12 * (1 + model.energy));
    EXPECT_LT((model.gradient - slopes.transpose() * residuals).norm(), 1e-9 * (1.0 + model.gradient.norm()));
    const Eigen::MatrixXd full = model.normal.selfadjointView<Eigen::Lower>();
    EXPECT_LT((full - slopes.transpose() * slopes).norm(), 1e-9 * full.norm());
    const double error = jacobian_error(
        [&](const Eigen::VectorXd& x, Eigen::MatrixXd* jacobian) {
          problem.advance(base, x, moved);
          problem.list_residuals(moved, residuals, jacobian);
          return residuals;
        },
        Eigen::VectorXd::Zero(problem.unknowns()));
    EXPECT_LT(error, 5e-6) << "seed " << seed;
  }
  EXPECT_GT(floors, 5);
  EXPECT_GT(overlaps, 5);
  EXPECT_GT(balances, 5);
}

TEST(BodyTerms, NothingGoesBelowTheFloor) {
  const Person person;
  LineSolverOptions options;
  options.floor = 0.0;
  options.stand = false;
  // The whole line drawn lower by a fifth of the body, and crooked.
  const LineInput input = person.drawn(person.line("leftFoot", "head"), Camera{}, [](const Vec2& p) {
    return Vec2(p.x() + 0.001 * p.y() * p.y() - 0.5 * p.y(), p.y() + 160);
  });
  const LineSolverResult kept = solve_lines(person.skeleton, person.humanoid, person.start, {input}, Camera{}, options);
  options.floor.reset();
  const LineSolverResult sunk = solve_lines(person.skeleton, person.humanoid, person.start, {input}, Camera{}, options);
  double lowest = 1.0, lowest_free = 1.0;
  for (const Vec3& x : compute_positions(person.skeleton, kept.pose)) lowest = std::min(lowest, x.y());
  for (const Vec3& x : compute_positions(person.skeleton, sunk.pose)) lowest_free = std::min(lowest_free, x.y());
  EXPECT_LT(lowest_free, -0.1);
  EXPECT_GT(lowest, -2e-3 * person.skeleton.extent());
}

TEST(BodyTerms, FeetThatStandGoOnStanding) {
  const Person person;
  LineSolverOptions options;
  options.floor = 0.0;
  options.limits = make_joint_limits(person.skeleton, person.humanoid, LimitPreset::anatomical);
  // A trunk that leans over and comes down a little: both knees must bend.
  const BodyLine trunk{"", person.skeleton.path(0, person.skeleton.resolve("head"))};
  const LineInput input =
      person.drawn(trunk, Camera{}, [](const Vec2& p) { return Vec2(p.x() + 0.3 * (600 - p.y()), p.y() + 40); });
  const LineSolverResult result =
      solve_lines(person.skeleton, person.humanoid, person.start, {input}, Camera{}, options);
  EXPECT_EQ(result.report.status, "ok");
  EXPECT_LT(result.fits[0].mean_px, 8.0);
  const std::vector<Quat> before = compute_model_rotations(person.skeleton, person.start),
                          after = compute_model_rotations(person.skeleton, result.pose);
  for (const char* foot : {"leftFoot", "rightFoot"}) {
    EXPECT_LT((person.at(result.pose, foot) - person.at(person.start, foot)).norm(), 1e-4 * person.skeleton.extent());
    const auto joint = static_cast<std::size_t>(person.skeleton.resolve(foot));
    EXPECT_LT(before[joint].angularDistance(after[joint]) / kDegree, 3.0);
  }
  // Knees go forward (+Z), and no limit is broken.
  EXPECT_GT(person.at(result.pose, "leftLowerLeg").z(), person.at(result.pose, "leftFoot").z());
  EXPECT_TRUE(result.limit_violations.empty());
}

TEST(BodyTerms, AJumpLiftsTheFeet) {
  const Person person;
  LineSolverOptions options;
  options.floor = 0.0;
  const BodyLine trunk{"", person.skeleton.path(0, person.skeleton.resolve("head"))};
  const LineInput input = person.drawn(trunk, Camera{}, [](const Vec2& p) { return Vec2(p - Vec2(0, 200)); });
  ASSERT_EQ(pin_standing_feet(person.skeleton, person.humanoid, person.start, {input}, options).size(), 2U);
  const LineSolverResult result =
      solve_lines(person.skeleton, person.humanoid, person.start, {input}, Camera{}, options);
  EXPECT_EQ(result.report.status, "ok");
  EXPECT_LT(result.fits[0].mean_px, 2.0);
  EXPECT_GT(person.at(result.pose, "leftFoot").y(), person.at(person.start, "leftFoot").y() + 0.2);
}

TEST(BodyTerms, AFootWithALineOfItsOwnIsNotHeld) {
  const Person person;
  LineSolverOptions options;
  options.floor = 0.0;
  const LineInput input = person.drawn(person.line("leftFoot", "head"), Camera{}, [](const Vec2& p) { return p; });
  const auto pins = pin_standing_feet(person.skeleton, person.humanoid, person.start, {input}, options);
  ASSERT_EQ(pins.size(), 1U);
  EXPECT_EQ(pins.front().joint, person.skeleton.resolve("rightFoot"));
  options.stand = false;
  EXPECT_TRUE(pin_standing_feet(person.skeleton, person.humanoid, person.start, {input}, options).empty());
}

TEST(BodyTerms, BalanceBringsTheMassOverTheFeet) {
  const Person person;
  LineSolverOptions options;
  options.floor = 0.0;
  options.weights.position = options.weights.inner = 0.02;  // a line that only hints
  const BodyLine trunk{"", person.skeleton.path(0, person.skeleton.resolve("head"))};
  const LineInput input =
      person.drawn(trunk, Camera{}, [](const Vec2& p) { return Vec2(p.x() + 0.8 * (700 - p.y()), p.y()); });
  const auto lean = [&](bool balance) {
    options.balance = balance;
    const Pose pose = solve_lines(person.skeleton, person.humanoid, person.start, {input}, Camera{}, options).pose;
    return person.at(pose, "head").x();
  };
  EXPECT_LT(lean(true), lean(false) - 0.02);
}

TEST(BodyTerms, LimbsDoNotPassThroughEachOther) {
  // An arm drawn across the body: in the picture over the chest, in space it must not lie inside it.
  Random random(13);
  double with = 0.0, without = 0.0;
  for (int round = 0; round < 8; ++round) {
    const Person person(random.bits() | 1U);
    const auto pixel = [&](const char* joint) { return *Camera{}.project(person.at(person.start, joint)); };
    const Vec2 shoulder = pixel("leftUpperArm"), hips = *Camera{}.project(person.at(person.start, "rightUpperLeg"));
    const Vec2 elbow = 0.5 * (shoulder + hips) + Vec2(20 * random.uniform(-1, 1), 20);
    const LineInput input{person.line("leftUpperArm", "leftHand"),
                          Polyline2(Polyline2({shoulder, elbow, hips}).resampled(64)), LineInput::Direction::forward};
    LineSolverOptions options;
    const LineSolverResult kept =
        solve_lines(person.skeleton, person.humanoid, person.start, {input}, Camera{}, options);
    with = std::max(with, kept.overlap);
    EXPECT_LT(kept.fits[0].mean_px, 12.0);
    options.weights.overlap = 0.0;
    without = std::max(without,
                       solve_lines(person.skeleton, person.humanoid, person.start, {input}, Camera{}, options).overlap);
  }
  EXPECT_GT(without, 0.02);
  EXPECT_LT(with, 0.005);
}

TEST(BodyTerms, APinHoldsADirectionToo) {
  const Person person;
  LineSolverOptions options;
  const int hand = person.skeleton.resolve("rightHand");
  const Quat turned = rotation_from_vector(Vec3(0.2, 0.4, -0.3)) *
                      compute_model_rotations(person.skeleton, person.start)[static_cast<std::size_t>(hand)];
  options.pins.push_back({hand, person.at(person.start, "rightHand") + Vec3(0.1, -0.05, 0.1), turned});
  const BodyLine trunk{"", person.skeleton.path(0, person.skeleton.resolve("head"))};
  const LineInput input =
      person.drawn(trunk, Camera{}, [](const Vec2& p) { return Vec2(p.x() + 0.1 * (600 - p.y()), p.y()); });
  const LineSolverResult result =
      solve_lines(person.skeleton, person.humanoid, person.start, {input}, Camera{}, options);
  EXPECT_EQ(result.report.status, "ok");
  EXPECT_TRUE(result.pins_missed.empty());
  EXPECT_LT(
      compute_model_rotations(person.skeleton, result.pose)[static_cast<std::size_t>(hand)].angularDistance(turned) /
          kDegree,
      0.5);
}

TEST(BodyTerms, PressureAndWeightSayWhatCounts) {
  // Two strokes that contradict each other for the same chain: the heavier is followed.
  const Skeleton skeleton = make_chain(3, 0.4, 5);
  const BodyLine line{"", {0, 1, 2}};
  const auto to = [](double x) { return Polyline2(Polyline2({Vec2(512, 700), Vec2(512 + x, 400)}).resampled(32)); };
  const auto tip = [&](double left, double right, double pressed) {
    LineInput a{line, to(-200), LineInput::Direction::forward}, b{line, to(200), LineInput::Direction::forward};
    a.weight = left;
    b.weight = right;
    b.pressure.assign(32, pressed);
    const Pose pose = solve_lines(skeleton, {}, rest_pose(skeleton), {a, b}, Camera{}).pose;
    return Camera{}.project(compute_positions(skeleton, pose)[2])->x() - 512;
  };
  EXPECT_LT(tip(20, 1, 1), -100);
  EXPECT_GT(tip(1, 20, 1), 100);
  EXPECT_LT(tip(1, 20, 0.002), -100);
}

TEST(BodyTerms, NearestPointsOfSegments) {
  const NearestPoints cross = nearest_points({-1, 0, 0}, {1, 0, 0}, {0, -1, 2}, {0, 3, 2});
  EXPECT_NEAR(cross.s, 0.5, 1e-12);
  EXPECT_NEAR(cross.t, 0.25, 1e-12);
  EXPECT_NEAR(cross.distance, 2.0, 1e-12);
  EXPECT_NEAR(nearest_points({0, 0, 0}, {1, 0, 0}, {3, 1, 0}, {5, 1, 0}).distance, std::sqrt(5.0), 1e-12);
  EXPECT_NEAR(nearest_points({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}).distance, 1.0, 1e-12);
  EXPECT_NEAR(nearest_points({0, 0, 0}, {0, 0, 0}, {3, 4, 0}, {3, 4, 0}).distance, 5.0, 1e-12);
}

}  // namespace
}  // namespace croquis
