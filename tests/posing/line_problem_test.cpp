// SPDX-License-Identifier: MIT
#include "croquis/posing/line_problem.h"

#include "support/test_rigs.h"
#include <cmath>

#include <gtest/gtest.h>

#include "croquis/posing/line_descent.h"
#include "croquis/posing/line_scene.h"
#include "croquis/solve/derivative_check.h"

namespace croquis {
namespace {

Polyline2 s_curve() {
  std::vector<Vec2> points;
  for (int i = 0; i < 60; ++i) points.emplace_back(500 + 80 * std::sin(i / 9.0), 900 - 12.0 * i);
  return Polyline2(Polyline2(points).resampled(96));
}

Camera camera_of(Camera::Projection projection) {
  Camera camera;
  camera.projection = projection;
  camera.position = Vec3(1.5, 1.8, 4);
  return camera;
}

/// The error of the analytic slopes at a random state.
double slope_error(LineProblem& problem, Random& random, double size) {
  LineState start = problem.start_state();
  start.along.back().front() = 0.02;  // away from the stroke's end, where arc lengths are clamped
  LineState base = start, moved = start;
  Eigen::VectorXd step(problem.unknowns());
  for (int i = 0; i < problem.unknowns(); ++i) step[i] = size * random.uniform(-1, 1);
  for (const LinePath& path : problem.paths) {
    for (std::size_t k = 0; k < path.nodes.size(); ++k) step[path.column + static_cast<int>(k)] *= 0.02;
  }
  problem.advance(start, step, base);
  // The model that the solver uses agrees with the rows ...
  LineModel model;
  problem.prepare(model);
  problem.linearise(base, model);
  Eigen::VectorXd residuals;
  Eigen::MatrixXd slopes;
  problem.list_residuals(base, residuals, &slopes);
  EXPECT_NEAR(model.energy, 0.5 * residuals.squaredNorm(), 1e-12 * model.energy);
  EXPECT_NEAR(problem.energy(base), model.energy, 1e-12 * model.energy);
  EXPECT_LT((model.gradient - slopes.transpose() * residuals).norm(), 1e-10 * (1.0 + model.gradient.norm()));
  const Eigen::MatrixXd full = model.normal.selfadjointView<Eigen::Lower>();
  EXPECT_LT((full - slopes.transpose() * slopes).norm(), 1e-10 * full.norm());
  // ... and the rows with differences.
  return jacobian_error(
      [&](const Eigen::VectorXd& x, Eigen::MatrixXd* jacobian) {
        problem.advance(base, x, moved);
        problem.list_residuals(moved, residuals, jacobian);
        return residuals;
      },
      Eigen::VectorXd::Zero(problem.unknowns()));
}

TEST(LineProblem, SlopesAgreeWithDifferences) {
  Random random(5);
  for (const auto projection : {Camera::Projection::orthographic, Camera::Projection::perspective}) {
    for (int round = 0; round < 11; ++round) {
      const Skeleton skeleton = make_test_humanoid(round == 0 ? 0 : random.bits() | 1U);
      const Pose start = random_pose(skeleton, random, 0.3);
      LineInput line{{"", skeleton.path(skeleton.resolve("leftFoot"), skeleton.resolve("rightHand"))}, s_curve()};
      LineInput second{{"", skeleton.path(0, skeleton.resolve("head"))}, s_curve()};
      LineSolverOptions options;
      options.weights.depth = options.weights.turn = options.weights.share = options.weights.slide = 0.3;
      options.weights.pin = 2.0;
      LineScene scene(skeleton, HumanoidMap{}, start, {line, second}, camera_of(projection), options);
      LineProblem& problem = scene.problem;
      problem.paths[0].slide_to.assign(problem.paths[0].nodes.size(), 0.3);
      problem.paths[1].hold_first = false;
      problem.pins.push_back({scene.node_of(skeleton.resolve("leftFoot")), Vec3(0.1, 0.2, 0.3)});
      problem.finish();
      EXPECT_LT(slope_error(problem, random, round == 0 ? 0.05 : 0.8), 2e-6);
    }
  }
}

/// With joints told where they lie on the stroke, seen without perspective and free of what turning costs, all that is
/// left of the energy's second derivative is J'J and `circling`.
TEST(LineProblem, CirclingIsWhatTheNormalMatrixLeavesOut) {
  Random random(15);
  for (int round = 0; round < 8; ++round) {
    const Skeleton skeleton = make_test_humanoid(random.bits() | 1U);
    const LineInput line{{"", skeleton.path(skeleton.resolve("leftFoot"), skeleton.resolve("rightHand"))}, s_curve()};
    LineSolverOptions options;
    options.avoid_overlap = false;
    options.weights.turn = options.weights.share = 0.0;
    options.weights.pin = 2.0;
    LineScene scene(skeleton, {}, random_pose(skeleton, random, 0.3), {line},
                    camera_of(Camera::Projection::orthographic), options);
    LineProblem& problem = scene.problem;
    problem.paths[0].fixed = true;
    problem.pins.push_back({scene.node_of(skeleton.resolve("leftFoot")), Vec3(0.1, 0.2, 0.3)});
    problem.finish();
    const LineState state = problem.start_state();
    LineState moved = state;
    LineModel model;
    model.exact = true;
    problem.prepare(model);
    problem.linearise(state, model);
    Eigen::VectorXd step(problem.unknowns());
    for (int i = 0; i < problem.unknowns(); ++i) step[i] = random.uniform(-1, 1);
    constexpr double kStep = 1e-4;
    const auto energy = [&](double factor) {
      problem.advance(state, factor * step, moved);
      return problem.energy(moved);
    };
    const double second = (energy(kStep) - 2.0 * energy(0.0) + energy(-kStep)) / (kStep * kStep);
    const Eigen::MatrixXd circling = model.circling.selfadjointView<Eigen::Lower>();
    const Eigen::MatrixXd normal = model.normal.selfadjointView<Eigen::Lower>();
    EXPECT_NEAR(step.dot((normal + circling) * step), second, 1e-5 * std::abs(second));
    EXPECT_GT(std::abs(step.dot(circling * step)), 1e-3 * std::abs(second));
  }
}

TEST(LineProblem, ForwardKinematicsOfTheResultAgree) {
  Random random(9);
  const Skeleton skeleton = make_test_humanoid(77);
  const Pose start = random_pose(skeleton, random, 0.5);
  const LineInput line{{"", skeleton.path(skeleton.resolve("leftFoot"), skeleton.resolve("rightHand"))}, s_curve()};
  const Camera camera = camera_of(Camera::Projection::perspective);
  LineScene scene(skeleton, HumanoidMap{}, start, {line}, camera, {});
  LineState state = scene.problem.start_state(), moved = state;
  Eigen::VectorXd step(scene.problem.unknowns());
  for (int i = 0; i < step.size(); ++i) step[i] = random.uniform(-1, 1);
  scene.problem.advance(state, step, moved);
  Pose pose;
  scene.write_pose(moved, pose);
  const std::vector<Vec3> positions = compute_positions(skeleton, pose);
  const Affine view = camera.view_from_world();
  for (const int joint : line.line.joints) {
    const Vec3 expected = moved.position[static_cast<std::size_t>(scene.node_of(joint))] * scene.unit();
    EXPECT_LT((view * positions[static_cast<std::size_t>(joint)] - expected).norm(), 1e-9);
  }
}

TEST(LineProblem, TheLogarithmsSlopeIsExactAwayFromZero) {
  Random random(2);
  for (int round = 0; round < 20; ++round) {
    const Vec3 r = rotation_to_vector(random_rotation(random)) * (round == 0 ? 1e-6 : 1.0);
    const double error = jacobian_error(
        [&](const Eigen::VectorXd& v, Eigen::MatrixXd* jacobian) {
          if (jacobian) *jacobian = left_jacobian_inverse(r);
          return Eigen::VectorXd(rotation_to_vector(rotation_from_vector(Vec3(v)) * rotation_from_vector(r)));
        },
        Eigen::VectorXd::Zero(3));
    EXPECT_LT(error, 1e-6);
  }
}

}  // namespace
}  // namespace croquis
