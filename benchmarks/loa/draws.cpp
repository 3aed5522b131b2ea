// SPDX-License-Identifier: MIT
#include "loa/draws.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Cholesky>

#include "croquis/base/random.h"

namespace croquis::loa {
namespace {

constexpr std::array<const char*, 9> kLines = {"left_foot-head",
                                               "right_foot-head",
                                               "left_foot-right_hand",
                                               "right_foot-left_hand",
                                               "left_hand-right_hand",
                                               "left_foot-left_hand",
                                               "trunk",
                                               "left_arm",
                                               "left_leg"};

/// Uniform cubic B-spline basis over [0, 1] with `count` coefficients.
Eigen::VectorXd basis(double u, int count) {
  Eigen::VectorXd row = Eigen::VectorXd::Zero(count);
  const double x = u * (count - 3);
  const int k = std::min(static_cast<int>(x), count - 4);
  const double t = x - k, s = 1.0 - t;
  row[k] = s * s * s / 6.0;
  row[k + 1] = (3 * t * t * t - 6 * t * t + 4) / 6.0;
  row[k + 2] = (-3 * t * t * t + 3 * t * t + 3 * t + 1) / 6.0;
  row[k + 3] = t * t * t / 6.0;
  return row;
}

/// A C2 curve near the joints: a cubic B-spline on equal knots, its bend held down. Returns 96 points at equal arc
/// lengths and where along it the joints lie.
Polyline2 draw_through(const std::vector<Vec2>& joints, std::vector<double>& along) {
  constexpr int kCount = 14;
  std::vector<double> u{0.0};
  for (std::size_t i = 1; i < joints.size(); ++i) u.push_back(u.back() + (joints[i] - joints[i - 1]).norm());
  for (double& value : u) value /= u.back();
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(kCount, kCount);
  Eigen::MatrixXd b = Eigen::MatrixXd::Zero(kCount, 2);
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const double weight = i == 0 || i + 1 == joints.size() ? 100.0 : 1.0;
    const Eigen::VectorXd row = basis(u[i], kCount);
    a += weight * row * row.transpose();
    b += weight * row * joints[i].transpose();
  }
  for (int k = 1; k + 1 < kCount; ++k) {
    Eigen::VectorXd row = Eigen::VectorXd::Zero(kCount);
    row[k - 1] = row[k + 1] = 1.0;
    row[k] = -2.0;
    a += 0.02 * row * row.transpose();
  }
  const Eigen::MatrixXd coefficients = a.ldlt().solve(b);
  std::vector<Vec2> fine;
  for (int i = 0; i <= 800; ++i) fine.emplace_back(coefficients.transpose() * basis(i / 800.0, kCount));
  const Polyline2 curve(fine);
  along.clear();
  for (const double value : u) {
    along.push_back(curve.arc()[static_cast<std::size_t>(std::lround(800 * value))] / curve.length());
  }
  return Polyline2(curve.resampled(96));
}

Camera make_camera(int azimuth, int lens, const Vec3& centre, double height) {
  Camera camera;
  const double angle = 0.25 * kPi * azimuth;
  camera.target = centre;
  const Vec3 toward(std::sin(angle), 0.0, std::cos(angle));
  camera.height = 1.6 * height;
  double distance = 4.0 * height;
  if (lens > 0) {
    camera.projection = Camera::Projection::perspective;
    camera.fov_degrees = 2.0 * std::atan(12.0 / (lens == 1 ? 50.0 : 24.0)) / kDegree;
    distance = 0.8 * height / std::tan(0.5 * camera.fov_degrees * kDegree);
  }
  camera.position = centre + distance * toward;
  return camera;
}

bool project_line(const Draw& draw, const Pose& pose, std::vector<Vec2>& out) {
  const std::vector<Vec3> x = compute_positions(draw.clip->character.skeleton, pose);
  out.clear();
  for (const int joint : draw.line.joints) {
    const auto pixel = draw.camera.project(x[static_cast<std::size_t>(joint)]);
    if (!pixel) return false;
    out.push_back(*pixel);
  }
  return true;
}

/// Slow wander of a hand: a few sines with random phases; `size` is the root mean square distance that points move.
void add_noise(std::vector<Vec2>& points, double size, Random& random) {
  for (int axis = 0; axis < 2; ++axis) {
    for (int wave = 1; wave <= 6; ++wave) {
      const double amplitude = size * random.normal() / std::sqrt(6.0), phase = random.uniform(0.0, 2.0 * kPi);
      for (std::size_t i = 0; i < points.size(); ++i) {
        points[i][axis] += amplitude * std::sin(phase + 2.0 * kPi * wave * static_cast<double>(i) /
                                                            static_cast<double>(points.size()));
      }
    }
  }
}

}  // namespace

DrawSet make_draws(const std::filesystem::path& folder, const DrawOptions& options) {
  DrawSet set;
  set.clips = read_clips(folder, options.poses, options.seed, set.notes);
  Random random(options.seed * 7919 + 17);
  std::vector<Vec2> truth, start;
  for (const Clip& clip : set.clips) {
    const HumanoidMap& map = clip.character.humanoid;
    for (const Pose& pose : clip.poses) {
      const Vec3 hips =
          compute_positions(clip.character.skeleton, pose)[static_cast<std::size_t>(map.joint(HumanoidBone::hips))];
      for (const char* name : kLines) {
        for (int view = 0; view < options.views; ++view) {
          Draw draw;
          draw.clip = &clip;
          draw.line = find_body_line(clip.character.skeleton, map, name);
          draw.truth = pose;
          draw.start = place_neutral(clip, pose);
          draw.camera = make_camera(random.index(8), random.index(3), hips, clip.height);
          if (!project_line(draw, draw.truth, truth) || !project_line(draw, draw.start, start)) continue;
          const double pixels_per_height = clip.height / draw.camera.units_per_pixel(hips);
          if (Polyline2(truth).length() < 0.15 * pixels_per_height) {
            ++set.too_short;
            continue;
          }
          double off = 0.0;
          for (std::size_t i = 0; i < truth.size(); ++i) off += (truth[i] - start[i]).norm();
          if (off / static_cast<double>(truth.size()) < 0.06 * pixels_per_height) {
            ++set.too_easy;
            continue;
          }
          draw.stroke = draw_through(truth, draw.truth_along);
          if (options.noise_percent > 0.0) {
            std::vector<Vec2> points = draw.stroke.points();
            add_noise(points, 0.01 * options.noise_percent * pixels_per_height, random);
            draw.stroke = Polyline2(Polyline2(points).resampled(96));
          }
          set.draws.push_back(std::move(draw));
        }
      }
    }
  }
  return set;
}

}  // namespace croquis::loa
