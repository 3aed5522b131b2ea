// SPDX-License-Identifier: MIT
#include "croquis/posing/line_start.h"

#include <algorithm>
#include <cmath>

#include "croquis/math/rotation.h"

namespace croquis {
namespace {

/// Turns node i by a rotation in view axes, and all below it.
void turn_node(const LineProblem& problem, LineState& state, int i, const Quat& rotation) {
  const auto at = static_cast<std::size_t>(i);
  if (problem.nodes[at].column < 0) return;
  Quat above = Quat::Identity();
  if (problem.nodes[at].parent >= 0) above = Quat(state.frame[static_cast<std::size_t>(problem.nodes[at].parent)]);
  state.turn[at] = (above.conjugate() * rotation * above * state.turn[at]).normalized();
  problem.update(state);
}

/// The bone from joint k to k + 1 (or back) as the stroke wants it.
Vec3 wanted_bone(const LineProblem& problem, const LinePath& path, const std::vector<double>& along,
                 const LineState& state, std::size_t k, int sign) {
  const Vec3& x = state.position[static_cast<std::size_t>(path.nodes[k])];
  const Vec2 chord = (path.curve.at(along[k + 1]) - path.curve.at(along[k])) / problem.magnification(x);
  const double length = path.bones[k], flat = chord.norm();
  const double depth = std::sqrt(std::max(0.0, length * length - flat * flat));
  const double side = sign != 0 ? sign : (path.start_depth[k] < 0.0 ? -1.0 : 1.0);
  return {chord.x(), chord.y(), side * depth};
}

}  // namespace

void measure_bones(const LineProblem& problem, const LinePath& path, std::vector<BoneSpan>& bones) {
  bones.clear();
  for (std::size_t k = 0; k < path.bones.size(); ++k) {
    const Vec3 middle = 0.5 * (problem.nodes[static_cast<std::size_t>(path.nodes[k])].start +
                               problem.nodes[static_cast<std::size_t>(path.nodes[k + 1])].start);
    const double ratio = path.bones[k] > 0.0 ? std::abs(path.start_depth[k]) / path.bones[k] : 0.0;
    bones.push_back({path.bones[k] * problem.magnification(middle), ratio});
  }
}

void lay_on_chords(const LineProblem& problem, std::span<const std::vector<int>> depth_sign, LineState& state) {
  state.shift.setZero();
  for (Quat& turn : state.turn) turn.setIdentity();
  problem.update(state);
  for (std::size_t index = 0; index < problem.paths.size(); ++index) {
    const LinePath& path = problem.paths[index];
    const std::vector<double>& along = state.along[index];
    const auto sign = [&](std::size_t k) { return depth_sign.empty() ? 0 : depth_sign[index][k]; };
    const auto top =
        static_cast<std::size_t>(std::min_element(path.nodes.begin(), path.nodes.end()) - path.nodes.begin());
    const auto position = [&](std::size_t k) { return state.position[static_cast<std::size_t>(path.nodes[k])]; };
    if (problem.moves && index == 0) {
      const Vec3 x = position(top);
      const Vec2 wanted = path.curve.at(along[top]) / problem.magnification(x);
      state.shift.head<2>() += wanted - x.head<2>();
      problem.update(state);
    }
    // The topmost joint carries both sides: the way through it turns to the way through its two chords.
    if (top > 0 && top + 1 < path.nodes.size()) {
      const Vec3 wanted = wanted_bone(problem, path, along, state, top - 1, sign(top - 1)) +
                          wanted_bone(problem, path, along, state, top, sign(top));
      turn_node(problem, state, path.nodes[top], rotation_between(position(top + 1) - position(top - 1), wanted));
    } else if (top == 0) {
      turn_node(problem, state, path.nodes[0],
                rotation_between(position(1) - position(0), wanted_bone(problem, path, along, state, 0, sign(0))));
    } else {
      turn_node(problem, state, path.nodes[top],
                rotation_between(position(top) - position(top - 1),
                                 wanted_bone(problem, path, along, state, top - 1, sign(top - 1))));
    }
    for (std::size_t k = top + 1; k + 1 < path.nodes.size(); ++k) {
      turn_node(problem, state, path.nodes[k],
                rotation_between(position(k + 1) - position(k), wanted_bone(problem, path, along, state, k, sign(k))));
    }
    for (std::size_t k = top; k-- > 1;) {
      turn_node(problem, state, path.nodes[k],
                rotation_between(position(k) - position(k - 1),
                                 wanted_bone(problem, path, along, state, k - 1, sign(k - 1))));
    }
  }
}

void bend_pinned_hinges(const LineProblem& problem, LineState& state, double bend) {
  if (problem.pins.empty()) return;
  for (std::size_t i = 0; i < problem.limits.size(); ++i) {
    const LineLimit& limit = problem.limits[i];
    if (!limit.limit.hinge) continue;
    const bool on_path = std::any_of(problem.paths.begin(), problem.paths.end(), [&](const LinePath& path) {
      return std::find(path.nodes.begin(), path.nodes.end(), limit.node) != path.nodes.end();
    });
    if (on_path) continue;
    const double room = limit.limit.swing_max.x() > -limit.limit.swing_min.x() ? bend : -bend;
    const Quat bent = rotation_from_vector(Vec3(room, 0, 0));
    const Quat local = limit.start_local * (limit.limit.frame * bent * limit.limit.frame.conjugate());
    const Mat3 turn = (local * limit.start_local.conjugate()).normalized().toRotationMatrix();
    state.turn[static_cast<std::size_t>(limit.node)] = Quat(Mat3(limit.above * turn * limit.above.transpose()));
  }
  problem.update(state);
}

}  // namespace croquis
