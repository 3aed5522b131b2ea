// SPDX-License-Identifier: MIT
#include "croquis/rig/body_line.h"

#include "support/random_math.h"
#include <algorithm>
#include <functional>
#include <string>

#include <gtest/gtest.h>

#include "croquis/base/error.h"

namespace croquis {
namespace {

Joint joint(const std::string& name, int parent, double y = 1.0, bool helper = false) {
  return {name, parent, Transform{Vec3(0, y, 0)}, helper};
}

/// 0 hips, 1 spine, 2 chest, 3 head; 4 armL, 5 handL, 6 armR, 7 handR under chest; 8 legL, 9 footL, 10 legR, 11 footR.
Skeleton body() {
  return Skeleton({joint("hips", -1), joint("spine", 0), joint("chest", 1), joint("head", 2), joint("armL", 2),
                   joint("handL", 4), joint("armR", 2), joint("handR", 6), joint("legL", 0), joint("footL", 8),
                   joint("legR", 0), joint("footR", 10)});
}

using Segments = std::vector<SkeletonSegment>;

Segments select(std::vector<int> joints) { return segments_of_selection(body(), joints); }
std::vector<int> line(std::vector<int> joints) { return make_body_line(body(), joints).joints; }

std::string message_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(SegmentsOfSelection, AnArmIsOneSegment) { EXPECT_EQ(select({5, 4, 2}), (Segments{{2, 4, 5}})); }

TEST(SegmentsOfSelection, BothLegsThroughTheHipsAreTwoSegmentsFromTheirRoot) {
  EXPECT_EQ(select({0, 8, 9, 10, 11}), (Segments{{0, 8, 9}, {0, 10, 11}}));
}

TEST(SegmentsOfSelection, ATShapeIsAllowedWhereItsCentreIsARoot) {
  EXPECT_EQ(select({2, 3, 4, 5, 6, 7}), (Segments{{2, 3}, {2, 4, 5}, {2, 6, 7}}));
}

TEST(SegmentsOfSelection, SeparateChainsAreSeparateSegments) {
  EXPECT_EQ(select({9, 8, 2, 3}), (Segments{{2, 3}, {8, 9}}));
}

TEST(SegmentsOfSelection, TheSameJointTwiceCountsOnce) { EXPECT_EQ(select({2, 3, 3, 2}), (Segments{{2, 3}})); }

TEST(SegmentsOfSelection, AForkThatIsNoRootIsRefusedByName) {
  const std::string message = message_of([] { select({1, 2, 3, 4}); });
  EXPECT_NE(message.find("'chest'"), std::string::npos) << message;
  EXPECT_NE(message.find("'head'"), std::string::npos) << message;
}

TEST(SegmentsOfSelection, ALoneJointIsRefusedByName) {
  EXPECT_NE(message_of([] { select({2, 3, 11}); }).find("'footR'"), std::string::npos);
  EXPECT_NE(message_of([] { select({9, 11}); }).find("'footL'"), std::string::npos);
}

TEST(SegmentsOfSelection, NothingAndJointsThatAreNotThereAreRefused) {
  EXPECT_THROW(select({}), Error);
  EXPECT_THROW(select({0, 12}), Error);
  EXPECT_THROW(select({-1, 0}), Error);
}

TEST(SegmentsOfSelection, SegmentsHoldExactlyTheSelectionOfRandomTrees) {
  Random random(11);
  int valid = 0;
  for (int round = 0; round < 300; ++round) {
    std::vector<Joint> joints{joint("j0", -1)};
    for (int i = 1; i < 14; ++i)
      joints.push_back(joint("j" + std::to_string(i), static_cast<int>(random.uniform() * i)));
    const Skeleton skeleton(joints);
    std::vector<int> selection;
    for (int i = 0; i < 14; ++i) {
      if (random.uniform() < 0.6) selection.push_back(i);
    }
    Segments segments;
    try {
      segments = segments_of_selection(skeleton, selection);
    } catch (const Error&) {
      continue;
    }
    ++valid;
    std::vector<int> covered;
    for (const SkeletonSegment& segment : segments) {
      ASSERT_GE(segment.size(), 2U);
      for (std::size_t i = 1; i < segment.size(); ++i) ASSERT_EQ(skeleton.parent(segment[i]), segment[i - 1]);
      covered.insert(covered.end(), segment.begin(), segment.end());
    }
    std::sort(covered.begin(), covered.end());
    covered.erase(std::unique(covered.begin(), covered.end()), covered.end());
    ASSERT_EQ(covered, selection);
  }
  EXPECT_GT(valid, 5);
}

TEST(MakeBodyLine, FillsTheGapsAndPassesTheRoot) {
  EXPECT_EQ(line({9, 3}), (std::vector<int>{9, 8, 0, 1, 2, 3}));
  EXPECT_EQ(line({9, 0, 3}), (std::vector<int>{9, 8, 0, 1, 2, 3}));
  EXPECT_EQ(line({5, 2, 7}), (std::vector<int>{5, 4, 2, 6, 7}));
  EXPECT_EQ(line({3, 1}), (std::vector<int>{3, 2, 1}));
  EXPECT_EQ(make_body_line(body(), std::vector<int>{9, 3}).name, "footL-head");
}

TEST(MakeBodyLine, AWayThatComesBackIsRefusedByName) {
  EXPECT_NE(message_of([] { line({3, 5, 7}); }).find("comes back to joint 'armL'"), std::string::npos);
  EXPECT_NE(message_of([] { line({3, 3}); }).find("'head'"), std::string::npos);
  EXPECT_THROW(line({3}), Error);
  EXPECT_THROW(line({}), Error);
  EXPECT_THROW(line({3, 99}), Error);
}

TEST(SegmentsOfLine, ALineThatClimbsAndDescendsIsTwoSegmentsFromItsTop) {
  const Skeleton skeleton = body();
  EXPECT_EQ(segments_of_line(skeleton, {"", {9, 8, 0, 1, 2}}), (Segments{{0, 8, 9}, {0, 1, 2}}));
  EXPECT_EQ(segments_of_line(skeleton, {"", {0, 1, 2}}), (Segments{{0, 1, 2}}));
  EXPECT_EQ(segments_of_line(skeleton, {"", {3, 2, 1}}), (Segments{{1, 2, 3}}));
  EXPECT_THROW(static_cast<void>(segments_of_line(skeleton, {"", {9, 0, 1}})), Error);
  EXPECT_THROW(static_cast<void>(segments_of_line(skeleton, {"", {9}})), Error);
}

HumanoidMap human_map() {
  using enum HumanoidBone;
  HumanoidMap map;
  // This body has two joints a limb; the middle one stands for both bones.
  const std::pair<HumanoidBone, int> pairs[] = {
      {hips, 0},     {spine, 1},          {chest, 2},          {head, 3},      {leftUpperArm, 4}, {leftLowerArm, 4},
      {leftHand, 5}, {rightUpperArm, 6},  {rightLowerArm, 6},  {rightHand, 7}, {leftUpperLeg, 8}, {leftLowerLeg, 8},
      {leftFoot, 9}, {rightUpperLeg, 10}, {rightLowerLeg, 10}, {rightFoot, 11}};
  for (const auto& [bone, index] : pairs) map.set(bone, index, 1.0);
  return map;
}

TEST(StandardBodyLines, AHumanoidHasTheTrunkFirstAndItsLinesByName) {
  const Skeleton skeleton = body();
  const auto lines = standard_body_lines(skeleton, human_map());
  ASSERT_FALSE(lines.empty());
  EXPECT_EQ(lines.front().name, "trunk");
  EXPECT_EQ(lines.front().joints, (std::vector<int>{0, 1, 2, 3}));
  EXPECT_EQ(find_body_line(skeleton, human_map(), "left_foot-head").joints, (std::vector<int>{9, 8, 0, 1, 2, 3}));
  EXPECT_EQ(find_body_line(skeleton, human_map(), "left_foot-right_hand").joints,
            (std::vector<int>{9, 8, 0, 1, 2, 6, 7}));
  EXPECT_EQ(find_body_line(skeleton, human_map(), "left_hand-right_hand").joints, (std::vector<int>{5, 4, 2, 6, 7}));
  EXPECT_EQ(find_body_line(skeleton, human_map(), "right_leg").joints, (std::vector<int>{10, 11}));
  const std::string message = message_of([&] { static_cast<void>(find_body_line(skeleton, human_map(), "tail")); });
  EXPECT_NE(message.find("trunk, left_foot-head"), std::string::npos) << message;
}

TEST(StandardBodyLines, AnotherTreeHasItsLongestPathFirst) {
  // root - a - b(long), root - c; the longest way is b to c.
  const Skeleton tree({joint("root", -1), joint("a", 0), joint("b", 1, 5.0), joint("c", 0, 2.0)});
  const auto lines = standard_body_lines(tree, {});
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_EQ(lines[0].name, "b-c");
  EXPECT_EQ(lines[0].joints, (std::vector<int>{2, 1, 0, 3}));
  EXPECT_EQ(lines[1].name, "root-b");
  EXPECT_EQ(lines[2].name, "root-c");
}

TEST(StandardBodyLines, LinesNeitherEndInHelpersNorJoinSeparateTrees) {
  // scene(helper) - root - tip - holder(helper); scene - prop - prop_tip
  const Skeleton tree({joint("scene", -1, 1.0, true), joint("root", 0), joint("tip", 1), joint("holder", 2, 9.0, true),
                       joint("prop", 0, 50.0), joint("prop_tip", 4, 0.5)});
  const auto lines = standard_body_lines(tree, {});
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0].joints, (std::vector<int>{1, 2}));
  EXPECT_EQ(lines[1].joints, (std::vector<int>{4, 5}));
}

TEST(StandardBodyLines, OneJointHasNone) {
  const Skeleton one({joint("only", -1)});
  EXPECT_TRUE(standard_body_lines(one, {}).empty());
  EXPECT_NE(message_of([&] { static_cast<void>(find_body_line(one, {}, "x")); }).find("there are none"),
            std::string::npos);
}

TEST(StandardBodyLines, NamesAreUniqueAndAtMostSixtyFour) {
  std::vector<Joint> joints{joint("", -1)};
  for (int i = 0; i < 100; ++i) joints.push_back(joint(i % 2 == 0 ? "x-#1" : "same", 0, 1.0 + 0.01 * i));
  joints.push_back(joint("a", 0));
  joints.push_back(joint("a-a", 0));
  joints.push_back(joint("a-a-a", 0));
  const auto lines = standard_body_lines(Skeleton(joints), {});
  EXPECT_EQ(lines.size(), 64U);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) EXPECT_NE(lines[i].name, lines[j].name);
  }
}

}  // namespace
}  // namespace croquis
