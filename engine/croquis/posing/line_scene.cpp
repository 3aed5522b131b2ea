// SPDX-License-Identifier: MIT
#include "croquis/posing/line_scene.h"

#include <algorithm>
#include <cmath>

#include <Eigen/SVD>

#include "croquis/base/error.h"
#include "croquis/base/text.h"
#include "croquis/posing/keep_lengths.h"
#include "croquis/posing/line_limits.h"
#include "croquis/posing/pose_edit.h"
#include "croquis/posing/turn_prior.h"

namespace croquis {
namespace {

/// How hard it is to turn a joint of each role, where no prior says more: across its bone, and about it.
struct Stiffness {
  double swing, twist;
};
Stiffness stiffness_of(JointRole role) {
  switch (role) {
    case JointRole::root:
      return {0.22, 0.45};
    case JointRole::spine:
      return {0.67, 0.9};
    case JointRole::collar:
      return {1.1, 1.4};
    case JointRole::ball:
      return {0.27, 0.45};
    case JointRole::hinge:
      return {0.27, 0.67};
    case JointRole::end:
    case JointRole::plain:
      return {1.0, 2.0};
  }
  return {1.0, 1.0};
}

// How many times stiffer a person's root is: people carry the body upright, lines bend it, they hardly tip it over.
constexpr double kUpright = 1.0 / 0.22;
constexpr double kRoll = 4.0;        // twist of the topmost joint of a line, in what is no humanoid
constexpr double kUsualTurn = 0.15;  // radians: the spread of a joint whose stiffness is 1

/// The orthogonal matrix (perhaps a mirroring) nearest to m.
Mat3 orthogonal_part(const Mat3& m) {
  const Eigen::JacobiSVD<Mat3> svd(m, Eigen::ComputeFullU | Eigen::ComputeFullV);
  return svd.matrixU() * svd.matrixV().transpose();
}

void check_weights(const char* what, const std::vector<double>& weights) {
  for (const double weight : weights) {
    if (weight >= 0.0 && std::isfinite(weight)) continue;
    throw_invalid_argument(std::string("line solver: ") + what + " is " + format_double(weight) + ", wanted 0 or more");
  }
}

void check_inputs(const Skeleton& skeleton, const Pose& start, const std::vector<LineInput>& inputs) {
  if (inputs.empty()) throw_invalid_argument("line solver: got no line, wanted at least one");
  if (std::ssize(start.local) != skeleton.joint_count()) {
    throw_invalid_argument("line solver: the skeleton has " + std::to_string(skeleton.joint_count()) +
                           " joints, the start pose " + std::to_string(start.local.size()));
  }
  for (std::size_t i = 0; i < start.local.size(); ++i) {
    if (!start.local[i].is_finite()) {
      throw_invalid_argument("line solver: the start pose is not finite at joint " +
                             printable(skeleton.reference(static_cast<int>(i))));
    }
  }
  for (const LineInput& input : inputs) {
    (void)segments_of_line(skeleton, input.line);  // throws unless it is a path
    if (!input.importance.empty() && input.importance.size() != input.line.joints.size()) {
      throw_invalid_argument("line solver: line \"" + printable(input.line.name) + "\" has " +
                             std::to_string(input.line.joints.size()) + " joints, but importance for " +
                             std::to_string(input.importance.size()));
    }
    if (!input.pressure.empty() && input.pressure.size() != input.stroke.points().size()) {
      throw_invalid_argument("line solver: the stroke of line \"" + printable(input.line.name) + "\" has " +
                             std::to_string(input.stroke.points().size()) + " points, but pressure for " +
                             std::to_string(input.pressure.size()));
    }
    check_weights("importance", input.importance);
    check_weights("pressure", input.pressure);
    check_weights("weight", {input.weight});
  }
}

/// How much each joint heeds its stroke: as asked for, as the pen pressed where the joint lies by the bones' lengths,
/// and as the line counts against others. (Pressure read where a joint slides to would draw joints to weak ink.)
std::vector<double> heed(const LineInput& input, const std::vector<double>& bones, bool reversed) {
  std::vector<double> result(bones.size() + 1, input.weight);
  double total = 0.0, along = 0.0;
  for (const double bone : bones) total += bone;
  for (std::size_t k = 0; k < result.size(); ++k) {
    if (!input.importance.empty()) result[k] *= input.importance[k];
    if (!input.pressure.empty()) {
      const double part = total > 0.0 ? along / total : 0.0;
      const double at = reversed ? 1.0 - part : part;
      const auto& arc = input.stroke.arc();
      const auto after = std::upper_bound(arc.begin(), arc.end(), at * input.stroke.length());
      const std::size_t i = std::min(static_cast<std::size_t>(after - arc.begin()), arc.size() - 1);
      result[k] *= input.pressure[i];
    }
    if (k < bones.size()) along += bones[k];
  }
  return result;
}

}  // namespace

LineScene::LineScene(const Skeleton& skeleton, const HumanoidMap& humanoid, const Pose& start,
                     const std::vector<LineInput>& inputs, const Camera& camera, const LineSolverOptions& options)
    : skeleton_(skeleton), start_(start), person_(humanoid.is_humanoid()), length_(options.length) {
  check_inputs(skeleton, start, inputs);
  camera.check();
  roles_ = compute_joint_roles(skeleton, humanoid);
  body_root_ = find_body_root(skeleton, humanoid);
  model_ = compute_model_transforms(skeleton, start);
  view_ = camera.view_from_world();

  Vec3 centre = Vec3::Zero();
  double longest = 0.0, joints = 0.0;
  for (const LineInput& input : inputs) {
    double length = 0.0;
    for (std::size_t k = 0; k < input.line.joints.size(); ++k) {
      const Vec3 x = model_[static_cast<std::size_t>(input.line.joints[k])].translation();
      if (k > 0) length += (x - model_[static_cast<std::size_t>(input.line.joints[k - 1])].translation()).norm();
      centre += x;
      joints += 1.0;
    }
    longest = std::max(longest, length);
  }
  centre /= joints;
  if (!(longest > 1e-9 * skeleton.extent()) || !std::isfinite(longest)) {
    throw_invalid_argument("line solver: the bones of line \"" + printable(inputs.front().line.name) +
                           "\" have no length");
  }
  unit_ = longest;
  problem.perspective = camera.projection == Camera::Projection::perspective;
  if (problem.perspective) {
    const double depth = -(view_ * centre).z();
    if (!(depth > 1e-3 * longest)) throw_invalid_argument("line solver: the line lies behind the camera");
    problem.distance = depth / unit_;
  }
  const double per_pixel = camera.units_per_pixel(centre) / unit_;
  pixel_scale_ = Vec2(per_pixel, -per_pixel);
  pixel_offset_ = Vec2(-0.5 * camera.width_px, -0.5 * camera.height_px).cwiseProduct(pixel_scale_);
  for (const Affine& joint : model_) scales_evenly_ = scales_evenly_ && !scales_unevenly(joint.linear());
  problem.weights = options.weights;
  add_nodes(inputs, options);
  for (const LineInput& input : inputs) add_path(input);
  heed_prior(humanoid);
  add_limits(options.limits);
  // The root is always a node: whatever is none moves with the nearest one above.
  carrier_ = node_of_;
  for (int joint = 1; joint < skeleton_.joint_count(); ++joint) {
    int& node = carrier_[static_cast<std::size_t>(joint)];
    if (node < 0) node = carrier_[static_cast<std::size_t>(skeleton_.parent(joint))];
  }
  add_pins(options.pins);
  add_body(humanoid, options);
  problem.finish();
}

void LineScene::add_nodes(const std::vector<LineInput>& inputs, const LineSolverOptions& options) {
  std::vector<bool> wanted(static_cast<std::size_t>(skeleton_.joint_count()), false), turns = wanted;
  for (const LineInput& input : inputs) {
    const std::vector<int>& joints = input.line.joints;
    const auto top = std::min_element(joints.begin(), joints.end());
    const bool holds_root =
        std::find(joints.begin(), joints.end(), body_root_) != joints.end() || skeleton_.is_ancestor(*top, body_root_);
    problem.moves = problem.moves || (!options.lock_root && (holds_root || options.move_body));
    // The joints that bend the line: all that have a joint of the line below them on it.
    for (auto joint = joints.begin(); joint != joints.end(); ++joint) {
      if (joint == top || (joint < top ? joint != joints.begin() : joint + 1 != joints.end())) {
        turns[static_cast<std::size_t>(*joint)] = true;
      }
    }
    for (int joint = *top; joint >= 0; joint = skeleton_.parent(joint)) {
      wanted[static_cast<std::size_t>(joint)] = true;
      if (options.move_body && skeleton_.is_ancestor(body_root_, joint)) turns[static_cast<std::size_t>(joint)] = true;
    }
    for (const int joint : joints) wanted[static_cast<std::size_t>(joint)] = true;
  }
  for (const PosePin& pin : options.pins) {
    if (pin.joint < 0 || pin.joint >= skeleton_.joint_count() || !pin.position.allFinite()) {
      throw_invalid_argument("line solver: a pin wants a joint and a finite position, got joint #" +
                             std::to_string(pin.joint));
    }
    if (pin.rotation && !(pin.rotation->norm() > 1e-6 && pin.rotation->coeffs().allFinite())) {
      throw_invalid_argument("line solver: the rotation of a pin is no rotation");
    }
    if (pin.rotation && pin.joint != body_root_) turns[static_cast<std::size_t>(pin.joint)] = true;
    // Up to the first joint that a line holds, or that carries the body.
    for (int joint = pin.joint; joint >= 0; joint = skeleton_.parent(joint)) {
      const auto at = static_cast<std::size_t>(joint);
      if (wanted[at] || joint == body_root_) {
        for (int above = joint; above >= 0; above = skeleton_.parent(above))
          wanted[static_cast<std::size_t>(above)] = true;
        break;
      }
      wanted[at] = true;
      turns[at] = turns[at] || joint != pin.joint;
    }
  }
  if (options.floor && !std::isfinite(*options.floor)) throw_invalid_argument("line solver: the floor is not finite");
  if (options.lock_root) turns[static_cast<std::size_t>(body_root_)] = false;

  node_of_.assign(wanted.size(), -1);
  for (int joint = 0; joint < skeleton_.joint_count(); ++joint) {
    const auto at = static_cast<std::size_t>(joint);
    if (!wanted[at]) continue;
    LineNode node;
    node.joint = joint;
    node.parent = joint == 0 ? -1 : node_of_[static_cast<std::size_t>(skeleton_.parent(joint))];
    node.start = view_ * Vec3(model_[at].translation()) / unit_;
    node.offset =
        node.parent < 0 ? Vec3::Zero() : Vec3(node.start - problem.nodes[static_cast<std::size_t>(node.parent)].start);
    node.column = turns[at] ? 0 : -1;
    Mat3 above = view_.linear();
    if (joint > 0) above = above * model_[static_cast<std::size_t>(skeleton_.parent(joint))].linear();
    above_.push_back(orthogonal_part(above));
    const Stiffness stiffness = stiffness_of(roles_[at]);
    node.stiffness = stiffness.swing * Mat3::Identity();
    node_of_[at] = static_cast<int>(problem.nodes.size());
    problem.nodes.push_back(node);
  }
}

void LineScene::add_path(const LineInput& input) {
  LinePath path;
  for (const int joint : input.line.joints) path.nodes.push_back(node_of(joint));
  for (std::size_t k = 1; k < path.nodes.size(); ++k) {
    const Vec3 bone = problem.nodes[static_cast<std::size_t>(path.nodes[k])].start -
                      problem.nodes[static_cast<std::size_t>(path.nodes[k - 1])].start;
    path.bones.push_back(bone.norm());
    path.start_depth.push_back(bone.z());
  }
  heeded_.push_back({heed(input, path.bones, false), heed(input, path.bones, true)});
  set_stiffness(path);
  add_shares(path);
  problem.paths.push_back(std::move(path));
  set_stroke(problem.paths.size() - 1, input.stroke.points(), false);
}

/// Twist about the bone that a joint moves costs more than swing; at the top of a line it would roll the whole body
/// over.
void LineScene::set_stiffness(const LinePath& path) {
  const int top = *std::min_element(path.nodes.begin(), path.nodes.end());
  for (std::size_t k = 0; k < path.nodes.size(); ++k) {
    LineNode& node = problem.nodes[static_cast<std::size_t>(path.nodes[k])];
    if (node.column < 0) continue;
    Vec3 along = Vec3::Zero();
    for (const std::size_t other : {k - 1, k + 1}) {
      if (other >= path.nodes.size()) continue;
      const LineNode& next = problem.nodes[static_cast<std::size_t>(path.nodes[other])];
      if (next.parent == path.nodes[k]) along = next.start - node.start - along;
    }
    const double length = along.norm();
    Stiffness stiffness = stiffness_of(roles_[static_cast<std::size_t>(node.joint)]);
    if (!person_ && path.nodes[k] == top) stiffness.twist = kRoll;
    if (length > 1e-9) {
      const Vec3 axis = along / length;
      node.stiffness =
          stiffness.swing * Mat3::Identity() + (stiffness.twist - stiffness.swing) * axis * axis.transpose();
    }
  }
}

/// Of a person more is known than what kind of joint it is: how far people turn it, about each of its axes.
void LineScene::heed_prior(const HumanoidMap& humanoid) {
  const std::vector<TurnPrior> priors = make_turn_prior(skeleton_, humanoid, start_);
  for (const TurnPrior& prior : priors) {
    const int node = node_of(prior.joint);
    if (node < 0) continue;
    const Quat local = start_.local[static_cast<std::size_t>(prior.joint)].rotation;
    const Mat3 axes = above_[static_cast<std::size_t>(node)] * (local * prior.frame).normalized().toRotationMatrix();
    const Vec3 stiffness = kUsualTurn * prior.spread.cwiseInverse();
    problem.nodes[static_cast<std::size_t>(node)].stiffness = axes * stiffness.asDiagonal() * axes.transpose();
  }
  const int root = node_of(body_root_);
  if (!priors.empty() && root >= 0) problem.nodes[static_cast<std::size_t>(root)].stiffness *= kUpright;
}

void LineScene::add_shares(const LinePath& path) {
  const auto shares = [&](std::size_t k) {
    const LineNode& node = problem.nodes[static_cast<std::size_t>(path.nodes[k])];
    const JointRole role = roles_[static_cast<std::size_t>(node.joint)];
    return node.column >= 0 && (role == JointRole::spine || role == JointRole::plain);
  };
  const auto span = [&](std::size_t k) {
    const double before = k > 0 ? path.bones[k - 1] : path.bones[k],
                 after = k < path.bones.size() ? path.bones[k] : before;
    return std::max(0.5 * (before + after), 1e-3);
  };
  for (std::size_t k = 0; k + 1 < path.nodes.size(); ++k) {
    if (!shares(k) || !shares(k + 1)) continue;
    SharedBend share{path.nodes[k], path.nodes[k + 1], span(k), span(k + 1)};
    const double mean = 0.5 * (share.length_a + share.length_b);
    share.length_a /= mean;
    share.length_b /= mean;
    problem.shares.push_back(share);
  }
}

void LineScene::add_limits(const std::vector<JointLimit>& limits) {
  for (const JointLimit& limit : limits) {
    if (limit.joint < 0 || limit.joint >= skeleton_.joint_count()) {
      throw_invalid_argument("line solver: a limit is for joint #" + std::to_string(limit.joint));
    }
    const int node = node_of(limit.joint);
    if (node < 0 || problem.nodes[static_cast<std::size_t>(node)].column < 0) continue;
    LineLimit own{node, above_[static_cast<std::size_t>(node)],
                  start_.local[static_cast<std::size_t>(limit.joint)].rotation, limit};
    if (widen_limit(own.limit, own.start_local)) limits_widened_.push_back(limit.joint);
    problem.limits.push_back(own);
  }
}

void LineScene::add_pins(const std::vector<PosePin>& pins) {
  std::vector<Quat> rotations;
  for (const PosePin& pin : pins) {
    LinePin held{node_of(pin.joint), view_ * pin.position / unit_};
    if (pin.rotation) {
      if (rotations.empty()) rotations = compute_model_rotations(skeleton_, start_);
      const Quat turn = *pin.rotation * rotations[static_cast<std::size_t>(pin.joint)].conjugate();
      held.frame = view_.linear() * turn.normalized().toRotationMatrix() * view_.linear().transpose();
    }
    problem.pins.push_back(held);
  }
}

void LineScene::add_body(const HumanoidMap& humanoid, const LineSolverOptions& options) {
  if (!options.floor && !options.avoid_overlap) return;
  NodeMap map{carrier_, {}, view_, unit_};
  std::vector<Vec3> positions;
  for (const Affine& joint : model_) positions.emplace_back(joint.translation());
  for (const LineNode& node : problem.nodes) map.start.push_back(node.start);
  problem.body =
      make_body_points(skeleton_, humanoid, positions, map, {options.floor, options.balance, options.avoid_overlap});
}

void LineScene::set_stroke(std::size_t index, std::span<const Vec2> stroke, bool reversed) {
  LinePath& path = problem.paths[index];
  path.importance = heeded_[index][reversed ? 1 : 0];
  path.curve.assign(stroke, pixel_scale_, pixel_offset_, reversed);
  path.slide_to.assign(path.nodes.size(), 0.0);
  for (std::size_t k = 0; k < path.bones.size(); ++k) {
    const Vec3 middle = 0.5 * (problem.nodes[static_cast<std::size_t>(path.nodes[k])].start +
                               problem.nodes[static_cast<std::size_t>(path.nodes[k + 1])].start);
    path.slide_to[k + 1] = path.slide_to[k] + path.bones[k] * problem.magnification(middle);
  }
  const double reach = path.slide_to.back();
  constexpr double kSlack = 1.02;  // a hand is not exact: a little too long is not shrunk
  const double factor = reach / path.curve.length();
  const bool shrinks = length_ != LengthPolicy::trim && factor * kSlack < 1.0;
  if (length_ == LengthPolicy::scale || shrinks) {
    // The anchor is the stroke's point nearest to the line's topmost joint, parents having the smaller index.
    const int top = *std::min_element(path.nodes.begin(), path.nodes.end());
    const Vec2 there = problem.project(problem.nodes[static_cast<std::size_t>(top)].start);
    const Vec2 anchor = path.curve.at(path.curve.nearest(there));
    path.curve.scale_about(anchor, length_ == LengthPolicy::scale ? factor : factor * kSlack);
  }
  // trim and extend: joints lie as far along as their bones reach, wherever the stroke ends.
  path.hold_last =
      !((length_ == LengthPolicy::trim && factor < 1.0) || (length_ == LengthPolicy::extend && factor > 1.0));
}

void LineScene::write_pose(const LineState& state, Pose& pose) const {
  pose = start_;
  for (std::size_t i = 0; i < problem.nodes.size(); ++i) {
    const LineNode& node = problem.nodes[i];
    if (node.column < 0) continue;
    // World turns become local ones: R' = Q' E Q R, Q the orthogonal part of what is above the joint.
    const Mat3 turn = above_[i].transpose() * state.turn[i].toRotationMatrix() * above_[i];
    Quat& local = pose.local[static_cast<std::size_t>(node.joint)].rotation;
    local = (Quat(turn) * local).normalized();
  }
  if (problem.moves) pose.local[0].translation += view_.linear().transpose() * (unit_ * state.shift);
  if (scales_evenly_) return;
  const Affine model = view_.inverse();
  std::vector<Vec3> wanted;
  for (std::size_t i = 0; i < pose.local.size(); ++i) {
    const auto carrier = static_cast<std::size_t>(carrier_[i]);
    const Vec3 offset = view_ * Vec3(model_[i].translation()) / unit_ - problem.nodes[carrier].start;
    wanted.push_back(model * Vec3(unit_ * problem.place(state, {carrier_[i], offset})));
  }
  keep_bone_lengths(skeleton_, start_, wanted, pose);
}

}  // namespace croquis
