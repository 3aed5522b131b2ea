// SPDX-License-Identifier: MIT
#include "croquis/math/polyline.h"

#include <limits>

#include <gtest/gtest.h>

#include "croquis/base/error.h"

namespace croquis {
namespace {

const Polyline2 kCorner({Vec2(0, 0), Vec2(3, 0), Vec2(3, 0), Vec2(3, 4)});

TEST(Polyline, IsAddressedByArcLength) {
  EXPECT_DOUBLE_EQ(kCorner.length(), 7.0);
  EXPECT_TRUE(kCorner.at(5.0).isApprox(Vec2(3, 2)));
  EXPECT_TRUE(kCorner.at(-1.0).isApprox(Vec2(0, 0)));
  EXPECT_TRUE(kCorner.at(99.0).isApprox(Vec2(3, 4)));
  EXPECT_TRUE(kCorner.tangent(1.0).isApprox(Vec2(1, 0)));
  EXPECT_TRUE(kCorner.tangent(3.0).isApprox(Vec2(0, 1)));
  EXPECT_TRUE(kCorner.tangent(7.0).isApprox(Vec2(0, 1)));
}

TEST(Polyline, FindsTheNearestPoint) {
  EXPECT_DOUBLE_EQ(kCorner.nearest(Vec2(1, -2)), 1.0);
  EXPECT_DOUBLE_EQ(kCorner.nearest(Vec2(9, 9)), 7.0);
}

TEST(Polyline, ResamplingKeepsEndsAndSpacing) {
  const auto points = kCorner.resampled(8);
  ASSERT_EQ(points.size(), 8U);
  EXPECT_TRUE(points.front().isApprox(Vec2(0, 0)));
  EXPECT_TRUE(points.back().isApprox(Vec2(3, 4)));
  EXPECT_TRUE(points[3].isApprox(Vec2(3, 0)));
}

TEST(Polyline, DegenerateLinesAreHandled) {
  const Polyline2 dot({Vec2(1, 2)});
  EXPECT_EQ(dot.length(), 0.0);
  EXPECT_TRUE(dot.at(0.5).isApprox(Vec2(1, 2)));
  EXPECT_TRUE(dot.tangent(0.0).isZero());
  EXPECT_THROW(Polyline2({}), Error);
  EXPECT_THROW(Polyline2({Vec2(0, std::numeric_limits<double>::quiet_NaN())}), Error);
  EXPECT_THROW(static_cast<void>(dot.resampled(1)), Error);
}

}  // namespace
}  // namespace croquis
