// SPDX-License-Identifier: MIT
#include "croquis/anim/clip.h"

#include <algorithm>
#include <cmath>

#include "croquis/base/error.h"

namespace croquis {
namespace {

using Eigen::Map;
using Eigen::VectorXd;

/// Shorter-way slerp of two xyzw quaternions that need not be normalised.
VectorXd slerp(const Eigen::Ref<const VectorXd>& a, const Eigen::Ref<const VectorXd>& b, double t) {
  const Quat qa = Quat(Vec4(a)).normalized(), qb = Quat(Vec4(b)).normalized();
  return qa.slerp(t, qb).coeffs();
}

/// The curve whose keys count as the clip's frames.
const Curve* busiest_curve(const Clip& clip) {
  const auto it = std::max_element(clip.curves.begin(), clip.curves.end(),
                                   [](const Curve& a, const Curve& b) { return a.times.size() < b.times.size(); });
  return it == clip.curves.end() ? nullptr : &*it;
}

}  // namespace

void Curve::check() const {
  const std::size_t per_key =
      (interpolation == Interpolation::cubic_spline ? 3U : 1U) * static_cast<std::size_t>(width);
  const auto finite = [](double v) { return std::isfinite(v); };
  if (width < 1 || times.empty() || values.size() != times.size() * per_key) {
    throw_invalid_argument("Curve: wanted at least one key and " + std::to_string(per_key) + " numbers per key, got " +
                           std::to_string(times.size()) + " keys and " + std::to_string(values.size()) + " numbers");
  }
  if (!std::all_of(times.begin(), times.end(), finite) || !std::all_of(values.begin(), values.end(), finite)) {
    throw_invalid_argument("Curve: a time or value is not finite");
  }
  if (std::adjacent_find(times.begin(), times.end(), std::greater_equal<>()) != times.end()) {
    throw_invalid_argument("Curve: times do not increase");
  }
}

std::vector<double> Curve::sample(double time) const {
  const bool cubic = interpolation == Interpolation::cubic_spline;
  const auto key = [&](std::size_t i, int part) {  // part: 0 in-tangent, 1 value, 2 out-tangent
    const std::size_t first = (cubic ? 3 * i + static_cast<std::size_t>(part) : i) * static_cast<std::size_t>(width);
    return Map<const VectorXd>(values.data() + first, width);
  };
  const auto next = static_cast<std::size_t>(std::upper_bound(times.begin(), times.end(), time) - times.begin());
  VectorXd value;
  if (next == 0) {
    value = key(0, 1);
  } else if (next == times.size() || interpolation == Interpolation::step) {
    value = key(next - 1, 1);
  } else {
    const std::size_t i = next - 1;
    const double span = times[next] - times[i];
    const double t = (time - times[i]) / span;
    if (cubic) {
      // Hermite, with tangents per second (glTF 2.0, appendix C).
      const double t2 = t * t, t3 = t2 * t;
      value = (2 * t3 - 3 * t2 + 1) * key(i, 1) + (span * (t3 - 2 * t2 + t)) * key(i, 2) +
              (3 * t2 - 2 * t3) * key(next, 1) + (span * (t3 - t2)) * key(next, 0);
    } else if (target == CurveTarget::rotation) {
      value = slerp(key(i, 1), key(next, 1), t);
    } else {
      value = key(i, 1) + t * (key(next, 1) - key(i, 1));
    }
  }
  if (target == CurveTarget::rotation) {
    const double length = value.norm();
    value = length > 0.0 ? VectorXd(value / length) : VectorXd(Vec4(0, 0, 0, 1));
  }
  return {value.data(), value.data() + value.size()};
}

double Clip::start_time() const {
  double start = 0.0;
  bool any = false;
  for (const Curve& curve : curves) {
    if (curve.times.empty()) continue;
    start = any ? std::min(start, curve.times.front()) : curve.times.front();
    any = true;
  }
  return start;
}

double Clip::end_time() const {
  double end = 0.0;
  for (const Curve& curve : curves) {
    if (!curve.times.empty()) end = std::max(end, curve.times.back());
  }
  return end;
}

int Clip::frame_count() const {
  const Curve* curve = busiest_curve(*this);
  return curve == nullptr ? 0 : static_cast<int>(curve->times.size());
}

double Clip::frame_time(int frame) const {
  if (frame < 0 || frame >= frame_count()) {
    throw_invalid_argument(
        "frame " + std::to_string(frame) + " is not there: the clip has " +
        (frame_count() == 0 ? std::string("no frame") : "frames 0 to " + std::to_string(frame_count() - 1)));
  }
  return busiest_curve(*this)->times[static_cast<std::size_t>(frame)];
}

Pose sample_pose(const Clip& clip, double time, const Pose& base) {
  Pose pose = base;
  for (const Curve& curve : clip.curves) {
    if (curve.target == CurveTarget::weights) continue;
    if (curve.joint < 0 || curve.joint >= std::ssize(pose.local)) {
      throw_invalid_argument("sample_pose: a curve moves joint " + std::to_string(curve.joint) + " of " +
                             std::to_string(pose.local.size()));
    }
    const std::vector<double> v = curve.sample(time);
    Transform& local = pose.local[static_cast<std::size_t>(curve.joint)];
    switch (curve.target) {
      case CurveTarget::translation:
        local.translation = Vec3(v[0], v[1], v[2]);
        break;
      case CurveTarget::rotation:
        local.rotation = Quat(v[3], v[0], v[1], v[2]);
        break;
      case CurveTarget::scale:
        local.scale = Vec3(v[0], v[1], v[2]);
        break;
      case CurveTarget::weights:
        break;
    }
  }
  return pose;
}

std::vector<float> sample_weights(const Clip& clip, double time, int part, const std::vector<float>& base) {
  for (const Curve& curve : clip.curves) {
    if (curve.target != CurveTarget::weights || curve.joint != part || curve.width != std::ssize(base)) continue;
    const std::vector<double> v = curve.sample(time);
    return {v.begin(), v.end()};
  }
  return base;
}

}  // namespace croquis
