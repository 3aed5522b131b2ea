// SPDX-License-Identifier: MIT
#include "croquis/body/body.h"

#include "body/body_checks.h"

#include <gtest/gtest.h>

#include "croquis/base/error.h"

namespace croquis {
namespace {

TEST(BuiltinCharacter, IsFoundByName) {
  for (const std::string& name : builtin_character_names()) EXPECT_TRUE(is_builtin_character(name));
  EXPECT_FALSE(is_builtin_character("unicorn"));
  EXPECT_FALSE(is_builtin_character(""));
}

TEST(BuiltinCharacter, OfUnknownNameIsRefusedWithTheNamesThereAre) {
  try {
    static_cast<void>(make_builtin_character("unicorn"));
    FAIL() << "wanted an Error";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::invalid_argument);
    EXPECT_NE(std::string(error.what()).find("mannequin"), std::string::npos);
  }
}

TEST(BuiltinCharacter, RefusesProportionsOutOfRangeByName) {
  Proportions proportions;
  proportions.heads = 2.0;
  EXPECT_THROW(static_cast<void>(make_builtin_character("mannequin", proportions)), Error);
  proportions = {};
  proportions.muscle = std::nan("");
  try {
    static_cast<void>(make_builtin_character("mannequin", proportions));
    FAIL() << "wanted an Error";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("muscle"), std::string::npos);
  }
}

void expect_sound(const std::string& name, const Proportions& proportions) {
  const Character character = make_builtin_character(name, proportions);
  EXPECT_NO_THROW(character.check());
  for (const Part& part : character.parts) {
    const MeshFacts facts = examine(part.mesh);
    EXPECT_EQ(facts.loose_edges, 0) << name << " " << part.name;
    EXPECT_EQ(facts.euler, part.name == "leaves" ? facts.euler : 2) << name << " " << part.name;
    EXPECT_GT(facts.smallest_angle_degrees, 20.0) << name << " " << part.name;
    EXPECT_LT(facts.odd_normals, part.mesh.triangle_count() / 50) << name << " " << part.name;
  }
}

TEST(BuiltinCharacter, IsAClosedSurfaceOfGoodTrianglesWhateverItIs) {
  for (const char* name : {"cat", "snake", "tree"}) expect_sound(name, {});
}

TEST(BuiltinCharacter, IsSoundAtTheEndsOfItsProportions) {
  expect_sound("mannequin",
               {.heads = 3.0, .hips = 0.6, .limbs = 0.7, .hands = 1.8, .head = 1.6, .muscle = 1.6});  // all is near all
  expect_sound("mannequin",
               {.heads = 9.0, .shoulders = 1.6, .hips = 1.6, .limbs = 1.4, .hands = 0.6, .head = 0.7, .muscle = 0.6});
  for (const char* name : {"cat", "snake", "tree"}) expect_sound(name, {.limbs = 1.4, .muscle = 0.6});
}

}  // namespace
}  // namespace croquis
