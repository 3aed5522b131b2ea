// SPDX-License-Identifier: MIT
// Limits are kept by projection and an active set inside the descent: a step may slide along a limit, never through it,
// so that the neighbours of a joint that has reached its end take over what it cannot do. A limit's coordinates have no
// short derivative; central differences of three numbers cost less than a microsecond and only at joints on a border.
#include "croquis/posing/line_limits.h"

#include <algorithm>
#include <cmath>

#include "croquis/math/rotation.h"

namespace croquis {
namespace {

Quat local_rotation(const LineLimit& limit, const Quat& turn) {
  const Mat3 local = limit.above.transpose() * turn.toRotationMatrix() * limit.above;
  return (Quat(local) * limit.start_local).normalized();
}

Vec2 radii_at(const JointLimit& limit, const Vec3& at) {
  const Vec2 radii(at.x() < 0.0 ? -limit.swing_min.x() : limit.swing_max.x(),
                   at.y() < 0.0 ? -limit.swing_min.y() : limit.swing_max.y());
  return radii.cwiseMax(1e-9);
}

}  // namespace

bool widen_limit(JointLimit& limit, const Quat& local) {
  const Vec3 at = limit_coordinates(limit, local);
  if (limit_violation(limit, local) <= 1e-9) return false;
  constexpr double kRoom = 1.0 + 1e-6;
  const double out = at.head<2>().cwiseQuotient(radii_at(limit, at)).norm() * kRoom;
  if (out > 1.0) {
    double& x = at.x() < 0.0 ? limit.swing_min.x() : limit.swing_max.x();
    double& y = at.y() < 0.0 ? limit.swing_min.y() : limit.swing_max.y();
    // Each axis grows as far as it takes part; a hinge that is bent sideways does not get looser in its own direction.
    x = (at.x() < 0.0 ? -1.0 : 1.0) * std::max(std::abs(x), std::abs(at.x()) * std::sqrt(2.0) * kRoom);
    y = (at.y() < 0.0 ? -1.0 : 1.0) * std::max(std::abs(y), std::abs(at.y()) * std::sqrt(2.0) * kRoom);
  }
  limit.twist_min = std::min(limit.twist_min, at.z() - 1e-6);
  limit.twist_max = std::max(limit.twist_max, at.z() + 1e-6);
  return true;
}

void clamp_to_limits(const LineProblem& problem, LineState& state, std::vector<Crossing>& touched) {
  touched.clear();
  for (std::size_t i = 0; i < problem.limits.size(); ++i) {
    const LineLimit& limit = problem.limits[i];
    Quat& turn = state.turn[static_cast<std::size_t>(limit.node)];
    const Quat local = local_rotation(limit, turn);
    if (limit_violation(limit.limit, local) <= 0.0) continue;
    const Quat inside = clamp_to_limit(limit.limit, local);
    const Vec3 crossed = limit_coordinates(limit.limit, local) - limit_coordinates(limit.limit, inside);
    if (crossed.norm() > 1e-9) touched.push_back({i, crossed.normalized()});
    const Mat3 back = (inside * limit.start_local.conjugate()).normalized().toRotationMatrix();
    turn = Quat(Mat3(limit.above * back * limit.above.transpose())).normalized();
  }
  if (!touched.empty()) problem.update(state);
}

Vec3 limit_normal(const LineProblem& problem, const LineState& state, std::size_t index, const Vec3& outward) {
  const LineLimit& limit = problem.limits[index];
  const Quat& turn = state.turn[static_cast<std::size_t>(limit.node)];
  constexpr double kStep = 1e-5;
  Vec3 normal = Vec3::Zero();
  for (int axis = 0; axis < 3; ++axis) {
    const Quat by = rotation_from_vector(kStep * Vec3::Unit(axis));
    const Vec3 ahead = limit_coordinates(limit.limit, local_rotation(limit, by * turn));
    const Vec3 back = limit_coordinates(limit.limit, local_rotation(limit, by.conjugate() * turn));
    normal[axis] = outward.dot(ahead - back) / (2.0 * kStep);
  }
  return normal;
}

void find_active_limits(const LineProblem& problem, const LineState& state, const Eigen::VectorXd& gradient,
                        std::vector<ActiveLimit>& active) {
  active.clear();
  constexpr double kNear = 1e-6;
  for (std::size_t i = 0; i < problem.limits.size(); ++i) {
    const LineLimit& limit = problem.limits[i];
    const Vec3 at =
        limit_coordinates(limit.limit, local_rotation(limit, state.turn[static_cast<std::size_t>(limit.node)]));
    const int column = problem.nodes[static_cast<std::size_t>(limit.node)].column;
    const auto consider = [&](const Vec3& outward) {
      const Vec3 normal = limit_normal(problem, state, i, outward.normalized());
      if (gradient.segment<3>(column).dot(normal) < 0.0) active.push_back({i, column, normal});
    };
    const Vec2 radii = radii_at(limit.limit, at);
    const Vec2 part = at.head<2>().cwiseQuotient(radii);
    if (part.norm() >= 1.0 - kNear) {
      const Vec2 out = part.cwiseQuotient(radii);
      consider(Vec3(out.x(), out.y(), 0.0));
    }
    if (at.z() >= limit.limit.twist_max - kNear) consider(Vec3(0, 0, 1));
    if (at.z() <= limit.limit.twist_min + kNear) consider(Vec3(0, 0, -1));
  }
}

}  // namespace croquis
