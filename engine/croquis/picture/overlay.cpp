// SPDX-License-Identifier: MIT
#include "croquis/picture/overlay.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "croquis/picture/scene.h"

namespace croquis {
namespace {

/// Lengths in ink and bones grow with the picture, so that a large print is the same drawing.
double picture_scale(const Camera& camera) {
  return std::sqrt(static_cast<double>(camera.width_px) * camera.height_px) / 1024.0;
}

/// Samples without the ones that repeat their predecessor.
std::vector<StrokeSample> distinct_samples(const Stroke& stroke) {
  std::vector<StrokeSample> samples;
  for (const StrokeSample& sample : stroke.samples) {
    if (!sample.position.allFinite() || !std::isfinite(sample.pressure)) continue;
    if (samples.empty() || (sample.position - samples.back().position).norm() > 1e-6) samples.push_back(sample);
  }
  return samples;
}

/// Pressure without the trembling of the device: a binomial filter, a few times over.
void smooth_pressure(std::vector<StrokeSample>& samples) {
  for (int pass = 0; pass < 4 && samples.size() > 2; ++pass) {
    double before = samples[0].pressure;
    for (std::size_t i = 1; i + 1 < samples.size(); ++i) {
      const double own = samples[i].pressure;
      samples[i].pressure = 0.25 * before + 0.5 * own + 0.25 * samples[i + 1].pressure;
      before = own;
    }
  }
}

/// Centripetal Catmull-Rom through b and c: no loops or overshoot between unevenly spaced samples.
Vec2 curve_point(const std::array<Vec2, 4>& p, double part) {
  std::array<double, 4> knot{};
  for (std::size_t i = 1; i < 4; ++i) knot[i] = knot[i - 1] + std::sqrt(std::max((p[i] - p[i - 1]).norm(), 1e-9));
  const double t = knot[1] + part * (knot[2] - knot[1]);
  const auto mix = [&](const Vec2& a, const Vec2& b, std::size_t i, std::size_t j) {
    return Vec2(a + (t - knot[i]) / (knot[j] - knot[i]) * (b - a));
  };
  const Vec2 a1 = mix(p[0], p[1], 0, 1), a2 = mix(p[1], p[2], 1, 2), a3 = mix(p[2], p[3], 2, 3);
  const Vec2 b1 = mix(a1, a2, 0, 2), b2 = mix(a2, a3, 1, 3);
  return mix(b1, b2, 1, 2);
}

struct BonePiece {
  Vec2 from, to;
  double depth;
  int side;
};

const std::array<unsigned, 3> kSideColors{0xC8432F, 0xD9A227, 0x2F6CB3};  // right, middle, left

unsigned side_color(int side) { return kSideColors[static_cast<std::size_t>(side + 1)]; }

/// The colour mixed with black (t < 0) or white (t > 0).
Paint tinted(unsigned color, float t, float opacity) {
  Paint paint = make_paint(color, opacity);
  paint.color = t < 0.0F ? Vec3f(paint.color * (1.0F + t)) : Vec3f(paint.color + t * (Vec3f::Ones() - paint.color));
  return paint;
}

/// An octahedron seen from the side: a kite, widest near its start, one face in the light and one in the shade.
void paint_bone(Canvas& canvas, const BonePiece& bone, double scale) {
  const Vec2 axis = bone.to - bone.from;
  const double length = axis.norm();
  const Paint line = tinted(side_color(bone.side), -0.75F, 0.95F);
  const double line_width = 1.3 * std::max(scale, 0.6);
  if (length < 3.0 * scale) return;
  const Vec2 along = axis / length;
  const Vec2 across(-along.y(), along.x());
  const double half = std::clamp(0.085 * length, 1.2 * scale, 9.0 * scale);
  const Vec2 waist = bone.from + std::min(0.18 * length, 2.0 * half) * along;
  const Vec2 lit = waist - half * (across.y() > 0.0 ? 1.0 : -1.0) * across;
  const Vec2 shaded = waist + half * (across.y() > 0.0 ? 1.0 : -1.0) * across;
  const Paint none = make_paint(0, 0.0F);
  paint_polygon(canvas, std::array{bone.from, lit, bone.to}, tinted(side_color(bone.side), 0.35F, 0.8F), none, 0.0);
  paint_polygon(canvas, std::array{bone.from, shaded, bone.to}, tinted(side_color(bone.side), -0.1F, 0.8F), none, 0.0);
  paint_polygon(canvas, std::array{bone.from, lit, bone.to, shaded}, none, line, line_width);
}

void paint_joint(Canvas& canvas, const Vec2& at, int side, double scale) {
  const std::array<Disc, 1> rim{{{at, 3.4 * scale}}};
  const std::array<Disc, 1> dot{{{at, 2.2 * scale}}};
  paint_sweep(canvas, rim, tinted(side_color(side), -0.75F, 0.95F));
  paint_sweep(canvas, dot, tinted(side_color(side), 0.7F, 1.0F));
}

}  // namespace

std::vector<Disc> make_ink_path(const Stroke& stroke, double size) {
  std::vector<StrokeSample> samples = distinct_samples(stroke);
  smooth_pressure(samples);
  std::vector<Disc> path;
  const auto radius = [&](double pressure) { return size * (0.4 + 1.2 * std::clamp(pressure, 0.0, 1.0)); };
  for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
    const std::array<Vec2, 4> around{
        i > 0 ? samples[i - 1].position : Vec2(2.0 * samples[i].position - samples[i + 1].position),
        samples[i].position, samples[i + 1].position,
        i + 2 < samples.size() ? samples[i + 2].position : Vec2(2.0 * samples[i + 1].position - samples[i].position)};
    const double length = (around[2] - around[1]).norm();
    const int steps = std::clamp(static_cast<int>(std::ceil(length / std::max(0.6 * size, 0.5))), 1, 4096);
    for (int k = 0; k < steps; ++k) {
      const double t = static_cast<double>(k) / steps;
      const Vec2 straight = around[1] + t * (around[2] - around[1]);
      const double pressure = (1.0 - t) * samples[i].pressure + t * samples[i + 1].pressure;
      path.push_back({stroke.raw_pen ? curve_point(around, t) : straight, radius(pressure)});
    }
  }
  if (!samples.empty()) path.push_back({samples.back().position, radius(samples.back().pressure)});

  std::vector<double> arc(path.size(), 0.0);
  for (std::size_t i = 1; i < path.size(); ++i) arc[i] = arc[i - 1] + (path[i].centre - path[i - 1].centre).norm();
  const double taper = arc.empty() ? 0.0 : std::min(0.22 * arc.back(), 24.0 * size);
  if (!(taper > 0.0)) return path;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const auto grown = [&](double distance, double at_end) {
      const double t = std::clamp(distance / taper, 0.0, 1.0);
      return at_end + (1.0 - at_end) * t * (2.0 - t);
    };
    path[i].radius *= grown(arc[i], 0.5) * grown(arc.back() - arc[i], 0.22);
  }
  return path;
}

void paint_strokes(Canvas& canvas, const std::vector<Stroke>& strokes, const Camera& camera) {
  const double size = 3.8 * std::max(picture_scale(camera), 0.3);
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    paint_sweep(canvas, make_ink_path(strokes[i], size), make_paint(i == 0 ? 0x8A2B1E : 0x1F3864, 0.93F));
  }
}

void paint_skeletons(Canvas& canvas, const std::vector<PictureActor>& actors, const Camera& camera) {
  const double scale = std::max(picture_scale(camera), 0.35);
  const Affine view = camera.view_from_world();
  std::vector<BonePiece> bones;
  for (const PictureActor& actor : actors) {
    const Skeleton& skeleton = actor.character->skeleton;
    const std::vector<Vec3> positions = compute_positions(skeleton, *actor.pose);
    const std::vector<int> sides = compute_sides(*actor.character);
    for (int j = 0; j < skeleton.joint_count(); ++j) {
      const int parent = skeleton.parent(j);
      if (skeleton.joint(j).helper) continue;
      const bool is_bone = parent >= 0 && !skeleton.joint(parent).helper;
      const Vec3& end = positions[static_cast<std::size_t>(j)];
      const Vec3& start = is_bone ? positions[static_cast<std::size_t>(parent)] : end;
      const std::optional<Vec2> from = camera.project(start);
      const std::optional<Vec2> to = camera.project(end);
      if (!from || !to) continue;
      bones.push_back({*from, *to, -(view * Vec3(0.5 * (start + end))).z(), sides[static_cast<std::size_t>(j)]});
    }
  }
  std::stable_sort(bones.begin(), bones.end(),
                   [](const BonePiece& a, const BonePiece& b) { return a.depth > b.depth; });
  for (const BonePiece& bone : bones) paint_bone(canvas, bone, scale);
  for (const BonePiece& bone : bones) paint_joint(canvas, bone.to, bone.side, scale);
}

}  // namespace croquis
