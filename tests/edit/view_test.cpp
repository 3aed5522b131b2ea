// SPDX-License-Identifier: MIT
#include "croquis/edit/view.h"

#include "edit/figures.h"

#include <gtest/gtest.h>

#include "croquis/base/error.h"

namespace croquis {
namespace {

/// A stalk with a unit triangle around its second joint, skinned to it.
Character leafy_stalk() {
  Character character = stalk(2);
  Part part;
  part.name = "leaf";
  part.mesh.positions = {Vec3f(-1, 2, 0), Vec3f(1, 2, 0), Vec3f(0, 3, 0)};
  part.mesh.triangles = {0, 1, 2};
  Skin skin;
  skin.joints = {2};
  skin.inverse_bind = {character.skeleton.rest_model(2).inverse()};
  skin.influences = 1;
  skin.joint_indices = {0, 0, 0};
  skin.weights = {1, 1, 1};
  part.skin = skin;
  character.parts.push_back(part);
  character.check();
  return character;
}

TEST(PosedBox, HoldsBonesAndSkinnedVertices) {
  const Character character = leafy_stalk();
  const Box box = posed_box(character, character.start);
  EXPECT_NEAR(box.min().y(), 0.0, 1e-6);
  EXPECT_NEAR(box.max().y(), 3.0, 1e-6);
  EXPECT_NEAR(box.max().x(), 1.0, 1e-6);
}

TEST(PosedBox, FollowsThePose) {
  const Character character = leafy_stalk();
  Pose pose = character.start;
  pose.local[1].translation = Vec3(5, 1, 0);
  EXPECT_NEAR(posed_box(character, pose).max().x(), 6.0, 1e-6);
}

TEST(NamedView, ShowsEveryActorWithAMargin) {
  const auto character = std::make_shared<const Character>(leafy_stalk());
  Pose aside = character->start;
  aside.local[0].translation = Vec3(4, 0, 0);
  const std::vector<Actor> actors{{character, character->start}, {character, aside}};
  for (const View view : all_views()) {
    const Camera camera = make_named_view(actors, view, 400, 300);
    for (const Actor& actor : actors) {
      const Box box = posed_box(*actor.character, actor.pose);
      for (int corner = 0; corner < 8; ++corner) {
        const auto pixel = camera.project(box.corner(static_cast<Box::CornerType>(corner)));
        ASSERT_TRUE(pixel.has_value());
        EXPECT_GE(pixel->x(), 40 - 1e-6) << to_string(view);
        EXPECT_LE(pixel->x(), 360 + 1e-6) << to_string(view);
        EXPECT_GE(pixel->y(), 30 - 1e-6) << to_string(view);
        EXPECT_LE(pixel->y(), 270 + 1e-6) << to_string(view);
      }
    }
  }
}

TEST(NamedView, LooksAtTheCharactersOwnFront) {
  Character character = stalk(2);
  character.front = -Vec3::UnitZ();
  const auto shared = std::make_shared<const Character>(character);
  EXPECT_GT(make_named_view({{shared, shared->start}}, View::front, 100, 100).forward().z(), 0.99);
}

TEST(NamedView, NeedsAnActor) { EXPECT_THROW((void)make_named_view({}, View::front, 100, 100), Error); }

}  // namespace
}  // namespace croquis
