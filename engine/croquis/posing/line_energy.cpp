// SPDX-License-Identifier: MIT
// The terms are written once, in visit_path, visit_turns and visit_body, and read by three sinks: one sums the energy,
// one builds the normal equations, one lists every row for the derivative check. A path's residuals touch only
// neighbouring joints, so its normal matrix in picture coordinates is block-tridiagonal and the chain rule is applied
// once to that, instead of to every row: a third of the work of J'J.
#include <algorithm>
#include <cmath>

#include "croquis/math/rotation.h"
#include "croquis/posing/body_shape.h"
#include "croquis/posing/line_problem.h"

namespace croquis {
namespace {

constexpr int kInner = 3;           // points inside each bone
constexpr double kShortest = 0.02;  // chords of shorter bones are measured as if they had this length

}  // namespace

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
    const Vec2 dc1 = first || last || path.fixed ? Vec2(Vec2::Zero()) : path.curve.derivative(s1);
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
      const bool before_held = (k == 1 && path.hold_first) || path.fixed, held = last || path.fixed;
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
          b[3] = held ? 0.0 : -wi * t * dc[axis];
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
}

template <class Sink>
void LineProblem::visit_pins(const LineState& state, Sink& sink) const {
  for (const LinePin& pin : pins) {
    const double wp = std::sqrt(weights.pin * pin.hold);
    sink.place(wp, pin.node, wp * (state.position[static_cast<std::size_t>(pin.node)] - pin.target));
    if (!pin.frame) continue;
    const Mat3 off = state.frame[static_cast<std::size_t>(pin.node)] * pin.frame->transpose();
    const Vec3 r = rotation_to_vector(Quat(off));
    const double wt = std::sqrt(weights.pin_turn * pin.hold);
    sink.turn(wt * r, pin.node, wt * left_jacobian_inverse(r));
  }
}

/// The terms of the body around the lines. sink.begin(r), then a sink.slope(point, dr/dpoint) for each point that the
/// residual depends on, then sink.end();
/// sink.idle() for a residual that is zero all around.
template <class Sink>
void LineProblem::visit_body(const LineState& state, Sink& sink) const {
  const double wf = std::sqrt(weights.floor), wo = std::sqrt(weights.overlap);
  for (const BodyPoints::FloorPoint& point : body.floor) {
    const double above = body.up.dot(place(state, point.at)) - point.height;
    if (above >= 0.0) {
      sink.idle();
      continue;
    }
    sink.begin(wf * above);
    sink.slope(point.at, wf * body.up);
    sink.end();
  }
  for (const BodyPoints::Pair& pair : body.pairs) {
    const auto& a = body.capsules[static_cast<std::size_t>(pair.a)];
    const auto& b = body.capsules[static_cast<std::size_t>(pair.b)];
    const Vec3 a0 = place(state, a.from), a1 = place(state, a.to), b0 = place(state, b.from), b1 = place(state, b.to);
    const double far = (a1 - a0).norm() + (b1 - b0).norm() + 2.0 * pair.apart;
    const bool reaches = (a0 + a1 - b0 - b1).squaredNorm() < far * far;
    const NearestPoints near = reaches ? nearest_points(a0, a1, b0, b1) : NearestPoints{0.0, 0.0, far};
    if (near.distance >= pair.apart || near.distance < 1e-9) {
      sink.idle();
      continue;
    }
    // The nearest points move along their bones too, but that changes the distance by nothing.
    const Vec3 toward = wo * ((1 - near.s) * a0 + near.s * a1 - (1 - near.t) * b0 - near.t * b1) / near.distance;
    sink.begin(wo * (near.distance - pair.apart));
    sink.slope(a.from, (1 - near.s) * toward);
    sink.slope(a.to, near.s * toward);
    sink.slope(b.from, (near.t - 1) * toward);
    sink.slope(b.to, -near.t * toward);
    sink.end();
  }
  if (!body.support.empty()) visit_balance(state, sink);
}

template <class Sink>
void LineProblem::visit_balance(const LineState& state, Sink& sink) const {
  Vec3 middle = Vec3::Zero();
  for (const BodyPoints::Mass& mass : body.masses) middle += mass.part * place(state, mass.at);
  const auto level = [&](const Vec3& x) { return Vec3(x - body.up.dot(x) * body.up); };
  const Vec3 c = level(middle), a = level(place(state, body.support.front())),
             b = level(place(state, body.support.back()));
  const double span = (b - a).squaredNorm();
  const double t = span > 1e-12 ? std::clamp((c - a).dot(b - a) / span, 0.0, 1.0) : 0.0;
  const Vec3 off = c - (1 - t) * a - t * b;
  const double beside = off.norm();
  if (beside <= body.support_radius) return sink.idle();
  const double w = std::sqrt(weights.balance);
  const Vec3 slope = w * off / beside;
  sink.begin(w * (beside - body.support_radius));
  for (const BodyPoints::Mass& mass : body.masses) sink.slope(mass.at, mass.part * slope);
  sink.slope(body.support.front(), (t - 1) * slope);
  sink.slope(body.support.back(), -t * slope);
  sink.end();
}

struct LineProblem::EnergySink {
  double sum = 0.0;
  void row(double r, int, const Vec4&, const Vec4&) { sum += r * r; }
  void block(const Vec3& r, int, const Mat3&, int, const Mat3&) { sum += r.squaredNorm(); }
  void place(double, int, const Vec3& r) { sum += r.squaredNorm(); }
  void turn(const Vec3& r, int, const Mat3&) { sum += r.squaredNorm(); }
  void begin(double r) { sum += r * r; }
  void slope(const BodyPoint&, const Vec3&) {}
  void end() {}
  void idle() {}
};

double LineProblem::energy(const LineState& state) const {
  EnergySink sink;
  for (std::size_t i = 0; i < paths.size(); ++i) visit_path(state, i, sink);
  visit_turns(state, sink);
  visit_pins(state, sink);
  visit_body(state, sink);
  return 0.5 * sink.sum;
}

double LineProblem::bodily_energy(const LineState& state) const {
  EnergySink sink;
  visit_pins(state, sink);
  visit_body(state, sink);
  return 0.5 * sink.sum;
}

struct LineProblem::ModelSink {
  const LineProblem& problem;
  const LineState& state;
  LineModel& model;
  double sum = 0.0, residual = 0.0;

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
    problem.position_columns(state, node, model.points);
    model.points.leftCols<3>() *= w;
    add_columns(r);
    const auto at = static_cast<std::size_t>(node);
    problem.pull(state, problem.nodes[at].parent, state.position[at], w * r, model);
  }
  void turn(const Vec3& r, int node, const Mat3& slope) {
    sum += r.squaredNorm();
    problem.turn_columns(state, node, slope, model.points);
    add_columns(r);
  }
  void begin(double r) {
    sum += r * r;
    residual = r;
    model.row.setZero();
  }
  void slope(const BodyPoint& point, const Vec3& by) {
    problem.add_point(state, point, by, model.row);
    problem.pull(state, point.node, problem.place(state, point), residual * by, model);
  }
  void end() {
    model.normal.selfadjointView<Eigen::Lower>().rankUpdate(model.row);
    model.gradient += residual * model.row;
  }
  void idle() {}
  void add_columns(const Vec3& r) {
    model.normal.triangularView<Eigen::Lower>() += model.points.leftCols<3>() * model.points.leftCols<3>().transpose();
    model.gradient.noalias() += model.points.leftCols<3>() * r;
  }
};

void LineProblem::linearise(const LineState& state, LineModel& model) const {
  model.normal.setZero();
  model.gradient.setZero();
  if (model.exact) std::fill(model.pulled.begin(), model.pulled.end(), Mat3::Zero());
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
  visit_pins(state, sink);
  visit_body(state, sink);
  if (model.exact) add_circling(state, model);
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
    const auto node = static_cast<std::size_t>(path.nodes[at]);
    const Vec3 by_place = seen_slope(state.position[node]).transpose() * model.slope[at].head<3>();
    pull(state, nodes[node].parent, state.position[node], by_place, model);
  }
  model.normal.topLeftCorner(bodily, bodily).triangularView<Eigen::Lower>() +=
      model.points.topLeftCorner(bodily, 3 * joints) * model.weighted.topLeftCorner(bodily, 3 * joints).transpose();
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
  void turn(const Vec3& r, int node, const Mat3& slope) {
    problem.turn_columns(state, node, slope, points);
    for (int i = 0; i < 3; ++i) {
      residuals.push_back(r[i]);
      slopes.emplace_back(points.col(i));
    }
  }
  void begin(double r) {
    residuals.push_back(r);
    slopes.emplace_back(Eigen::VectorXd::Zero(problem.unknowns()));
  }
  void slope(const BodyPoint& point, const Vec3& by) { problem.add_point(state, point, by, slopes.back()); }
  void end() {}
  void idle() { begin(0.0); }
};

void LineProblem::list_residuals(const LineState& state, Eigen::VectorXd& residuals, Eigen::MatrixXd* jacobian) const {
  RowSink sink{*this, state};
  sink.points.setZero(unknowns_, 3);
  for (; sink.path < paths.size(); ++sink.path) visit_path(state, sink.path, sink);
  visit_turns(state, sink);
  visit_pins(state, sink);
  visit_body(state, sink);
  const auto count = static_cast<Eigen::Index>(sink.residuals.size());
  residuals = Eigen::Map<const Eigen::VectorXd>(sink.residuals.data(), count);
  if (!jacobian) return;
  jacobian->resize(count, unknowns_);
  for (Eigen::Index i = 0; i < count; ++i) jacobian->row(i) = sink.slopes[static_cast<std::size_t>(i)].transpose();
}

}  // namespace croquis
