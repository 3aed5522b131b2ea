// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "croquis/math/camera.h"
#include "croquis/posing/body_points.h"
#include "croquis/posing/stroke_curve.h"
#include "croquis/rig/joint_limits.h"

namespace croquis {

/// The weights of the line solver's energy; lengths are measured in lengths of the (longest) body line, angles in
/// radians. docs/algorithms/line_of_action.md gives the formulae.
struct LineWeights {
  double position = 1.0;       ///< joints to their points of the stroke
  double chord = 1e-3;         ///< each bone to its chord of the stroke: direction, sense and foreshortening
  double inner = 0.7;          ///< points inside a bone to the stroke between its joints
  double depth = 4e-4;         ///< change of a bone's depth, per its length
  double turn = 1.6e-3;        ///< turning a joint at all; joints differ by LineNode::stiffness
  double share = 4e-4;         ///< difference of bend between neighbours of one group, per length
  double shift = 4e-6;         ///< moving the root in the picture
  double shift_depth = 0.025;  ///< moving the root toward the camera or away
  double slide = 0.02;         ///< without a held end: joints to where their bones reach along the stroke
  double pin = 1e5;            ///< held joints
  double pin_turn = 1e3;       ///< joints held in a direction
  double floor = 1e4;          ///< what is below the floor
  double overlap = 4.0;        ///< limbs inside each other
  double balance = 1.0;        ///< the middle of the mass beside its support
};

/// A joint of the part of the tree that a line concerns, in view space and problem units.
struct LineNode {
  int joint = -1;
  int parent = -1;                    ///< node; -1 for the first
  Vec3 start = Vec3::Zero();          ///< position in the start pose
  Vec3 offset = Vec3::Zero();         ///< start - start of the parent
  int column = -1;                    ///< of its three unknowns; -1: does not turn
  Mat3 stiffness = Mat3::Identity();  ///< residual of turning by r is sqrt(turn) * stiffness * r
};

/// A body line and its stroke.
struct LinePath {
  std::vector<int> nodes;
  StrokeCurve curve;
  std::vector<double> bones;                 ///< length of each
  std::vector<double> start_depth;           ///< z of each bone's vector in the start pose
  std::vector<double> importance;            ///< per joint
  std::vector<double> slide_to;              ///< without a held end: arc lengths that `slide` pulls to, may lie beyond
  bool hold_first = true, hold_last = true;  ///< the line's ends land on the stroke's ends
  bool fixed = false;                        ///< joints stay at the arc lengths of the state
  int column = -1;                           ///< of the arc lengths of all joints (those of held ends have no effect)
};

/// A joint held in place.
struct LinePin {
  int node = -1;
  Vec3 target = Vec3::Zero();
  std::optional<Mat3> frame = {};  ///< rotation since the start pose, view axes
  double hold = 1.0;               ///< factor on the weights of pins
};

/// What a joint may do: its limit, and what turns of its node mean to it,
///     local rotation = above' E above * start_local.
struct LineLimit {
  int node = -1;
  Mat3 above = Mat3::Identity();  ///< orthogonal: view axes from the joint's parent, in the start pose
  Quat start_local = Quat::Identity();
  JointLimit limit;
};

/// Two neighbours along a path that share a bend in proportion to their lengths.
struct SharedBend {
  int a = -1, b = -1;  ///< nodes
  double length_a = 1.0, length_b = 1.0;
};

/// Where a problem stands: the unknowns, and what follows from them.
struct LineState {
  Vec3 shift = Vec3::Zero();               ///< of the whole body
  std::vector<Quat> turn;                  ///< per node: its turn relative to the parent, in start-pose view axes
  std::vector<std::vector<double>> along;  ///< per path and joint: arc length on its stroke
  std::vector<Mat3> frame;                 ///< per node: rotation since the start pose, product of the turns above
  std::vector<Vec3> position;
};

/// Room for the quadratic model of one state; sized once, so that solving again allocates nothing.
struct LineModel {
  double energy = 0.0;
  Eigen::MatrixXd normal;    ///< J'J, lower triangle
  bool exact = false;        ///< `circling` is wanted
  Eigen::MatrixXd circling;  ///< what J'J leaves out because turned points go in circles, lower triangle; indefinite
  Eigen::VectorXd gradient;  ///< J'r

  // Inside a path residuals depend on neighbouring joints' y = (picture x, picture y, depth, arc length) alone.
  Eigen::MatrixXd points;             ///< unknowns x 3 per joint: d(picture x, picture y, depth)/du
  Eigen::MatrixXd weighted;           ///< the same, times the path's own normal matrix
  std::vector<Eigen::Matrix4d> own;   ///< that matrix: each joint with itself ...
  std::vector<Eigen::Matrix4d> next;  ///< ... and with the joint after it
  std::vector<Vec4> slope;            ///< gradient by y

  Eigen::VectorXd row;       ///< of one residual that points of the body take part in
  std::vector<Mat3> pulled;  ///< per node: sum over the points below it of a g' - (a . g) I, a the point seen from it
};

/// The problem that the line solver solves, free of skeletons and files: a rigid tree in view space (x right, y up, z
/// toward the viewer), turned at its joints so that projected paths lie on curves,
///     x_i = x_p + G_p d_i,   G_i = G_p E_i,   E_i = exp(r_i),
/// minimise 1/2 |residuals|^2. Turns are relative to the start pose, so bone rolls and local axes do not enter.
class LineProblem {
 public:
  std::vector<LineNode> nodes;  ///< parents first
  std::vector<LinePath> paths;
  std::vector<LinePin> pins;
  std::vector<SharedBend> shares;
  std::vector<LineLimit> limits;
  BodyPoints body;
  LineWeights weights;
  bool perspective = false;
  double distance = 1.0;  ///< perspective: pictures are measured at this distance from the camera
  bool moves = false;     ///< the body may shift

  /// To be called when the lists above are complete: numbers the unknowns.
  void finish();
  [[nodiscard]] int unknowns() const { return unknowns_; }
  [[nodiscard]] LineState start_state() const;

  /// Positions and frames from shift and turns.
  void update(LineState& state) const;
  /// The picture position of a point; bounded behind the camera.
  [[nodiscard]] Vec2 project(const Vec3& x) const;
  /// How many times larger the picture shows what is at x.
  [[nodiscard]] double magnification(const Vec3& x) const;
  [[nodiscard]] Vec3 place(const LineState& state, const BodyPoint& point) const {
    const auto at = static_cast<std::size_t>(point.node);
    return state.position[at] + state.frame[at] * point.offset;
  }
  /// The deepest that a pair of the body's capsules passes into each other.
  [[nodiscard]] double overlap(const LineState& state) const;
  /// Sizes a model for this problem.
  void prepare(LineModel& model) const;
  [[nodiscard]] double energy(const LineState& state) const;
  /// The part of it that pins, floor, balance and overlap have.
  [[nodiscard]] double bodily_energy(const LineState& state) const;
  /// Energy, gradient and matrices at a state, into a prepared model.
  void linearise(const LineState& state, LineModel& model) const;
  /// The residuals one by one with all their slopes (residuals x unknowns), for checks.
  void list_residuals(const LineState& state, Eigen::VectorXd& residuals, Eigen::MatrixXd* jacobian) const;
  /// state (+) step: turns by exp(v) E, arc lengths kept in order and on the stroke.
  void advance(const LineState& from, const Eigen::VectorXd& step, LineState& to) const;

 private:
  [[nodiscard]] Mat3 seen_slope(const Vec3& x) const;
  void position_columns(const LineState& state, int node, Eigen::MatrixXd& out) const;
  void turn_columns(const LineState& state, int node, const Mat3& slope, Eigen::MatrixXd& out) const;
  void add_point(const LineState& state, const BodyPoint& point, const Vec3& slope, Eigen::VectorXd& row) const;
  void point_columns(const LineState& state, int node, Eigen::MatrixXd& out, int column) const;
  template <class Sink>
  void visit_path(const LineState& state, std::size_t index, Sink& sink) const;
  template <class Sink>
  void visit_turns(const LineState& state, Sink& sink) const;
  template <class Sink>
  void visit_pins(const LineState& state, Sink& sink) const;
  template <class Sink>
  void visit_body(const LineState& state, Sink& sink) const;
  template <class Sink>
  void visit_balance(const LineState& state, Sink& sink) const;
  void add_path(const LineState& state, std::size_t index, LineModel& model) const;
  void pull(const LineState& state, int node, const Vec3& x, const Vec3& slope, LineModel& model) const;
  void add_circling(const LineState& state, LineModel& model) const;
  struct EnergySink;
  struct ModelSink;
  struct RowSink;
  int unknowns_ = 0;
};

/// d log(exp(v) exp(r)) / dv at v = 0.
[[nodiscard]] Mat3 left_jacobian_inverse(const Vec3& r);

}  // namespace croquis
