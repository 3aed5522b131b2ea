// SPDX-License-Identifier: MIT
// Source: gltf2, section 3.11 "Animations".
#include "croquis/io/gltf_clip_write.h"

#include <algorithm>
#include <set>
#include <utility>

#include <nlohmann/json.hpp>

namespace croquis {
namespace {

constexpr double kRounding = 1e-12;

const char* path_of(CurveTarget target) {
  switch (target) {
    case CurveTarget::translation:
      return "translation";
    case CurveTarget::rotation:
      return "rotation";
    case CurveTarget::scale:
      return "scale";
    case CurveTarget::weights:
      break;
  }
  return "weights";
}

const char* name_of(Interpolation interpolation) {
  switch (interpolation) {
    case Interpolation::step:
      return "STEP";
    case Interpolation::linear:
      return "LINEAR";
    case Interpolation::cubic_spline:
      break;
  }
  return "CUBICSPLINE";
}

/// The values of the curve's keys as floats, rotations normalised.
std::vector<float> values_of(const Curve& curve) {
  std::vector<float> values(curve.values.begin(), curve.values.end());
  if (curve.target != CurveTarget::rotation || curve.width != 4) return values;
  const std::size_t step = curve.interpolation == Interpolation::cubic_spline ? 12 : 4;
  const std::size_t first = curve.interpolation == Interpolation::cubic_spline ? 4 : 0;
  for (std::size_t i = first; i + 4 <= values.size(); i += step) {
    Vec4 q(curve.values.data() + i);
    q = q.norm() > 1e-12 ? Vec4(q.normalized()) : Vec4(0, 0, 0, 1);
    for (std::size_t k = 0; k < 4; ++k) values[i + k] = static_cast<float>(q[static_cast<Eigen::Index>(k)]);
  }
  return values;
}

Curve make_key(CurveTarget target, int joint, std::vector<double> values) {
  const int width = static_cast<int>(values.size());
  return {.target = target,
          .joint = joint,
          .interpolation = Interpolation::linear,
          .width = width,
          .times = {0.0},
          .values = std::move(values)};
}

}  // namespace

int ClipWriter::add_times(const std::vector<double>& times, double shift) {
  std::vector<float> numbers;
  for (const double time : times) numbers.push_back(static_cast<float>(time + shift));
  const auto found = accessor_of_times_.find(numbers);
  if (found != accessor_of_times_.end()) return found->second;
  return accessor_of_times_[numbers] = editor_.add_floats(numbers, "SCALAR", true);
}

void ClipWriter::add(const Clip& clip) {
  Json samplers = Json::array(), channels = Json::array();
  const double shift = std::max(0.0, -clip.start_time());  // glTF has no time before 0
  for (const Curve& curve : clip.curves) {
    const std::vector<int>& nodes = curve.target == CurveTarget::weights ? node_of_part_ : node_of_joint_;
    const int node =
        curve.joint >= 0 && curve.joint < std::ssize(nodes) ? nodes[static_cast<std::size_t>(curve.joint)] : -1;
    if (node < 0 || curve.times.empty()) continue;
    const char* type = curve.target == CurveTarget::rotation  ? "VEC4"
                       : curve.target == CurveTarget::weights ? "SCALAR"
                                                              : "VEC3";
    const int input = add_times(curve.times, shift);
    const int output = editor_.add_floats(values_of(curve), type);
    channels.push_back({{"sampler", samplers.size()}, {"target", {{"node", node}, {"path", path_of(curve.target)}}}});
    samplers.push_back({{"input", input}, {"interpolation", name_of(curve.interpolation)}, {"output", output}});
  }
  if (channels.empty()) return;
  Json animation = Json::object();
  if (!clip.name.empty()) animation["name"] = clip.name;
  animation["channels"] = std::move(channels);
  animation["samplers"] = std::move(samplers);
  (void)editor_.append("animations", animation);
}

Clip make_pose_clip(const Skeleton& skeleton, const Pose& rest, const Pose& pose, std::string name) {
  Clip clip{.name = std::move(name)};
  for (int i = 0; i < skeleton.joint_count(); ++i) {
    const Transform& from = rest.local[static_cast<std::size_t>(i)];
    const Transform& to = pose.local[static_cast<std::size_t>(i)];
    const Vec3 &t = to.translation, &s = to.scale;
    const Quat q = to.rotation.normalized();
    if (!skeleton.joint(i).helper || is_turned(from.rotation, q)) {
      clip.curves.push_back(make_key(CurveTarget::rotation, i, {q.x(), q.y(), q.z(), q.w()}));
    }
    if (is_moved(from.translation, t))
      clip.curves.push_back(make_key(CurveTarget::translation, i, {t.x(), t.y(), t.z()}));
    if (is_moved(from.scale, s)) clip.curves.push_back(make_key(CurveTarget::scale, i, {s.x(), s.y(), s.z()}));
  }
  return clip;
}

std::string free_clip_name(const std::vector<Clip>& clips) {
  std::set<std::string> taken;
  for (const Clip& clip : clips) taken.insert(clip.name);
  std::string name = "pose";
  for (int i = 2; taken.count(name) > 0; ++i) name = "pose " + std::to_string(i);
  return name;
}

bool is_moved(const Vec3& a, const Vec3& b) {
  return (a - b).cwiseAbs().maxCoeff() > kRounding * std::max(1.0, a.cwiseAbs().maxCoeff());
}

bool is_turned(const Quat& a, const Quat& b) {
  const Vec4 &p = a.coeffs(), &q = b.coeffs();
  return std::min((p - q).norm(), (p + q).norm()) > kRounding;
}

bool is_changed(const Transform& a, const Transform& b) {
  return is_moved(a.translation, b.translation) || is_turned(a.rotation, b.rotation) || is_moved(a.scale, b.scale);
}

}  // namespace croquis
