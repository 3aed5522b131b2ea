// SPDX-License-Identifier: MIT
// The terms are written once, in visit_path and visit_turns, and read by three sinks: one sums the energy, one builds
// the normal equations, one lists every row for the derivative check. A path's residuals touch only neighbouring
// joints, so its normal matrix in picture coordinates is block-tridiagonal and the chain rule is applied once to that,
// instead of to every row: a third of the work of J'J.
#include "croquis/posing/line_problem.h"

#include <algorithm>
#include <cmath>

#include "croquis/math/rotation.h"

namespace croquis {
namespace {

constexpr int kInner = 3;           // points inside each bone
constexpr double kShortest = 0.02;  // chords of shorter bones are measured as if they had this length
constexpr double kNearest = 0.05;   // of the distance: nothing comes nearer to a perspective camera

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

/// The terms of a path. sink.row(r, k, a, b): a residual with slopes a by joint k's y and b by joint k + 1's.
template <class Sink>
void LineProblem::visit_path(const LineState& state, std::size_t index, Sink& sink) const {
  const LinePath& path = paths[index];
  const int joints = static_cast<int>(path.nodes.size());
  const double end = path.curve.length();
  const double slide = path.hold_last ? 0.0 : std::sqrt(weights.slide);
  Vec2 p0 = Vec2::Zero(), c0 = Vec2::Zero(), dc0 = Vec2::Zero();
  double s0 = 0.0, z0 = 0.0;
  for (int k = 0; k < joints; ++k) {
    const auto at = static_cast<std::size_t>(k);
    // A held end lies on the stroke's end: its arc length is no unknown, its slope zero.
    const bool first = k == 0 && path.hold_first, last = k + 1 == joints && path.hold_last;
    const double s1 = first ? 0.0 : (last ? end : state.along[index][at]);
    const Vec3& x = state.position[static_cast<std::size_t>(path.nodes[at])];
    const Vec2 p1 = project(x), c1 = path.curve.at(s1);
    const Vec2 dc1 = first || last ? Vec2(Vec2::Zero()) : path.curve.derivative(s1);
    const double w = std::sqrt(weights.position * path.importance[at]);
    for (int axis = 0; axis < 2; ++axis) {
      Vec4 own = Vec4::Zero();
      own[axis] = w;
      own[3] = -w * dc1[axis];
      sink.row(w * (p1[axis] - c1[axis]), k, own, Vec4::Zero());
    }
    if (k > 0) {
      const double length = std::max(path.bones[at - 1], kShortest);
      const double importance = std::sqrt(0.5 * (path.importance[at - 1] + path.importance[at]));
      const double wc = importance * std::sqrt(weights.chord) / length;
      const double wd = std::sqrt(weights.depth) / length;
      for (int axis = 0; axis < 2; ++axis) {
        Vec4 a = Vec4::Zero(), b = Vec4::Zero();
        a[axis] = -wc;
        a[3] = wc * dc0[axis];
        b[axis] = wc;
        b[3] = -wc * dc1[axis];
        sink.row(wc * ((p1[axis] - p0[axis]) - (c1[axis] - c0[axis])), k - 1, a, b);
      }
      sink.row(wd * (x.z() - z0 - path.start_depth[at - 1]), k - 1, Vec4(0, 0, -wd, 0), Vec4(0, 0, wd, 0));
      const bool before_held = k == 1 && path.hold_first;
      if (slide > 0.0) {
        const double wanted = path.slide_to[at] - path.slide_to[at - 1];
        sink.row(slide * (s1 - s0 - wanted), k - 1, Vec4(0, 0, 0, before_held ? 0.0 : -slide), Vec4(0, 0, 0, slide));
      }
      const double wi = importance * std::sqrt(weights.inner / kInner);
      for (int i = 1; i <= kInner; ++i) {
        const double t = static_cast<double>(i) / (kInner + 1), s = s0 + t * (s1 - s0);
        const Vec2 c = path.curve.at(s), dc = path.curve.derivative(s);
        for (int axis = 0; axis < 2; ++axis) {
          Vec4 a = Vec4::Zero(), b = Vec4::Zero();
          a[axis] = wi * (1 - t);
          a[3] = before_held ? 0.0 : -wi * (1 - t) * dc[axis];
          b[axis] = wi * t;
          b[3] = last ? 0.0 : -wi * t * dc[axis];
          sink.row(wi * ((1 - t) * p0[axis] + t * p1[axis] - c[axis]), k - 1, a, b);
        }
      }
    }
    p0 = p1;
    c0 = c1;
    dc0 = dc1;
    s0 = s1;
    z0 = x.z();
  }
}

/// The terms that are not of paths. sink.block(r, column a, A, column b, B): three residuals and their slopes;
/// sink.place(w, node, residual): a residual w * (position of node - something).
template <class Sink>
void LineProblem::visit_turns(const LineState& state, Sink& sink) const {
  if (moves) {
    const Vec3 w(std::sqrt(weights.shift), std::sqrt(weights.shift), std::sqrt(weights.shift_depth));
    sink.block(state.shift.cwiseProduct(w), 0, w.asDiagonal(), -1, Mat3::Zero());
  }
  const double w = std::sqrt(weights.turn), ws = std::sqrt(weights.share);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i].column < 0) continue;
    const Vec3 r = rotation_to_vector(state.turn[i]);
    sink.block(w * (nodes[i].stiffness * r), nodes[i].column, w * nodes[i].stiffness * left_jacobian_inverse(r), -1,
               Mat3::Zero());
  }
  for (const SharedBend& share : shares) {
    const auto a = static_cast<std::size_t>(share.a), b = static_cast<std::size_t>(share.b);
    const Vec3 ra = rotation_to_vector(state.turn[a]), rb = rotation_to_vector(state.turn[b]);
    const double wa = ws / share.length_a, wb = ws / share.length_b;
    sink.block(wa * ra - wb * rb, nodes[a].column, wa * left_jacobian_inverse(ra), nodes[b].column,
               -wb * left_jacobian_inverse(rb));
  }
  for (const LinePin& pin : pins) {
    const double wp = std::sqrt(weights.pin);
    sink.place(wp, pin.node, wp * (state.position[static_cast<std::size_t>(pin.node)] - pin.target));
  }
}

struct LineProblem::EnergySink {
  double sum = 0.0;
  void row(double r, int, const Vec4&, const Vec4&) { sum += r * r; }
  void block(const Vec3& r, int, const Mat3&, int, const Mat3&) { sum += r.squaredNorm(); }
  void place(double, int, const Vec3& r) { sum += r.squaredNorm(); }
};

double LineProblem::energy(const LineState& state) const {
  EnergySink sink;
  for (std::size_t i = 0; i < paths.size(); ++i) visit_path(state, i, sink);
  visit_turns(state, sink);
  return 0.5 * sink.sum;
}

struct LineProblem::ModelSink {
  const LineProblem& problem;
  const LineState& state;
  LineModel& model;
  double sum = 0.0;

  void row(double r, int k, const Vec4& a, const Vec4& b) {
    sum += r * r;
    const auto at = static_cast<std::size_t>(k);
    model.own[at].noalias() += a * a.transpose();
    model.own[at + 1].noalias() += b * b.transpose();
    model.next[at].noalias() += a * b.transpose();
    model.slope[at] += r * a;
    model.slope[at + 1] += r * b;
  }
  void block(const Vec3& r, int column_a, const Mat3& a, int column_b, const Mat3& b) {
    sum += r.squaredNorm();
    for (const auto& [column, slope] : {std::pair(column_a, &a), std::pair(column_b, &b)}) {
      if (column < 0) continue;
      model.normal.block<3, 3>(column, column).noalias() += slope->transpose() * *slope;
      model.gradient.segment<3>(column).noalias() += slope->transpose() * r;
    }
    if (column_a < 0 || column_b < 0) return;
    if (column_a > column_b) {
      model.normal.block<3, 3>(column_a, column_b).noalias() += a.transpose() * b;
    } else {
      model.normal.block<3, 3>(column_b, column_a).noalias() += b.transpose() * a;
    }
  }
  void place(double w, int node, const Vec3& r) {
    sum += r.squaredNorm();
    model.points.leftCols<3>().setZero();
    problem.position_columns(state, node, model.points);
    model.points.leftCols<3>() *= w;
    model.normal.triangularView<Eigen::Lower>() += model.points.leftCols<3>() * model.points.leftCols<3>().transpose();
    model.gradient.noalias() += model.points.leftCols<3>() * r;
  }
};

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
}

void LineProblem::linearise(const LineState& state, LineModel& model) const {
  model.normal.setZero();
  model.gradient.setZero();
  ModelSink sink{*this, state, model};
  for (std::size_t i = 0; i < paths.size(); ++i) {
    for (std::size_t k = 0; k <= paths[i].nodes.size(); ++k) {
      model.own[k].setZero();
      model.next[k].setZero();
      model.slope[k].setZero();
    }
    visit_path(state, i, sink);
    add_path(state, i, model);
  }
  visit_turns(state, sink);
  model.energy = 0.5 * sink.sum;
}

/// The chain rule from a path's picture coordinates to the unknowns.
void LineProblem::add_path(const LineState& state, std::size_t index, LineModel& model) const {
  const LinePath& path = paths[index];
  const int joints = static_cast<int>(path.nodes.size());
  const int bodily = paths.front().column;  // unknowns before it move the body, those from it on slide along strokes
  for (int k = 0; k < joints; ++k) point_columns(state, path.nodes[static_cast<std::size_t>(k)], model.points, 3 * k);
  const auto points = [&](int k) { return model.points.block(0, 3 * k, bodily, 3); };
  for (int k = 0; k < joints; ++k) {
    const auto at = static_cast<std::size_t>(k);
    auto weighted = model.weighted.block(0, 3 * k, bodily, 3);
    auto slid = model.normal.row(path.column + k).head(bodily);
    weighted.noalias() = points(k) * model.own[at].topLeftCorner<3, 3>();
    slid.noalias() += model.own[at].row(3).head<3>() * points(k).transpose();
    if (k > 0) {
      weighted.noalias() += points(k - 1) * model.next[at - 1].topLeftCorner<3, 3>();
      slid.noalias() += model.next[at - 1].col(3).head<3>().transpose() * points(k - 1).transpose();
    }
    if (k + 1 < joints) {
      weighted.noalias() += points(k + 1) * model.next[at].topLeftCorner<3, 3>().transpose();
      slid.noalias() += model.next[at].row(3).head<3>() * points(k + 1).transpose();
      model.normal(path.column + k + 1, path.column + k) += model.next[at](3, 3);
    }
    model.normal(path.column + k, path.column + k) += model.own[at](3, 3);
    model.gradient.head(bodily).noalias() += points(k) * model.slope[at].head<3>();
    model.gradient[path.column + k] += model.slope[at][3];
  }
  model.normal.topLeftCorner(bodily, bodily).triangularView<Eigen::Lower>() +=
      model.points.topLeftCorner(bodily, 3 * joints) * model.weighted.topLeftCorner(bodily, 3 * joints).transpose();
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

struct LineProblem::RowSink {
  const LineProblem& problem;
  const LineState& state;
  std::vector<double> residuals = {};
  std::vector<Eigen::VectorXd> slopes = {};
  std::size_t path = 0;
  Eigen::MatrixXd points = {};

  void row(double r, int k, const Vec4& a, const Vec4& b) {
    Eigen::VectorXd slope = Eigen::VectorXd::Zero(problem.unknowns());
    const LinePath& line = problem.paths[path];
    for (const auto& [joint, part] : {std::pair(k, &a), std::pair(k + 1, &b)}) {
      if (joint >= std::ssize(line.nodes)) continue;
      problem.point_columns(state, line.nodes[static_cast<std::size_t>(joint)], points, 0);
      slope += points * part->head<3>();
      slope[line.column + joint] += (*part)[3];
    }
    residuals.push_back(r);
    slopes.push_back(slope);
  }
  void block(const Vec3& r, int column_a, const Mat3& a, int column_b, const Mat3& b) {
    for (int i = 0; i < 3; ++i) {
      Eigen::VectorXd slope = Eigen::VectorXd::Zero(problem.unknowns());
      if (column_a >= 0) slope.segment<3>(column_a) += a.row(i);
      if (column_b >= 0) slope.segment<3>(column_b) += b.row(i);
      residuals.push_back(r[i]);
      slopes.push_back(slope);
    }
  }
  void place(double w, int node, const Vec3& r) {
    problem.position_columns(state, node, points);
    for (int i = 0; i < 3; ++i) {
      residuals.push_back(r[i]);
      slopes.emplace_back(w * points.col(i));
    }
  }
};

void LineProblem::list_residuals(const LineState& state, Eigen::VectorXd& residuals, Eigen::MatrixXd* jacobian) const {
  RowSink sink{*this, state};
  sink.points.setZero(unknowns_, 3);
  for (; sink.path < paths.size(); ++sink.path) visit_path(state, sink.path, sink);
  visit_turns(state, sink);
  const auto count = static_cast<Eigen::Index>(sink.residuals.size());
  residuals = Eigen::Map<const Eigen::VectorXd>(sink.residuals.data(), count);
  if (!jacobian) return;
  jacobian->resize(count, unknowns_);
  for (Eigen::Index i = 0; i < count; ++i) jacobian->row(i) = sink.slopes[static_cast<std::size_t>(i)].transpose();
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
