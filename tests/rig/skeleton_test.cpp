// SPDX-License-Identifier: MIT
#include "croquis/rig/skeleton.h"

#include <functional>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "croquis/base/error.h"

namespace croquis {
namespace {

Joint joint(const std::string& name, int parent) { return {name, parent, Transform{Vec3(0, 1, 0)}}; }

/// hips(0) - spine(1) - head(2), hips - leg(3) - foot(4), and a second "leg"(5) under the hips.
Skeleton small_body() {
  return Skeleton(
      {joint("hips", -1), joint("spine", 0), joint("head", 1), joint("leg", 0), joint("foot", 3), joint("leg", 0)});
}

std::string message_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(Skeleton, PathsClimbAndDescend) {
  const Skeleton body = small_body();
  EXPECT_EQ(body.path(4, 2), (std::vector<int>{4, 3, 0, 1, 2}));
  EXPECT_EQ(body.path(0, 4), (std::vector<int>{0, 3, 4}));
  EXPECT_EQ(body.path(2, 2), (std::vector<int>{2}));
  EXPECT_TRUE(body.is_ancestor(0, 4));
  EXPECT_TRUE(body.is_ancestor(4, 4));
  EXPECT_FALSE(body.is_ancestor(1, 4));
}

TEST(Skeleton, RestPositionsAddUp) { EXPECT_TRUE(small_body().rest_position(4).isApprox(Vec3(0, 3, 0))); }

TEST(Skeleton, NamesAreResolvedOrRefusedInWords) {
  const Skeleton body = small_body();
  EXPECT_EQ(body.resolve("head"), 2);
  EXPECT_EQ(body.resolve("#5"), 5);
  EXPECT_EQ(body.reference(2), "head");
  EXPECT_EQ(body.reference(3), "#3");
  EXPECT_NE(message_of([&] { static_cast<void>(body.resolve("leg")); }).find("#3, #5"), std::string::npos);
  EXPECT_NE(message_of([&] { static_cast<void>(body.resolve("spinw")); }).find("'spine'"), std::string::npos);
  EXPECT_NE(message_of([&] { static_cast<void>(body.resolve("#6")); }).find("#5"), std::string::npos);
}

TEST(Skeleton, BadTreesAreRefused) {
  EXPECT_THROW(Skeleton({}), Error);
  EXPECT_THROW(Skeleton({joint("a", 0)}), Error);
  EXPECT_THROW(Skeleton({joint("a", -1), joint("b", -1)}), Error);
  EXPECT_THROW(Skeleton({joint("a", -1), joint("b", 1)}), Error);
  Joint broken = joint("a", -1);
  broken.rest.translation.x() = std::numeric_limits<double>::infinity();
  EXPECT_THROW(Skeleton({broken}), Error);
}

}  // namespace
}  // namespace croquis
