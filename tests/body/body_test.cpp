// SPDX-License-Identifier: MIT
#include "croquis/body/body.h"

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

}  // namespace
}  // namespace croquis
