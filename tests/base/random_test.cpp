// SPDX-License-Identifier: MIT
#include "croquis/base/random.h"

#include <cmath>

#include <gtest/gtest.h>

namespace croquis {
namespace {

TEST(Random, TheSameSeedGivesTheSameNumbersEverywhere) {
  Random random(42);
  EXPECT_EQ(random.bits(), 13679457532755275413ULL);
  EXPECT_EQ(random.bits(), 2949826092126892291ULL);
}

TEST(Random, NumbersHaveTheMomentsTheyPromise) {
  Random random(7);
  double sum = 0.0, normal_sum = 0.0, normal_squares = 0.0;
  constexpr int kCount = 20000;
  for (int i = 0; i < kCount; ++i) {
    const double u = random.uniform(), n = random.normal();
    ASSERT_GE(u, 0.0);
    ASSERT_LT(u, 1.0);
    sum += u;
    normal_sum += n;
    normal_squares += n * n;
    const int index = random.index(3);
    ASSERT_TRUE(index >= 0 && index < 3);
  }
  EXPECT_NEAR(sum / kCount, 0.5, 0.01);
  EXPECT_NEAR(normal_sum / kCount, 0.0, 0.03);
  EXPECT_NEAR(normal_squares / kCount, 1.0, 0.05);
}

}  // namespace
}  // namespace croquis
