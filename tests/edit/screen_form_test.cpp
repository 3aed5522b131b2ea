// SPDX-License-Identifier: MIT
#include "croquis/edit/screen_form.h"

#include <cmath>

#include <gtest/gtest.h>

#include "croquis/base/error.h"
#include "croquis/edit/commands.h"

namespace croquis {
namespace {

/// A cat whose joints are all turned, so that its back twists and its neck bends.
Actor turned_cat(double angle) {
  Actor cat = add_builtin_character({}, "cat").actors.front();
  for (Transform& local : cat.pose.local) {
    local.rotation = local.rotation * Quat(Eigen::AngleAxisd(angle, Vec3(0.2, 0.1, 1.0).normalized()));
  }
  return cat;
}

using Row = Eigen::Map<const Vec4f>;

/// What the vertex shader does, in its own words: rows blended, then the rigid motions, signs as the heaviest says.
Vec3f blend(const std::vector<float>& palette, const Skin& skin, int vertex, const Vec3f& at, bool dual) {
  const auto texel = [&](int entry, int column) {
    return Row(&palette[static_cast<std::size_t>(kScreenEntry * entry + 4 * column)]);
  };
  const auto slot = [&](int k) { return static_cast<std::size_t>(vertex * skin.influences + k); };
  int heaviest = 0;
  for (int k = 1; k < skin.influences; ++k) {
    if (skin.weights[slot(k)] > skin.weights[slot(heaviest)]) heaviest = k;
  }
  Vec4f rows[3] = {Vec4f::Zero(), Vec4f::Zero(), Vec4f::Zero()}, real = Vec4f::Zero(), moved = Vec4f::Zero();
  const Vec4f pivot = texel(skin.joint_indices[slot(heaviest)], 3);
  for (int k = 0; k < skin.influences; ++k) {
    const int entry = skin.joint_indices[slot(k)];
    const float weight = skin.weights[slot(k)];
    for (int row = 0; row < 3; ++row) rows[row] += weight * texel(entry, row);
    const float sign = texel(entry, 3).dot(pivot) < 0.0F ? -weight : weight;
    real += sign * texel(entry, 3);
    moved += sign * texel(entry, 4);
  }
  const Vec4f bound(at.x(), at.y(), at.z(), 1.0F);
  Vec3f p(rows[0].dot(bound), rows[1].dot(bound), rows[2].dot(bound));
  if (!dual) return p;
  const float length = real.norm();
  real /= length;
  moved /= length;
  const Vec3f r = real.head<3>(), d = moved.head<3>();
  p += 2.0F * r.cross(Vec3f(r.cross(p) + real.w() * p));
  return p + 2.0F * (real.w() * d - moved.w() * r + r.cross(d));
}

void expect_same_vertices(const Actor& actor, SkinningMethod method) {
  const Part& part = actor.character->parts.front();
  const std::vector<float> palette = make_screen_palette(actor, method);
  const std::vector<float> vertices = make_screen_vertices(actor, 0, method);
  ASSERT_EQ(vertices.size(), 3 * part.mesh.positions.size());
  float worst = 0.0F;
  for (int v = 0; v < part.mesh.vertex_count(); ++v) {
    const Vec3f at = blend(palette, *part.skin, v, part.mesh.positions[static_cast<std::size_t>(v)],
                           method == SkinningMethod::dual_quaternion);
    worst = std::max(worst, (at - Eigen::Map<const Vec3f>(&vertices[static_cast<std::size_t>(3 * v)])).norm());
  }
  EXPECT_LT(worst, 1e-5F);
}

TEST(ScreenForm, ThePaletteHasAnEntryForEveryJointOfEveryPartAndAPlaceForEveryJoint) {
  const Actor cat = turned_cat(0.0);
  std::size_t entries = 0;
  for (const Part& part : cat.character->parts) entries += part.skin ? part.skin->joints.size() : 1;
  EXPECT_EQ(make_screen_palette(cat, SkinningMethod::linear).size(), kScreenEntry * entries);
  EXPECT_EQ(make_screen_palette(cat, SkinningMethod::dual_quaternion).size(), kScreenEntry * entries);
  EXPECT_EQ(make_screen_joints(cat).size(), 3 * cat.pose.local.size());
}

TEST(ScreenForm, BlendedAsItSaysItGivesTheEnginesVertices) {
  for (const double angle : {0.05, 0.4, -1.1}) {
    const Actor cat = turned_cat(angle);
    expect_same_vertices(cat, SkinningMethod::linear);
    expect_same_vertices(cat, SkinningMethod::dual_quaternion);
  }
}

TEST(ScreenForm, AStretchedJointIsBlendedBeforeItTurns) {
  Actor cat = turned_cat(0.5);
  cat.pose.local[3].scale = Vec3(1.0, 1.4, 0.8);
  expect_same_vertices(cat, SkinningMethod::dual_quaternion);
}

TEST(ScreenForm, TheMethodsDifferWhereABodyTwists) {
  const Actor cat = turned_cat(0.6);
  const std::vector<float> linear = make_screen_vertices(cat, 0, SkinningMethod::linear);
  const std::vector<float> dual = make_screen_vertices(cat, 0, SkinningMethod::dual_quaternion);
  float most = 0.0F;
  for (std::size_t i = 0; i < linear.size(); ++i) most = std::max(most, std::abs(linear[i] - dual[i]));
  EXPECT_GT(most, 1e-4F);
}

TEST(ScreenForm, APartThatIsNotThereIsRefused) {
  EXPECT_THROW((void)make_screen_vertices(turned_cat(0.0), 9, SkinningMethod::linear), Error);
}

}  // namespace
}  // namespace croquis
