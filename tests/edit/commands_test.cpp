// SPDX-License-Identifier: MIT
#include "croquis/edit/commands.h"

#include "edit/figures.h"
#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "croquis/base/error.h"
#include "croquis/edit/line_setup.h"
#include "croquis/edit/pose_line.h"
#include "croquis/edit/readings.h"
#include "croquis/edit/view.h"

namespace croquis {
namespace {

Project with_stalk() { return add_character({}, std::make_shared<const Character>(stalk(8))); }

/// A quarter of a circle in a 400 x 400 front view of the stalk, from its foot up and over to the right.
PlacedStroke quarter_circle(const Project& project) {
  PlacedStroke placed;
  placed.camera = make_named_view(project.actors, View::front, 400, 400);
  const Vec2 foot = *placed.camera.project(Vec3::Zero());
  for (int i = 0; i <= 32; ++i) {
    const double angle = 0.5 * kPi * i / 32;
    placed.stroke.samples.push_back({foot + 190 * Vec2(1 - std::cos(angle), -std::sin(angle))});
  }
  return placed;
}

TEST(AddCharacter, PutsItOnTheTableAsItStarts) {
  Character character = stalk(2);
  character.start.local[0].translation.x() = 3;
  const Project project = add_character(with_stalk(), std::make_shared<const Character>(character));
  ASSERT_EQ(project.actors.size(), 2U);
  EXPECT_EQ(project.actors[1].pose.local[0].translation.x(), 3);
  EXPECT_THROW((void)add_character({}, nullptr), Error);
}

TEST(AddBuiltinCharacter, RemembersWhatItWasMadeOf) {
  Proportions proportions;
  proportions.limbs = 1.2;
  const Project project = add_builtin_character({}, "snake", proportions);
  EXPECT_EQ(project.actors[0].builtin, "snake");
  EXPECT_EQ(project.actors[0].proportions, (std::map<std::string, double>{{"limbs", 1.2}}));
  EXPECT_THROW((void)add_builtin_character({}, "dragon"), Error);
}

TEST(SetPose, LeavesTheProjectItWasGivenAsItIs) {
  const Project before = with_stalk();
  Pose pose = before.actors[0].pose;
  pose.local[0].translation.y() = 2;
  const Project after = set_pose(before, 0, pose);
  EXPECT_EQ(before.actors[0].pose.local[0].translation.y(), 0);
  EXPECT_EQ(after.actors[0].pose.local[0].translation.y(), 2);
  EXPECT_EQ(after.actors[0].character, before.actors[0].character);
  EXPECT_THROW((void)set_pose(before, 1, pose), Error);
  pose.local.pop_back();
  EXPECT_THROW((void)set_pose(before, 0, pose), Error);
}

TEST(PoseAlongLines, BendsTheStalkAlongTheStrokeAndKeepsItsBones) {
  const Project before = with_stalk();
  const PosedLines posed = pose_along_lines(before, {quarter_circle(before)});
  EXPECT_EQ(posed.reports[0].status, "ok");
  EXPECT_TRUE(posed.reports[0].forward);
  EXPECT_LT(posed.reports[0].bone_length_drift, 1e-9);
  EXPECT_LT(posed.reports[0].fit.max_px, 25.0);
  EXPECT_TRUE(posed.reports[0].limit_violations.empty());
  const Character& character = *before.actors[0].character;
  const Vec3 tip = compute_positions(character.skeleton, posed.project.actors[0].pose).back();
  EXPECT_GT(tip.x(), 2.0);
  ASSERT_EQ(posed.project.strokes.size(), 1U);
  const PlacedStroke& kept = posed.project.strokes[0];
  EXPECT_EQ(kept.stroke.samples.size(), 33U);
  EXPECT_EQ(kept.line.joints.size(), 9U);
  ASSERT_TRUE(kept.before.has_value());
  EXPECT_TRUE(kept.before->local[1].rotation.isApprox(Quat::Identity()));
  EXPECT_NE(kept.id, posed.project.actors[0].id);
  EXPECT_TRUE(before.strokes.empty());
}

TEST(PoseAlongLines, GivesTheSamePoseAgain) {
  const Project before = with_stalk();
  const PlacedStroke stroke = quarter_circle(before);
  const Pose one = pose_along_lines(before, {stroke}).project.actors[0].pose;
  const Pose two = pose_along_lines(before, {stroke}).project.actors[0].pose;
  for (std::size_t i = 0; i < one.local.size(); ++i) {
    EXPECT_EQ(one.local[i].rotation.coeffs(), two.local[i].rotation.coeffs());
  }
}

TEST(PoseAlongLines, SolvesStrokesOfTheMethodLineTogether) {
  Project before = add_character({}, std::make_shared<const Character>(cross()));
  before.settings.floor = false;
  const auto stroke = [&](std::vector<int> joints, const Vec3& tip) {
    PlacedStroke placed;
    placed.camera = make_named_view(before.actors, View::front, 400, 400);
    placed.settings.method = "line";
    placed.settings.root = "free";
    placed.settings.joints = std::move(joints);
    const Vec2 from = *placed.camera.project(Vec3::Zero()), to = *placed.camera.project(tip);
    for (int i = 0; i <= 10; ++i) placed.stroke.samples.push_back({from + 0.1 * i * (to - from)});
    return placed;
  };
  const Vec3 up = 2 * Vec3(0.6, 0.8, 0), down = 2 * Vec3(-0.6, -0.8, 0);
  const PosedLines posed = pose_along_lines(before, {stroke({0, 2}, up), stroke({0, 4}, down)});
  ASSERT_EQ(posed.reports.size(), 2U);
  const Skeleton& skeleton = before.actors[0].character->skeleton;
  const std::vector<Vec3> positions = compute_positions(skeleton, posed.project.actors[0].pose);
  EXPECT_LT((positions[2] - up).norm(), 0.05);
  EXPECT_LT((positions[4] - down).norm(), 0.05);
  EXPECT_EQ(posed.project.strokes.size(), 2U);

  PlacedStroke other = stroke({0, 4}, down);
  other.settings.method = "rotation";
  EXPECT_THROW((void)pose_along_lines(before, {stroke({0, 2}, up), other}), Error);
  other = stroke({0, 4}, down);
  other.camera.height = 7;
  EXPECT_THROW((void)pose_along_lines(before, {stroke({0, 2}, up), other}), Error);
}

TEST(PoseAlongLines, MatchesStrokesOfOtherMethodsOneAfterAnother) {
  const Project before = with_stalk();
  PlacedStroke stroke = quarter_circle(before);
  stroke.settings.method = "rotation";
  const PosedLines once = pose_along_lines(before, {stroke});
  const PosedLines twice = pose_along_lines(before, {stroke, stroke});
  const Pose chained = pose_along_lines(once.project, {stroke}).project.actors[0].pose;
  for (std::size_t i = 0; i < chained.local.size(); ++i) {
    EXPECT_EQ(twice.project.actors[0].pose.local[i].rotation.coeffs(), chained.local[i].rotation.coeffs());
  }
  EXPECT_THROW((void)pose_along_lines(before, {}), Error);
}

TEST(PoseAlongLines, SaysThatTheStretchingMethodsStretch) {
  const Project before = with_stalk();
  PlacedStroke stroke = quarter_circle(before);
  stroke.settings.method = "curvilinear";
  const PosedLines posed = pose_along_lines(before, {stroke});
  EXPECT_NE(posed.reports[0].status, "ok");
  EXPECT_GT(posed.reports[0].bone_length_drift, 0.01);
}

TEST(PoseAlongLines, RefusesWhatIsNoStroke) {
  const Project before = with_stalk();
  PlacedStroke stroke = quarter_circle(before);
  stroke.stroke.samples.resize(1);
  EXPECT_THROW((void)pose_along_lines(before, {stroke}), Error);
  stroke = quarter_circle(before);
  stroke.stroke.samples[3].position.x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW((void)pose_along_lines(before, {stroke}), Error);
  stroke = quarter_circle(before);
  stroke.actor = 1;
  EXPECT_THROW((void)pose_along_lines(before, {stroke}), Error);
}

TEST(PoseAlongLines, KeepsTheActorsPins) {
  Project before = with_stalk();
  before.actors[0].pins.push_back({8, Vec3(3, 6, 0), {}});
  const PosedLines posed = pose_along_lines(before, {quarter_circle(before)});
  const Vec3 tip = compute_positions(before.actors[0].character->skeleton, posed.project.actors[0].pose).back();
  EXPECT_LT((tip - Vec3(3, 6, 0)).norm(), 1e-3);
}

TEST(PoseAlongLines, ExaggeratesALineOrMakesItStraight) {
  const Project before = with_stalk();
  const auto tip_at = [&](double factor) {
    PlacedStroke stroke = quarter_circle(before);
    stroke.settings.exaggerate = factor;
    const PosedLines posed = pose_along_lines(before, {stroke});
    const auto positions = compute_positions(before.actors[0].character->skeleton, posed.project.actors[0].pose);
    return (positions.back() - positions.front()).norm();
  };
  EXPECT_NEAR(tip_at(0.0), 8.0, 0.05);
  EXPECT_LT(tip_at(1.5), tip_at(1.0) - 0.3);
}

TEST(Readings, ListBothWaysRoundTheLikelierFirst) {
  const Project before = with_stalk();
  const std::vector<StrokeReading> readings = readings_of(before, quarter_circle(before));
  ASSERT_GE(readings.size(), 2U);
  EXPECT_TRUE(readings[0].forward);
  EXPECT_EQ(readings[0].settings.direction, "forward");
  EXPECT_LE(readings[0].cost, readings[1].cost);
  EXPECT_TRUE(std::any_of(readings.begin(), readings.end(), [](const StrokeReading& r) { return !r.forward; }));
  EXPECT_EQ(readings_of(before, quarter_circle(before), 1).size(), 1U);
}

TEST(AssignBodyLines, GivesEachStrokeABoneLineOfItsOwn) {
  const Project before = add_character({}, std::make_shared<const Character>(cross()));
  std::vector<PlacedStroke> strokes;
  for (const double side : {1.0, -1.0}) {
    PlacedStroke placed;
    placed.camera = make_named_view(before.actors, View::front, 400, 400);
    placed.settings.body_line = "auto";
    for (int i = 0; i <= 10; ++i) {
      placed.stroke.samples.push_back({*placed.camera.project(Vec3(0.2 * i * side, 0.002 * i * i, 0))});
    }
    strokes.push_back(placed);
  }
  const std::vector<PlacedStroke> assigned = assign_body_lines(before, strokes);
  EXPECT_EQ(assigned[0].settings.body_line, "root-a2");
  EXPECT_EQ(assigned[1].settings.body_line, "root-b2");
  strokes.push_back(strokes.front());
  EXPECT_THROW((void)assign_body_lines(before, strokes), Error) << "no line is left for the third";
  strokes[0].stroke.name = "root-b2";
  strokes.resize(1);
  EXPECT_EQ(assign_body_lines(before, strokes)[0].settings.body_line, "root-b2") << "a name is stronger than a place";
}

TEST(ParsePin, ReadsAJointWithOrWithoutAPlace) {
  const Project project = with_stalk();
  const Actor& actor = project.actors[0];
  EXPECT_EQ(parse_pin(actor, "j3").joint, 3);
  EXPECT_EQ(parse_pin(actor, "j3").position, Vec3(0, 3, 0));
  EXPECT_EQ(parse_pin(actor, "#2=1, -2,3e1").position, Vec3(1, -2, 30));
  for (const char* wrong : {"", "j99", "j3=", "j3=1,2", "j3=1,2,x", "j3=1,2,inf"}) {
    EXPECT_THROW((void)parse_pin(actor, wrong), Error) << wrong;
  }
}

TEST(ReadPoseLine, DrawnAgainChangesNothing) {
  const Project before = with_stalk();
  const Project bent = pose_along_lines(before, {quarter_circle(before)}).project;
  const Camera camera = quarter_circle(before).camera;
  const PoseLine read = read_pose_line(bent.actors[0], {}, camera);
  EXPECT_EQ(read.character.shape, LineShape::c);
  EXPECT_NEAR(read.character.turn_degrees, 90.0, 25.0);
  PlacedStroke again;
  again.camera = camera;
  again.stroke = read.stroke;
  const Pose pose = pose_along_lines(bent, {again}).project.actors[0].pose;
  for (std::size_t i = 0; i < pose.local.size(); ++i) {
    EXPECT_LT(pose.local[i].rotation.angularDistance(bent.actors[0].pose.local[i].rotation), 0.1 * kDegree);
  }
}

TEST(SetView, ReplacesTheViewOfThatName) {
  Camera camera;
  Project project = set_view({}, "door", camera);
  camera.height = 5;
  project = set_view(project, "door", camera);
  ASSERT_EQ(project.views.size(), 1U);
  EXPECT_EQ(project.views[0].camera.height, 5);
  camera.height = 0;
  EXPECT_THROW((void)set_view(project, "door", camera), Error);
}

}  // namespace
}  // namespace croquis
