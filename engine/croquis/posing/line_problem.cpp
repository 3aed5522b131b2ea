// SPDX-License-Identifier: MIT
#include "croquis/posing/line_problem.h"

#include <algorithm>
#include <cmath>

#include "croquis/math/rotation.h"
#include "croquis/posing/body_shape.h"

namespace croquis {
namespace {

constexpr double kNearest = 0.05;  // of the distance: nothing comes nearer to a perspective camera

Mat3 cross_matrix(const Vec3& v) {
  Mat3 m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

}  // namespace

Mat3 left_jacobian_inverse(const Vec3& r) {
  const double angle = r.norm(), half = 0.5 * angle;
  const double c = angle < 1e-4 ? 1.0 / 12.0 + angle * angle / 720.0
                                : (1.0 - half * std::cos(half) / std::sin(half)) / (angle * angle);
  const Mat3 k = cross_matrix(r);
  return Mat3::Identity() - 0.5 * k + c * k * k;
}

void LineProblem::finish() {
  int column = moves ? 3 : 0;
  for (LineNode& node : nodes) {
    if (node.column < 0) continue;
    node.column = column;
    column += 3;
  }
  for (LinePath& path : paths) {
    path.column = column;
    column += static_cast<int>(path.nodes.size());
  }
  unknowns_ = column;
}

LineState LineProblem::start_state() const {
  LineState state;
  state.turn.assign(nodes.size(), Quat::Identity());
  state.frame.assign(nodes.size(), Mat3::Identity());
  state.position.assign(nodes.size(), Vec3::Zero());
  for (const LinePath& path : paths) {
    std::vector<double> along{0.0};
    for (const double bone : path.bones) along.push_back(along.back() + bone);
    const double total = along.back();
    for (double& s : along) s = total > 0.0 ? s / total * path.curve.length() : 0.0;
    state.along.push_back(path.hold_last ? along : path.slide_to);
  }
  update(state);
  return state;
}

void LineProblem::update(LineState& state) const {
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const LineNode& node = nodes[i];
    if (node.parent < 0) {
      state.position[i] = node.start + state.shift;
      state.frame[i] = state.turn[i].toRotationMatrix();
    } else {
      const auto p = static_cast<std::size_t>(node.parent);
      state.position[i] = state.position[p] + state.frame[p] * node.offset;
      if (node.column >= 0) {
        state.frame[i].noalias() = state.frame[p] * state.turn[i].toRotationMatrix();
      } else {
        state.frame[i] = state.frame[p];
      }
    }
  }
}

Vec2 LineProblem::project(const Vec3& x) const {
  if (!perspective) return x.head<2>();
  return x.head<2>() * magnification(x);
}

double LineProblem::magnification(const Vec3& x) const {
  return perspective ? distance / std::max(-x.z(), kNearest * distance) : 1.0;
}

/// d(picture x, picture y, depth)/dx.
Mat3 LineProblem::seen_slope(const Vec3& x) const {
  Mat3 slope = Mat3::Identity();
  if (!perspective) return slope;
  const double depth = std::max(-x.z(), kNearest * distance);
  const double scale = distance / depth;
  slope(0, 0) = slope(1, 1) = scale;
  if (-x.z() > kNearest * distance) slope.block<2, 1>(0, 2) = x.head<2>() * (scale / depth);
  return slope;
}

/// d(picture x, picture y, depth)/du of a node in three columns of `out`.
void LineProblem::point_columns(const LineState& state, int node, Eigen::MatrixXd& out, int column) const {
  const Vec3 x = state.position[static_cast<std::size_t>(node)];
  const Mat3 slope = seen_slope(x);
  out.middleCols<3>(column).setZero();
  if (moves) out.block<3, 3>(0, column) = slope.transpose();
  for (int i = nodes[static_cast<std::size_t>(node)].parent; i >= 0; i = nodes[static_cast<std::size_t>(i)].parent) {
    const LineNode& above = nodes[static_cast<std::size_t>(i)];
    if (above.column < 0) continue;
    // dx = (P v) x arm, P the frame that the turn is written in: dx . s = v . P'(arm x s).
    const Vec3 arm = x - state.position[static_cast<std::size_t>(i)];
    Mat3 turned;
    for (int axis = 0; axis < 3; ++axis) turned.col(axis) = arm.cross(Vec3(slope.row(axis)));
    if (above.parent >= 0) {
      out.block<3, 3>(above.column, column).noalias() =
          state.frame[static_cast<std::size_t>(above.parent)].transpose() * turned;
    } else {
      out.block<3, 3>(above.column, column) = turned;
    }
  }
}

void LineProblem::prepare(LineModel& model) const {
  std::size_t joints = 1;
  for (const LinePath& path : paths) joints = std::max(joints, path.nodes.size());
  model.normal.setZero(unknowns_, unknowns_);
  model.gradient.setZero(unknowns_);
  model.points.setZero(unknowns_, static_cast<Eigen::Index>(3 * joints));
  model.weighted = model.points;
  model.own.assign(joints + 1, Eigen::Matrix4d::Zero());
  model.next = model.own;
  model.slope.assign(joints + 1, Vec4::Zero());
  model.row.setZero(unknowns_);
  model.circling = model.normal;
  model.pulled.assign(nodes.size(), Mat3::Zero());
}

/// d position/du of a node in the first three columns of `out`.
void LineProblem::position_columns(const LineState& state, int node, Eigen::MatrixXd& out) const {
  out.leftCols<3>().setZero();
  if (moves) out.block<3, 3>(0, 0).setIdentity();
  const Vec3 x = state.position[static_cast<std::size_t>(node)];
  for (int i = nodes[static_cast<std::size_t>(node)].parent; i >= 0; i = nodes[static_cast<std::size_t>(i)].parent) {
    const LineNode& above = nodes[static_cast<std::size_t>(i)];
    if (above.column < 0) continue;
    Mat3 frame = Mat3::Identity();
    if (above.parent >= 0) frame = state.frame[static_cast<std::size_t>(above.parent)];
    const Mat3 arm = cross_matrix(x - state.position[static_cast<std::size_t>(i)]);
    out.block<3, 3>(above.column, 0) = -(arm * frame).transpose();
  }
}

/// The slopes of a residual with d residual/d(turn of the node) = slope, in three columns of `out`.
void LineProblem::turn_columns(const LineState& state, int node, const Mat3& slope, Eigen::MatrixXd& out) const {
  out.leftCols<3>().setZero();
  for (int i = node; i >= 0; i = nodes[static_cast<std::size_t>(i)].parent) {
    const LineNode& above = nodes[static_cast<std::size_t>(i)];
    if (above.column < 0) continue;
    Mat3 frame = Mat3::Identity();
    if (above.parent >= 0) frame = state.frame[static_cast<std::size_t>(above.parent)];
    out.block<3, 3>(above.column, 0) = (slope * frame).transpose();
  }
}

/// Adds slope . d point/du to a row.
void LineProblem::add_point(const LineState& state, const BodyPoint& point, const Vec3& slope,
                            Eigen::VectorXd& row) const {
  if (moves) row.head<3>() += slope;
  const Vec3 x = place(state, point);
  for (int i = point.node; i >= 0; i = nodes[static_cast<std::size_t>(i)].parent) {
    const LineNode& above = nodes[static_cast<std::size_t>(i)];
    if (above.column < 0) continue;
    const Vec3 turned = (x - state.position[static_cast<std::size_t>(i)]).cross(slope);
    if (above.parent >= 0) {
      row.segment<3>(above.column).noalias() +=
          state.frame[static_cast<std::size_t>(above.parent)].transpose() * turned;
    } else {
      row.segment<3>(above.column) += turned;
    }
  }
}

/// Notes that the energy changes by slope . dx when a point at x that `node` carries moves.
void LineProblem::pull(const LineState& state, int node, const Vec3& x, const Vec3& slope, LineModel& model) const {
  if (!model.exact) return;
  for (int i = node; i >= 0; i = nodes[static_cast<std::size_t>(i)].parent) {
    const auto at = static_cast<std::size_t>(i);
    if (nodes[at].column < 0) continue;
    const Vec3 arm = x - state.position[at];
    model.pulled[at].noalias() += arm * slope.transpose();
    model.pulled[at].diagonal().array() -= arm.dot(slope);
  }
}

/// Second derivatives by two turns: d2x/dw_i dw_j = w_i x (w_j x (x - x_j)) for i above j, or j itself (then
/// symmetric).
void LineProblem::add_circling(const LineState& state, LineModel& model) const {
  const auto frame_above = [&](std::size_t i) {
    return nodes[i].parent < 0 ? Mat3(Mat3::Identity()) : state.frame[static_cast<std::size_t>(nodes[i].parent)];
  };
  for (std::size_t j = 0; j < nodes.size(); ++j) {
    if (nodes[j].column < 0) continue;
    const Mat3& pulled = model.pulled[j];
    const Mat3 frame = frame_above(j);
    model.circling.block<3, 3>(nodes[j].column, nodes[j].column) =
        frame.transpose() * (0.5 * (pulled + pulled.transpose())) * frame;
    const Mat3 seen = pulled * frame;
    for (int i = nodes[j].parent; i >= 0; i = nodes[static_cast<std::size_t>(i)].parent) {
      const auto above = static_cast<std::size_t>(i);
      if (nodes[above].column < 0) continue;
      model.circling.block<3, 3>(nodes[j].column, nodes[above].column) =
          (frame_above(above).transpose() * seen).transpose();
    }
  }
}

double LineProblem::overlap(const LineState& state) const {
  double deepest = 0.0;
  for (const BodyPoints::Pair& pair : body.pairs) {
    const auto& a = body.capsules[static_cast<std::size_t>(pair.a)];
    const auto& b = body.capsules[static_cast<std::size_t>(pair.b)];
    const NearestPoints near =
        nearest_points(place(state, a.from), place(state, a.to), place(state, b.from), place(state, b.to));
    deepest = std::max(deepest, pair.apart - near.distance);
  }
  return deepest;
}

void LineProblem::advance(const LineState& from, const Eigen::VectorXd& step, LineState& to) const {
  to.shift = from.shift;
  if (moves) to.shift += step.head<3>();
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    to.turn[i] = from.turn[i];
    if (nodes[i].column < 0) continue;
    const Vec3 v = step.segment<3>(nodes[i].column);
    to.turn[i] = (rotation_from_vector(v) * from.turn[i]).normalized();
  }
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const LinePath& path = paths[i];
    std::vector<double>& along = to.along[i];
    if (path.fixed) {
      along = from.along[i];
      continue;
    }
    double end = path.curve.length();
    if (!path.hold_last) end = std::max(end, 1.2 * path.slide_to.back());
    double least = 0.0;
    for (std::size_t k = 0; k < along.size(); ++k) {
      along[k] = std::clamp(from.along[i][k] + step[path.column + static_cast<int>(k)], least, end);
      if (k == 0 && path.hold_first) along[k] = 0.0;
      if (k + 1 == along.size() && path.hold_last) along[k] = end;
      least = along[k];
    }
  }
  update(to);
}

}  // namespace croquis
