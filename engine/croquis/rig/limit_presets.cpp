// SPDX-License-Identifier: MIT
// Limits from the geometry of a standing body. A joint's axes at rest are whatever an exporter made of them; what can
// be trusted is where joints are. So the axes come from the body: up from trunk and legs, left from the lines of hips
// and shoulders, front = left x up, and each joint's flexion axis from these and the directions of its bones.
#include <algorithm>
#include <cmath>

#include "croquis/math/rotation.h"
#include "croquis/rig/joint_limits.h"

namespace croquis {
namespace {

/// Ranges in degrees, for a joint of the left side or the middle: x about the axis of flexion, y about the axis across,
/// t about the bone. On the right y and t change their signs.
struct Range {
  double x_min, x_max, y_min, y_max, t_min, t_max;
  bool hinge = false;
};

// The table of docs/conventions.md. Arms end 10 degrees short of straight up: a swing of a half turn comes back from
// the other side there, and no optimiser could tell the sides apart.
constexpr Range kTrunk = {-40, 90, -40, 40, -50, 50};
constexpr Range kNeck = {-70, 60, -45, 45, -80, 80};
constexpr Range kShoulder = {-10, 40, -20, 25, -15, 15};
constexpr Range kUpperArm = {-60, 170, -170, 50, -100, 90};
constexpr Range kLowerArm = {-5, 155, -3, 3, -45, 45, true};
constexpr Range kHand = {-75, 85, -25, 40, -45, 45};
constexpr Range kUpperLeg = {-30, 130, -60, 30, -50, 45};
constexpr Range kLowerLeg = {-5, 150, -3, 3, -10, 10, true};
constexpr Range kFoot = {-60, 25, -20, 20, -35, 20};
constexpr Range kToes = {-40, 80, -5, 5, -5, 5, true};
constexpr Range kFingerRanges[3] = {
    {-30, 90, -20, 20, -5, 5}, {-10, 110, -3, 3, -3, 3, true}, {-10, 85, -3, 3, -3, 3, true}};
constexpr Range kThumbRanges[3] = {
    {-20, 45, -60, 15, -20, 20}, {-10, 60, -10, 10, -5, 5}, {-15, 85, -3, 3, -3, 3, true}};
constexpr Range kTwistBone = {-2, 2, -2, 2, -45, 45};
constexpr Range kConnector = {-2, 2, -2, 2, -2, 2};
constexpr double kWidestSwing = 170.0;
constexpr double kWidestTwist = 175.0;

/// The body's own directions, in model space.
struct BodyAxes {
  Vec3 left, up, front;
};

/// A direction of a bone and the axis about which it bends, in model space.
struct BoneAxes {
  Vec3 along, flexion;
};

class LimitMaker {
 public:
  LimitMaker(const Skeleton& skeleton, const HumanoidMap& humanoid, LimitPreset preset, const Pose& stance)
      : skeleton_(skeleton),
        humanoid_(humanoid),
        stance_(stance),
        model_(compute_model_transforms(skeleton, stance)),
        scale_(preset == LimitPreset::dancer    ? 1.2
               : preset == LimitPreset::cartoon ? 1.5
                                                : 1.0) {}

  [[nodiscard]] std::vector<JointLimit> run() {
    if (!find_body_axes()) return {};
    make_trunk();
    for (const bool left : {true, false}) {
      side_ = left ? 1.0 : -1.0;
      make_arm(left);
      make_leg(left);
    }
    std::sort(limits_.begin(), limits_.end(),
              [](const JointLimit& a, const JointLimit& b) { return a.joint < b.joint; });
    return limits_;
  }

 private:
  [[nodiscard]] int joint(HumanoidBone bone) const { return humanoid_.joint(bone); }
  [[nodiscard]] Vec3 at(int joint) const { return model_[static_cast<std::size_t>(joint)].translation(); }
  [[nodiscard]] Vec3 direction(int from, int to, const Vec3& otherwise) const;
  /// The axis of the right side that mirrors a left axis of rotation.
  [[nodiscard]] Vec3 of_side(const Vec3& axis) const {
    return side_ > 0.0 ? axis : Vec3(2.0 * body_.left.dot(axis) * body_.left - axis);
  }

  bool find_body_axes();
  void make_trunk();
  void make_group(const std::vector<int>& joints, const Range& whole, double share, double twist_share);
  void make_arm(bool left);
  void make_leg(bool left);
  void make_fingers(HumanoidBone thumb, int hand, const Vec3& palm_axis);
  void make_between(int upper, int lower, const Range& range);
  void add(int joint, const BoneAxes& now, const BoneAxes& neutral, const Range& range);
  void add(int joint, const BoneAxes& now, const Range& range) { add(joint, now, now, range); }

  const Skeleton& skeleton_;
  const HumanoidMap& humanoid_;
  const Pose& stance_;
  std::vector<Affine> model_;
  double scale_;
  double side_ = 1.0;
  BodyAxes body_{};
  std::vector<JointLimit> limits_;
};

Vec3 orthogonal_part(const Vec3& v, const Vec3& unit) {
  const Vec3 part = v - unit * unit.dot(v);
  return part.norm() > 1e-6 * v.norm() && v.norm() > 0.0 ? part.normalized() : unit.unitOrthogonal();
}

Mat3 frame_of(const BoneAxes& axes) {
  Mat3 frame;
  const Vec3 z = axes.along.normalized(), x = orthogonal_part(axes.flexion, z);
  frame << x, z.cross(x), z;
  return frame;
}

/// A hinge's axis: as the body says, drawn to the plane in which the joint is already bent: hardly by the few degrees
/// that riggers leave for IK, half way at 17, wholly beyond 30 (unless it is bent the wrong way round).
Vec3 hinge_axis(const Vec3& expected, const Vec3& upper, const Vec3& lower) {
  const Vec3 bend = upper.cross(lower);
  if (bend.dot(expected) <= 0.0) return orthogonal_part(expected, upper);
  return orthogonal_part(expected + 60.0 * bend.squaredNorm() * bend, upper);
}

/// The bone beyond a hinge as the hinge sees it: without what it stands off to the side (a carrying angle, knock
/// knees), which is how the body is made and no turn.
BoneAxes beyond_hinge(const Vec3& axis, const Vec3& along) { return {orthogonal_part(along, axis), axis}; }

Vec3 LimitMaker::direction(int from, int to, const Vec3& otherwise) const {
  if (from < 0 || to < 0) return otherwise;
  const Vec3 d = at(to) - at(from);
  return d.norm() > 1e-6 * skeleton_.extent() ? Vec3(d.normalized()) : otherwise;
}

bool LimitMaker::find_body_axes() {
  using enum HumanoidBone;
  const int top = humanoid_.has(head) ? joint(head) : joint(neck);
  const Vec3 trunk = direction(joint(hips), top, Vec3::Zero());
  Vec3 legs = Vec3::Zero(), left = Vec3::Zero();
  for (const auto& [upper, foot, lower] :
       {std::array{leftUpperLeg, leftFoot, leftLowerLeg}, std::array{rightUpperLeg, rightFoot, rightLowerLeg}}) {
    const Vec3 leg = direction(joint(upper), humanoid_.has(foot) ? joint(foot) : joint(lower), Vec3::Zero());
    if (leg.dot(trunk) > -0.3) return false;  // no standing body: its axes cannot be told
    legs += leg;
  }
  body_.up = (trunk - legs.normalized()).normalized();
  left += direction(joint(rightUpperLeg), joint(leftUpperLeg), Vec3::Zero());
  left += direction(joint(rightUpperArm), joint(leftUpperArm), Vec3::Zero());
  left -= body_.up * body_.up.dot(left);
  if (left.norm() < 0.1) return false;
  body_.left = left.normalized();
  body_.front = body_.left.cross(body_.up);
  return true;
}

/// One joint's limit. Directions are taken into the space of the joint's parent; if that space is mirrored, turns
/// change their sense.
void LimitMaker::add(int joint, const BoneAxes& now, const BoneAxes& neutral, const Range& range) {
  if (joint <= 0) return;
  const Mat3 parent = model_[static_cast<std::size_t>(skeleton_.parent(joint))].linear();
  const double determinant = parent.determinant();
  if (!(std::abs(determinant) > 0.0)) return;
  const double sense = determinant < 0.0 ? -1.0 : 1.0;
  const Mat3 inverse = parent.inverse();
  const Mat3 frame_now = frame_of({inverse * now.along, sense * (inverse * now.flexion)});
  const Mat3 frame_neutral = frame_of({inverse * neutral.along, sense * (inverse * neutral.flexion)});
  JointLimit limit;
  limit.joint = joint;
  limit.neutral = Quat(frame_neutral * frame_now.transpose()) * stance_.local[static_cast<std::size_t>(joint)].rotation;
  limit.neutral.normalize();
  limit.frame = (limit.neutral.conjugate() * Quat(frame_neutral)).normalized();
  const auto swing = [&](double degrees) {
    return std::clamp(scale_ * degrees, -kWidestSwing, kWidestSwing) * kDegree;
  };
  const auto twist = [&](double degrees) {
    return std::clamp(scale_ * degrees, -kWidestTwist, kWidestTwist) * kDegree;
  };
  const bool flipped = side_ * sense < 0.0;
  limit.swing_min = {swing(range.x_min), swing(flipped ? -range.y_max : range.y_min)};
  limit.swing_max = {swing(range.x_max), swing(flipped ? -range.y_min : range.y_max)};
  limit.twist_min = twist(flipped ? -range.t_max : range.t_min);
  limit.twist_max = twist(flipped ? -range.t_min : range.t_max);
  limit.hinge = range.hinge;
  limits_.push_back(limit);
}

/// Joints of a limb that no bone of the map is: twist bones and connectors do not bend.
void LimitMaker::make_between(int upper, int lower, const Range& range) {
  if (upper < 0 || lower < 0 || upper == lower || !skeleton_.is_ancestor(upper, lower)) return;
  const std::vector<int> path = skeleton_.path(upper, lower);
  for (std::size_t i = 1; i + 1 < path.size(); ++i) {
    if (humanoid_.bone_of(path[i])) continue;
    const Vec3 along = direction(path[i], path[i + 1], body_.up);
    add(path[i], {along, along.unitOrthogonal()}, range);
  }
}

/// Joints of the trunk or neck that share a part of its range alike.
void LimitMaker::make_group(const std::vector<int>& joints, const Range& whole, double share, double twist_share) {
  const double each = share / static_cast<double>(joints.size());
  const double twist = twist_share / static_cast<double>(joints.size());
  for (const int joint : joints) {
    Vec3 along = body_.up;
    for (const int child : skeleton_.children(joint)) {
      const Vec3 d = direction(joint, child, body_.up);
      if (skeleton_.is_ancestor(child, this->joint(HumanoidBone::head)) && d.dot(body_.up) > 0.3) along = d;
    }
    add(joint, {along, body_.left},
        {each * whole.x_min, each * whole.x_max, each * whole.y_min, each * whole.y_max, twist * whole.t_min,
         twist * whole.t_max});
  }
}

/// The trunk bends by 40, 35 and 25 % in spine, chest and upper chest and twists mostly in the upper two; neck and head
/// go halves. Joints between two bones of the map share the lower one's part.
void LimitMaker::make_trunk() {
  using enum HumanoidBone;
  const struct {
    HumanoidBone bone;
    double share, twist;
    bool neck;
  } parts[] = {{spine, 0.4, 0.2, false},
               {chest, 0.35, 0.45, false},
               {upperChest, 0.25, 0.35, false},
               {neck, 0.5, 0.5, true},
               {head, 0.5, 0.5, true}};
  double bend[2] = {0.0, 0.0}, twist[2] = {0.0, 0.0};
  for (const auto& part : parts) {
    if (!humanoid_.has(part.bone)) continue;
    bend[part.neck ? 1 : 0] += part.share;
    twist[part.neck ? 1 : 0] += part.twist;
  }
  side_ = 1.0;
  for (const auto& part : parts) {
    if (!humanoid_.has(part.bone)) continue;
    std::vector<int> group{joint(part.bone)};
    const std::vector<int> from_hips = skeleton_.path(joint(hips), group.front());
    for (std::size_t i = 1; part.bone == spine && i + 1 < from_hips.size(); ++i) group.push_back(from_hips[i]);
    const std::vector<int> way = skeleton_.path(joint(part.bone), humanoid_.has(head) ? joint(head) : joint(neck));
    for (std::size_t i = 1; i < way.size() && !humanoid_.bone_of(way[i]); ++i) group.push_back(way[i]);
    const int k = part.neck ? 1 : 0;
    make_group(group, part.neck ? kNeck : kTrunk, part.share / bend[k], part.twist / twist[k]);
  }
}

void LimitMaker::make_arm(bool left) {
  using enum HumanoidBone;
  const auto bone = [&](HumanoidBone of_left) { return joint(left ? of_left : mirror(of_left)); };
  const int clavicle = bone(leftShoulder), upper = bone(leftUpperArm), lower = bone(leftLowerArm),
            hand = bone(leftHand);
  const Vec3 out = side_ * body_.left, down = -body_.up;
  const Vec3 along_upper = direction(upper, lower, out), along_lower = direction(lower, hand, along_upper);
  // How the arm comes from where it is to hanging down, palm to the thigh: straight, or through the T-pose if it points
  // up (then straight has no meaning).
  Quat hang = rotation_between(along_upper, down);
  if (along_upper.dot(down) < -0.2) hang = rotation_between(out, down) * rotation_between(along_upper, out);
  const Vec3 elbow = hinge_axis(hang.conjugate() * -body_.left, along_upper, along_lower);
  if (clavicle >= 0) add(clavicle, {direction(clavicle, upper, out), of_side(body_.front)}, kShoulder);
  add(upper, {along_upper, elbow}, {down, -body_.left}, kUpperArm);
  add(lower, beyond_hinge(elbow, along_lower), {along_upper, elbow}, kLowerArm);
  int carrier = -1;  // the joint of the trunk that the arm hangs on
  for (const HumanoidBone part : {spine, chest, upperChest, neck}) {
    if (humanoid_.has(part) && skeleton_.is_ancestor(joint(part), upper)) carrier = joint(part);
  }
  make_between(carrier, clavicle >= 0 ? clavicle : upper, kConnector);
  make_between(clavicle, upper, kConnector);
  make_between(upper, lower, kTwistBone);
  if (hand < 0) return;
  make_between(lower, hand, kTwistBone);
  // The wrist bends about the line of the knuckles; without fingers, as if the palm faced down in a T-pose.
  const int index = bone(leftIndexProximal), little = bone(leftLittleProximal), middle = bone(leftMiddleProximal);
  const Vec3 along_hand = direction(hand, middle >= 0 ? middle : index, along_lower);
  Vec3 palm = rotation_between(along_upper, along_lower) * (hang.conjugate() * of_side(-body_.front));
  if (index >= 0 && little >= 0) palm = side_ * direction(index, little, side_ * palm);
  palm = orthogonal_part(palm, along_hand);
  add(hand, {along_hand, palm}, kHand);
  make_fingers(left ? leftThumbMetacarpal : rightThumbMetacarpal, hand, palm);
}

void LimitMaker::make_fingers(HumanoidBone thumb, int hand, const Vec3& palm_axis) {
  const auto bone = [&](int finger, int k) {
    return joint(static_cast<HumanoidBone>(static_cast<int>(thumb) + 3 * finger + k));
  };
  const int little = bone(4, 0) >= 0 ? bone(4, 0) : bone(1, 0);
  for (int finger = 0; finger < 5; ++finger) {
    Vec3 before = Vec3::Zero(), axis = palm_axis;
    for (int k = 0; k < 3; ++k) {
      const int joint = bone(finger, k);
      if (joint < 0) continue;
      int next = k < 2 ? bone(finger, k + 1) : -1;
      if (next < 0 && !skeleton_.children(joint).empty()) next = skeleton_.children(joint).front();
      Vec3 along = direction(joint, next, before);
      if (along.isZero()) along = direction(hand, joint, body_.up);
      if (before.isZero() && finger == 0) {
        // A thumb bends across the palm, toward the root of the little finger.
        const Vec3 across = direction(joint, little, Vec3::Zero());
        axis = across.isZero() ? palm_axis : Vec3(along.cross(across));
      }
      const Range& range = finger == 0 ? kThumbRanges[k] : kFingerRanges[k];
      if (!before.isZero() && range.hinge) {
        axis = orthogonal_part(axis, before);
        add(joint, beyond_hinge(axis, along), {before, axis}, range);
      } else {
        add(joint, {along, axis}, range);
      }
      before = along;
    }
  }
}

void LimitMaker::make_leg(bool left) {
  using enum HumanoidBone;
  const auto bone = [&](HumanoidBone of_left) { return joint(left ? of_left : mirror(of_left)); };
  const int upper = bone(leftUpperLeg), lower = bone(leftLowerLeg), foot = bone(leftFoot), toes = bone(leftToes);
  const Vec3 down = -body_.up;
  const Vec3 along_upper = direction(upper, lower, down), along_lower = direction(lower, foot, along_upper);
  const Quat hang = rotation_between(along_upper, down);
  const Vec3 knee = hinge_axis(hang.conjugate() * body_.left, along_upper, along_lower);
  // The thigh flexes forward, about the axis opposite to the knee's.
  add(upper, {along_upper, -knee}, {down, -body_.left}, kUpperLeg);
  add(lower, beyond_hinge(knee, along_lower), {along_upper, knee}, kLowerLeg);
  make_between(joint(hips), upper, kConnector);
  make_between(upper, lower, kTwistBone);
  if (foot < 0) return;
  make_between(lower, foot, kTwistBone);
  const Vec3 along_foot = direction(foot, toes, body_.front);
  // Without toes, or straight under the ankle, a foot points to the front.
  const Vec3 sole = std::abs(along_foot.dot(body_.up)) < 0.95 ? along_foot : body_.front;
  add(foot, {sole, -body_.left}, kFoot);
  const Vec3 level = orthogonal_part(sole, body_.up);
  if (toes >= 0) add(toes, {level, -body_.left}, kToes);
}

}  // namespace

std::vector<JointLimit> make_joint_limits(const Skeleton& skeleton, const HumanoidMap& humanoid, LimitPreset preset) {
  return make_joint_limits(skeleton, humanoid, preset, rest_pose(skeleton));
}

std::vector<JointLimit> make_joint_limits(const Skeleton& skeleton, const HumanoidMap& humanoid, LimitPreset preset,
                                          const Pose& stance) {
  if (preset == LimitPreset::none || !humanoid.is_humanoid()) return {};
  return LimitMaker(skeleton, humanoid, preset, stance).run();
}

}  // namespace croquis
