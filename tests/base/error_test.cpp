// SPDX-License-Identifier: MIT
#include "croquis/base/error.h"

#include <gtest/gtest.h>

namespace croquis {
namespace {

TEST(Error, CarriesItsCodeAndAPlace) {
  try {
    throw_bad_file("/nodes/3", "wanted a number");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::bad_file);
    EXPECT_STREQ(error.what(), "/nodes/3: wanted a number");
  }
}

TEST(Error, EveryCodeHasAName) {
  EXPECT_EQ(to_string(ErrorCode::invalid_argument), "invalid_argument");
  EXPECT_EQ(to_string(ErrorCode::unsupported), "unsupported");
}

}  // namespace
}  // namespace croquis
