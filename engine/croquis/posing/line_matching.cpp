// SPDX-License-Identifier: MIT
// M. Bergeres, Creating character poses based on lines of action, sections III and IV. What the report leaves open is
// settled so: parameters run from 0 at the matched point to 1 at the stroke's end; of two segments with one root each
// takes its own side of the stroke; a side without any length is never chosen while the other has some.
#include "croquis/posing/line_matching.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/base/text.h"
#include "croquis/math/rotation.h"
#include "croquis/posing/keep_lengths.h"

namespace croquis {
namespace {

constexpr std::array<std::pair<MatchMethod, std::string_view>, 4> kMethodNames{
    {{MatchMethod::near, "near"},
     {MatchMethod::curvilinear, "curvilinear"},
     {MatchMethod::rotation_index, "rotation-index"},
     {MatchMethod::rotation, "rotation"}}};

void check_segments(const Skeleton& skeleton, std::span<const SkeletonSegment> segments) {
  if (segments.empty()) throw_invalid_argument("match_line: got no segment, wanted at least one");
  for (const SkeletonSegment& segment : segments) {
    if (segment.size() < 2) throw_invalid_argument("match_line: a segment needs at least two joints");
    for (std::size_t i = 0; i < segment.size(); ++i) {
      if (segment[i] < 0 || segment[i] >= skeleton.joint_count()) {
        throw_invalid_argument("match_line: there is no joint #" + std::to_string(segment[i]));
      }
      if (i > 0 && skeleton.parent(segment[i]) != segment[i - 1]) {
        throw_invalid_argument("match_line: joint " + printable(skeleton.reference(segment[i])) +
                               " is no child of its predecessor in the segment");
      }
    }
  }
}

/// The root of the body: nothing branches off above it, and it is joint 0, hangs on a helper, or branches itself.
bool is_body_root(const Skeleton& skeleton, int joint) {
  for (int above = skeleton.parent(joint); above >= 0; above = skeleton.parent(above)) {
    if (skeleton.children(above).size() != 1) return false;
  }
  const int parent = skeleton.parent(joint);
  return parent < 0 || skeleton.joint(parent).helper || skeleton.children(joint).size() > 1;
}

class Matcher {
 public:
  Matcher(const Skeleton& skeleton, const Pose& start, const Polyline3& line, const MatchOptions& options)
      : skeleton_(skeleton), pose_(start), line_(line), options_(options) {
    model_.resize(start.local.size());
    update();
  }

  void match(std::span<const SkeletonSegment> segments);
  [[nodiscard]] const Pose& pose() const { return pose_; }
  [[nodiscard]] bool last_runs_forward() const { return forward_; }
  [[nodiscard]] bool ran_out() const { return ran_out_; }

 private:
  void update() { compute_model_transforms(skeleton_, pose_, model_); }
  [[nodiscard]] const Affine& model(int joint) const { return model_[static_cast<std::size_t>(joint)]; }
  [[nodiscard]] Vec3 position(int joint) const { return model(joint).translation(); }
  [[nodiscard]] double length(const SkeletonSegment& segment, std::size_t until) const;
  [[nodiscard]] double side_length(double s0, bool forward) const { return forward ? line_.length() - s0 : s0; }
  [[nodiscard]] double score(const SkeletonSegment& segment, double s0, bool forward) const;
  [[nodiscard]] bool runs_forward(const SkeletonSegment& segment, const SkeletonSegment* twin, bool first) const;
  [[nodiscard]] std::vector<Vec3> targets(const SkeletonSegment& segment, bool forward, bool whole_line) const;
  void turn(int joint, const Quat& rotation);
  void turn_root(int joint);
  void move(const SkeletonSegment& segment, const std::vector<Vec3>& points);
  void rotate(const SkeletonSegment& segment, const std::vector<Vec3>& points, bool skip_root);

  const Skeleton& skeleton_;
  Pose pose_;
  const Polyline3& line_;
  const MatchOptions& options_;
  std::vector<Affine> model_;
  bool forward_ = true;
  bool ran_out_ = false;
};

double Matcher::length(const SkeletonSegment& segment, std::size_t until) const {
  double sum = 0.0;
  for (std::size_t i = 1; i <= until; ++i) sum += (position(segment[i]) - position(segment[i - 1])).norm();
  return sum;
}

/// How well one side of the line suits a segment; higher is better.
double Matcher::score(const SkeletonSegment& segment, double s0, bool forward) const {
  const double own = length(segment, segment.size() - 1), side = side_length(s0, forward);
  if (options_.direction == DirectionRule::length) return -std::abs(side - own);
  const double reach = std::min(own, side);
  const Vec3 along = line_.at(forward ? s0 + reach : s0 - reach) - line_.at(s0);
  return along.norm() > 0.0 ? (position(segment.back()) - position(segment.front())).dot(along.normalized()) : 0.0;
}

bool Matcher::runs_forward(const SkeletonSegment& segment, const SkeletonSegment* twin, bool first) const {
  if (options_.direction == DirectionRule::forward) return !(twin && first);
  if (options_.direction == DirectionRule::backward) return twin && first;
  const double s0 = line_.nearest(position(segment.front()));
  if (twin) {
    const double ahead = score(segment, s0, true) + score(*twin, s0, false);
    const double back = score(segment, s0, false) + score(*twin, s0, true);
    return ahead == back ? !first : ahead > back;
  }
  const double least = 0.05 * std::min(line_.length(), length(segment, segment.size() - 1));
  if (side_length(s0, true) < least && side_length(s0, false) >= least) return false;
  if (side_length(s0, false) < least && side_length(s0, true) >= least) return true;
  return score(segment, s0, true) >= score(segment, s0, false);
}

/// Where each joint of the segment shall lie, the line not moved.
std::vector<Vec3> Matcher::targets(const SkeletonSegment& segment, bool forward, bool whole_line) const {
  std::vector<Vec3> result;
  const double nearest = line_.nearest(position(segment.front()));
  const double s0 = whole_line ? (forward ? 0.0 : line_.length()) : nearest;
  if (options_.method == MatchMethod::near) {
    for (const int joint : segment) result.push_back(line_.at(line_.nearest(position(joint))));
  } else if (options_.method == MatchMethod::rotation) {
    const double own = length(segment, segment.size() - 1), side = side_length(s0, forward);
    for (std::size_t i = 0; i < segment.size(); ++i) {
      const double part = own > 0.0 ? length(segment, i) / own : 0.0;
      result.push_back(line_.at(forward ? s0 + part * side : s0 - part * side));
    }
  } else {
    // y_o = o / K over the K points of this side, x_i = i / k over the k joints: the nearest o.
    const auto after = std::lower_bound(line_.arc().begin(), line_.arc().end(), s0) - line_.arc().begin();
    auto origin = std::min<std::ptrdiff_t>(after, std::ssize(line_.arc()) - 1);
    if (origin > 0 &&
        s0 - line_.arc()[static_cast<std::size_t>(origin - 1)] < line_.arc()[static_cast<std::size_t>(origin)] - s0) {
      --origin;
    }
    const std::ptrdiff_t count = forward ? std::ssize(line_.arc()) - origin : origin + 1;
    const double step = static_cast<double>(count) / static_cast<double>(segment.size());
    for (std::size_t i = 0; i < segment.size(); ++i) {
      const auto o = std::min<std::ptrdiff_t>(std::lround(static_cast<double>(i) * step), count - 1);
      result.push_back(line_.points()[static_cast<std::size_t>(forward ? origin + o : origin - o)]);
    }
  }
  return result;
}

/// Turns a joint and everything below it by a rotation given in model space.
void Matcher::turn(int joint, const Quat& rotation) {
  const int parent = skeleton_.parent(joint);
  const Quat above = parent >= 0 ? rotation_of(model(parent)) : Quat::Identity();
  Quat& local = pose_.local[static_cast<std::size_t>(joint)].rotation;
  local = (above.conjugate() * rotation * above * local).normalized();
  update();
}

void Matcher::turn_root(int joint) {
  const Vec3 up = rotation_of(model(joint)) * (rotation_of(skeleton_.rest_model(joint)).conjugate() * Vec3::UnitY());
  const double s = line_.nearest(position(joint)), epsilon = 0.02 * line_.length();
  const Vec3 tangent = line_.at(s + epsilon) - line_.at(s - epsilon);
  turn(joint, rotation_between(up, tangent.dot(up) < 0.0 ? Vec3(-tangent) : tangent));
}

void Matcher::move(const SkeletonSegment& segment, const std::vector<Vec3>& points) {
  for (std::size_t i = 0; i < segment.size(); ++i) {
    const int parent = skeleton_.parent(segment[i]);
    const Affine above = parent >= 0 ? model(parent) : Affine::Identity();
    if (std::abs(above.linear().determinant()) < 1e-30) continue;  // a parent scaled to nothing moves nobody
    pose_.local[static_cast<std::size_t>(segment[i])].translation = above.inverse() * points[i];
    update();
  }
}

/// Algorithm 1.
void Matcher::rotate(const SkeletonSegment& segment, const std::vector<Vec3>& points, bool skip_root) {
  const Vec3 shift = position(segment.front()) - points.front();
  for (std::size_t i = skip_root ? 1 : 0; i + 1 < segment.size(); ++i) {
    const Vec3 pivot = position(segment[i]);
    turn(segment[i], rotation_between(position(segment[i + 1]) - pivot, points[i + 1] + shift - pivot));
  }
}

void Matcher::match(std::span<const SkeletonSegment> segments) {
  const bool rotates = options_.method == MatchMethod::rotation || options_.method == MatchMethod::rotation_index;
  std::map<int, std::vector<std::size_t>> by_root;
  for (std::size_t i = 0; i < segments.size(); ++i) by_root[segments[i].front()].push_back(i);
  if (rotates && options_.root == RootMode::tangent) {
    for (const auto& entry : by_root) {
      if (is_body_root(skeleton_, entry.first)) turn_root(entry.first);
    }
  }
  // Sides and points are chosen in the pose drawn over, before anything moves; roots come before what hangs on them.
  for (const auto& entry : by_root) {
    const std::vector<std::size_t>& group = entry.second;
    std::vector<std::vector<Vec3>> points;
    for (const std::size_t i : group) {
      const bool pair = group.size() == 2;
      const bool first = i == group.front();
      const SkeletonSegment* twin = pair ? &segments[first ? group.back() : group.front()] : nullptr;
      const bool forward = runs_forward(segments[i], twin, first);
      const bool whole = options_.method == MatchMethod::curvilinear && segments.size() == 1;
      forward_ = forward;
      const double side = whole ? line_.length() : side_length(line_.nearest(position(entry.first)), forward);
      ran_out_ = ran_out_ || side < 0.05 * length(segments[i], segments[i].size() - 1);
      points.push_back(targets(segments[i], forward, whole));
    }
    const bool skip_root = group.size() > 1 || is_body_root(skeleton_, entry.first);
    for (std::size_t k = 0; k < group.size(); ++k) {
      if (rotates) {
        rotate(segments[group[k]], points[k], skip_root);
      } else {
        move(segments[group[k]], points[k]);
      }
    }
  }
}

std::string status_of(const MatchResult& result, bool stretches, bool ran_out) {
  if (result.bone_length_drift > 1e-6) {
    const std::string amount = format_double(100.0 * result.bone_length_drift, 3) + " %";
    return stretches ? "bones were stretched by up to " + amount
                     : "bone lengths changed by up to " + amount + ": a joint above them is scaled unevenly";
  }
  return ran_out ? "the stroke has no length left on the side where a segment runs along it" : "ok";
}

}  // namespace

std::optional<MatchMethod> parse_match_method(std::string_view name) {
  for (const auto& [method, text] : kMethodNames) {
    if (name == text) return method;
  }
  return std::nullopt;
}

std::string_view to_string(MatchMethod method) { return kMethodNames[static_cast<std::size_t>(method)].second; }

MatchResult match_line(const Skeleton& skeleton, const Pose& start, std::span<const SkeletonSegment> segments,
                       const Polyline2& stroke, const Camera& camera, const MatchOptions& options) {
  check_segments(skeleton, segments);
  camera.check();
  if (!(stroke.length() > 0.0)) throw_invalid_argument("match_line: the stroke has no length");
  Box box;
  const std::vector<Vec3> positions = compute_positions(skeleton, start);
  for (int i = 0; i < skeleton.joint_count(); ++i) {
    if (!skeleton.joint(i).helper) box.extend(positions[static_cast<std::size_t>(i)]);
  }
  const Vec3 centre = box.isEmpty() ? positions.front() : Vec3(box.center());
  if (!centre.allFinite()) throw_invalid_argument("match_line: the start pose is not finite");
  const Polyline3 line(unproject_stroke(stroke.points(), camera, options.plane, centre));

  Matcher matcher(skeleton, start, line, options);
  matcher.match(segments);
  MatchResult result;
  result.pose = matcher.pose();
  result.forward = matcher.last_runs_forward();
  const bool stretches = options.method == MatchMethod::near || options.method == MatchMethod::curvilinear;
  if (!stretches) keep_bone_lengths(skeleton, start, {}, result.pose);
  result.bone_length_drift = bone_length_drift(skeleton, start, result.pose);
  result.status = status_of(result, stretches, matcher.ran_out());
  for (const SkeletonSegment& segment : segments) {
    const LineFit fit = measure_fit(skeleton, result.pose, {"", segment}, stroke, camera);
    result.fit.mean_px += fit.mean_px / static_cast<double>(segments.size());
    result.fit.max_px = std::max(result.fit.max_px, fit.max_px);
    result.fit.tangent_deg += fit.tangent_deg / static_cast<double>(segments.size());
  }
  return result;
}

MatchResult match_line(const Skeleton& skeleton, const Pose& start, const BodyLine& line, const Polyline2& stroke,
                       const Camera& camera, const MatchOptions& options) {
  const std::vector<SkeletonSegment> segments = segments_of_line(skeleton, line);
  // A line that only climbs comes back turned round.
  const bool turned = segments.size() == 1 && segments.front().front() != line.joints.front();
  MatchOptions own = options;
  if (turned && options.direction == DirectionRule::forward) own.direction = DirectionRule::backward;
  if (turned && options.direction == DirectionRule::backward) own.direction = DirectionRule::forward;
  MatchResult result = match_line(skeleton, start, segments, stroke, camera, own);
  if (turned) result.forward = !result.forward;
  result.fit = measure_fit(skeleton, result.pose, line, stroke, camera);
  return result;
}

}  // namespace croquis
