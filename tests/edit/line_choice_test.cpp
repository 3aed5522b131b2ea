// SPDX-License-Identifier: MIT
#include "croquis/edit/line_choice.h"

#include "edit/figures.h"
#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "croquis/base/error.h"

namespace croquis {
namespace {

std::string error_of(const Character& character, const StrokeSettings& settings) {
  try {
    (void)choose_line(character, settings);
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

StrokeSettings with_joints(std::vector<int> joints) {
  StrokeSettings settings;
  settings.joints = std::move(joints);
  return settings;
}

TEST(JointList, ReadsNamesSpacesAndIndices) {
  const Skeleton skeleton({{"hip", -1, {}}, {"knee, left", 0, {}}, {"toe", 1, {}}, {"toe", 2, {}}, {" odd", 3, {}}});
  EXPECT_EQ(parse_joint_list(skeleton, "hip, #1,#2"), (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(parse_joint_list(skeleton, " odd"), (std::vector<int>{4}));
  EXPECT_THROW((void)parse_joint_list(skeleton, "hip,toe"), Error) << "two joints are called toe";
  EXPECT_THROW((void)parse_joint_list(skeleton, "hip,,#1"), Error);
  EXPECT_THROW((void)parse_joint_list(skeleton, ""), Error);
}

TEST(JointList, IsReadBackAsItWasWritten) {
  const Skeleton skeleton({{"hip", -1, {}}, {"knee, left", 0, {}}, {"toe", 1, {}}, {"toe", 2, {}}, {" odd", 3, {}}});
  const std::vector<int> all{0, 1, 2, 3, 4};
  EXPECT_EQ(parse_joint_list(skeleton, format_joint_list(skeleton, all)), all);
}

TEST(ChooseLine, FillsInWhatAPathLeavesOut) {
  const LineChoice choice = choose_line(stalk(4), with_joints({0, 4}));
  ASSERT_EQ(choice.segments.size(), 1U);
  EXPECT_EQ(choice.segments[0], (SkeletonSegment{0, 1, 2, 3, 4}));
  EXPECT_EQ(choice.line.name, "j0,j4");
  EXPECT_EQ(choice.line.joints, (std::vector<int>{0, 1, 2, 3, 4}));
}

TEST(ChooseLine, TurnsAPathThroughTheRootIntoTwoSegments) {
  const LineChoice choice = choose_line(cross(), with_joints({2, 4}));
  ASSERT_EQ(choice.segments.size(), 2U);
  EXPECT_EQ(choice.segments[0].front(), 0);
  EXPECT_EQ(choice.segments[1].front(), 0);
}

TEST(ChooseLine, TakesWhatIsNoPathAsASelection) {
  const LineChoice choice = choose_line(cross(), with_joints({0, 1, 2, 3, 4}));
  ASSERT_EQ(choice.segments.size(), 2U);
  EXPECT_EQ(choice.segments[0], (SkeletonSegment{0, 1, 2}));
  EXPECT_EQ(choice.segments[1], (SkeletonSegment{0, 3, 4}));
  EXPECT_TRUE(choice.line.joints.empty());
}

TEST(ChooseLine, NamesTheJointThatMakesASelectionInvalid) {
  EXPECT_NE(error_of(cross(), with_joints({0, 2, 1, 4})).find("'b2'"), std::string::npos)
      << error_of(cross(), with_joints({0, 2, 1, 4}));
}

TEST(ChooseLine, GivesARigWithoutSettingsItsLongestPath) {
  EXPECT_EQ(choose_line(stalk(4), {}).segments.front().size(), 5U);
}

TEST(ChooseLine, RefusesALineThatIsNotThereAndTwoChoicesAtOnce) {
  StrokeSettings settings;
  settings.body_line = "tail";
  EXPECT_NE(error_of(stalk(4), settings).find("tail"), std::string::npos);
  settings.joints = {0, 1};
  EXPECT_NE(error_of(stalk(4), settings).find("not for both"), std::string::npos);
  EXPECT_NE(error_of(stalk(0), {}).find("no bone"), std::string::npos) << "a rig of one joint";
}

TEST(MatchOptionsOfSettings, FollowTheirWords) {
  StrokeSettings settings;
  settings.method = "near";
  settings.root = "tangent";
  settings.plane = "ground";
  settings.direction = "backward";
  const MatchOptions options = match_options(settings);
  EXPECT_EQ(options.method, MatchMethod::near);
  EXPECT_EQ(options.root, RootMode::tangent);
  EXPECT_EQ(options.plane, DrawingPlane::ground);
  EXPECT_EQ(options.direction, DirectionRule::backward);
}

TEST(SolverOptionsOfSettings, FollowTheirWords) {
  StrokeSettings settings;
  EXPECT_TRUE(is_line_method(settings)) << "the method of a stroke that says nothing";
  EXPECT_FALSE(solver_options(settings).lock_root);
  for (const auto& [root, locks] : {std::pair{"lock", true}, {"tangent", false}, {"free", false}}) {
    settings.root = root;
    EXPECT_EQ(solver_options(settings).lock_root, locks) << root;
  }
  for (const auto& [length, policy] : {std::pair{"fit", LengthPolicy::fit},
                                       {"trim", LengthPolicy::trim},
                                       {"extend", LengthPolicy::extend},
                                       {"scale", LengthPolicy::scale}}) {
    settings.length = length;
    EXPECT_EQ(solver_options(settings).length, policy) << length;
  }
  settings.move = "body";
  settings.direction = "backward";
  EXPECT_TRUE(solver_options(settings).move_body);
  EXPECT_EQ(solver_direction(settings), LineInput::Direction::backward);
  check_words(settings);
  settings.direction = "sideways";
  EXPECT_THROW(check_words(settings), Error);
  settings.direction = "auto";
  for (const double factor : {-0.1, 2.1, std::nan("")}) {
    settings.exaggerate = factor;
    EXPECT_THROW(check_words(settings), Error) << factor;
  }
}

TEST(MatchOptionsOfSettings, NameTheWordsThereAre) {
  for (auto member :
       {&StrokeSettings::method, &StrokeSettings::root, &StrokeSettings::plane, &StrokeSettings::direction}) {
    StrokeSettings settings;
    settings.method = "rotation";
    settings.*member = "sideways";
    try {
      (void)match_options(settings);
      ADD_FAILURE() << "sideways was taken";
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find("'sideways': wanted "), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace croquis
