// SPDX-License-Identifier: MIT
#include "loa/measures.h"

#include <algorithm>
#include <cmath>

namespace croquis::loa {

Measure measure(const Draw& draw, const Pose& answer) {
  const Skeleton& skeleton = draw.clip->character.skeleton;
  const std::vector<Vec3> truth = compute_positions(skeleton, draw.truth), found = compute_positions(skeleton, answer);
  const double height = draw.clip->height;
  const int hips = draw.clip->character.humanoid.joint(HumanoidBone::hips);
  const double per_height = height / draw.camera.units_per_pixel(truth[static_cast<std::size_t>(hips)]);

  std::vector<Vec2> a, b;
  std::vector<Vec3> p, q;
  Vec3 mean_p = Vec3::Zero(), mean_q = Vec3::Zero();
  for (const int joint : draw.line.joints) {
    p.push_back(truth[static_cast<std::size_t>(joint)]);
    q.push_back(found[static_cast<std::size_t>(joint)]);
    mean_p += p.back();
    mean_q += q.back();
    a.push_back(*draw.camera.project(p.back()));
    // A joint behind the camera counts as lying at the corner of the picture.
    b.push_back(draw.camera.project(q.back()).value_or(Vec2::Zero()));
  }
  const auto joints = static_cast<double>(a.size());
  mean_p /= joints;
  mean_q /= joints;

  Measure result;
  int bones = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    result.e2d += 100.0 * (a[i] - b[i]).norm() / per_height / joints;
    result.e3d += 100.0 * ((p[i] - mean_p) - (q[i] - mean_q)).norm() / height / joints;
    if (i == 0) continue;
    const Vec2 bone = a[i] - a[i - 1], other = b[i] - b[i - 1];
    if (bone.norm() < 0.02 * per_height) continue;
    ++bones;
    result.tangent += other.norm() > 0.0
                          ? std::acos(std::clamp(bone.normalized().dot(other.normalized()), -1.0, 1.0)) / kDegree
                          : 90.0;
  }
  if (bones > 0) result.tangent /= bones;

  const Polyline2 chain(b);
  double there = 0.0, back = 0.0;
  const std::vector<Vec2> points = chain.resampled(96);
  for (const Vec2& point : points) there += (draw.stroke.at(draw.stroke.nearest(point)) - point).norm() / 96.0;
  for (const Vec2& point : draw.stroke.points()) {
    back += (chain.at(chain.nearest(point)) - point).norm() / static_cast<double>(draw.stroke.points().size());
  }
  result.fit = 100.0 * 0.5 * (there + back) / per_height;
  result.drift = bone_length_drift(skeleton, draw.start, answer);
  return result;
}

Summary summarise(std::vector<double> values) {
  Summary summary;
  if (values.empty()) return summary;
  for (const double value : values) summary.mean += value / static_cast<double>(values.size());
  const auto at = [&](double part) {
    const auto index = static_cast<std::ptrdiff_t>(part * static_cast<double>(values.size() - 1) + 0.5);
    std::nth_element(values.begin(), values.begin() + index, values.end());
    return values[static_cast<std::size_t>(index)];
  };
  summary.median = at(0.5);
  summary.p90 = at(0.9);
  summary.p95 = at(0.95);
  return summary;
}

}  // namespace croquis::loa
