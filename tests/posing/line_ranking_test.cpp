// SPDX-License-Identifier: MIT
#include "croquis/posing/line_ranking.h"

#include "support/test_rigs.h"

#include <gtest/gtest.h>

#include "croquis/base/error.h"
#include "croquis/posing/extract_line.h"

namespace croquis {
namespace {

TEST(LineRanking, AStrokeNearALineMeansThatLine) {
  Random random(6);
  int right = 0, rounds = 0;
  for (const bool reversed : {false, true}) {
    const Skeleton skeleton = make_test_humanoid(5);
    const HumanoidMap humanoid = recognise_humanoid(skeleton);
    const std::vector<BodyLine> lines = standard_body_lines(skeleton, humanoid);
    ASSERT_GT(lines.size(), 8U);
    for (const BodyLine& line : lines) {
      const Pose meant = random_pose(skeleton, random, 0.15);
      std::vector<Vec2> points = extract_line(skeleton, meant, line, Camera{}).points();
      if (reversed) std::reverse(points.begin(), points.end());
      const auto found = rank_body_lines(skeleton, humanoid, rest_pose(skeleton), lines, Polyline2(points), Camera{});
      ASSERT_FALSE(found.empty());
      for (std::size_t i = 1; i < found.size(); ++i) EXPECT_LE(found[i - 1].cost, found[i].cost);
      ++rounds;
      if (found.front().line.name == line.name && found.front().forward != reversed) ++right;
    }
  }
  EXPECT_GE(right, rounds * 9 / 10) << rounds;
}

TEST(LineRanking, NothingToChooseFromIsRefused) {
  const Skeleton skeleton = make_test_humanoid();
  const Polyline2 stroke({Vec2(0, 0), Vec2(100, 100)});
  EXPECT_THROW((void)rank_body_lines(skeleton, {}, rest_pose(skeleton), {}, stroke, Camera{}), Error);
}

}  // namespace
}  // namespace croquis
