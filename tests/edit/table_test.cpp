// SPDX-License-Identifier: MIT
#include "croquis/edit/table.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "croquis/base/error.h"
#include "croquis/base/random.h"
#include "croquis/edit/screen_form.h"

namespace croquis {
namespace {

using Json = nlohmann::ordered_json;

Json run(Table& table, const Json& command) { return Json::parse(table.execute(command.dump(), {})); }

Json front_camera() {
  return {{"projection", "orthographic"},
          {"position", {0, 0.9, 5}},
          {"target", {0, 0.9, 0}},
          {"up", {0, 1, 0}},
          {"height", 2.4},
          {"width", 800},
          {"height_px", 800}};
}

/// A table with the mannequin on it, made once: meshing it takes a while.
Table table_with_mannequin() {
  static const Table kTable = [] {
    Table table;
    run(table, {{"name", "add_character"}, {"character", "mannequin"}});
    return table;
  }();
  return kTable;
}

int actor_of(const Table& table) { return table.project().actors.front().id; }

Json leaning_stroke(int actor) {
  Json samples = Json::array();
  for (int i = 0; i <= 20; ++i) {
    const double t = i / 20.0;
    samples.push_back(Json::array({400.0 + 90.0 * t * t, 390.0 - 250.0 * t, 0.01 * i, 0.5}));
  }
  return {{"name", "draw"},
          {"actor", actor},
          {"samples", samples},
          {"camera", front_camera()},
          {"settings", Json::object()}};
}

double difference(const Project& a, const Project& b) {
  double most = 0.0;
  const auto pa = compute_positions(a.actors[0].character->skeleton, a.actors[0].pose);
  const auto pb = compute_positions(b.actors[0].character->skeleton, b.actors[0].pose);
  for (std::size_t i = 0; i < pa.size(); ++i) most = std::max(most, (pa[i] - pb[i]).norm());
  return most;
}

TEST(Table, APreviewShowsAndACommitStays) {
  Table table = table_with_mannequin();
  const Project rest = table.project();
  const std::string stroke = leaning_stroke(actor_of(table)).dump();
  const Json preview = Json::parse(table.preview(stroke));
  EXPECT_FALSE(preview.contains("state"));
  EXPECT_EQ(preview["moved"].size(), 1U);
  EXPECT_GT(difference(rest, table.shown()), 0.02);
  EXPECT_EQ(difference(rest, table.project()), 0.0);
  const Project previewed = table.shown();
  const Json committed = run(table, Json::parse(stroke));
  EXPECT_EQ(committed["state"]["strokes"].size(), 1U);
  EXPECT_EQ(difference(previewed, table.project()), 0.0);  // lifting the pen changes nothing
  EXPECT_EQ(difference(table.shown(), table.project()), 0.0);
  table.undo();
  EXPECT_EQ(difference(rest, table.project()), 0.0);
}

TEST(Table, AGrowingStrokeIsFollowedAndLiftingThePenChangesNothing) {
  Table table = table_with_mannequin();
  const Project rest = table.project();
  Json stroke = leaning_stroke(actor_of(table));
  const Json samples = stroke["samples"];
  double last = 0.0;
  for (std::size_t count = 2; count <= samples.size(); count += 2) {
    stroke["samples"] = Json(samples.begin(), samples.begin() + static_cast<std::ptrdiff_t>(count));
    const Json shown = Json::parse(table.preview(stroke.dump()));
    last = difference(rest, table.shown());
    if (count > 8) {
      EXPECT_EQ(shown["solved"]["line"]["name"], "trunk");
    }
  }
  EXPECT_GT(last, 0.02);
  stroke["samples"] = samples;
  table.preview(stroke.dump());
  const Project previewed = table.shown();
  run(table, stroke);
  EXPECT_EQ(difference(previewed, table.project()), 0.0);
  // How many samples came at a time does not matter: a journal that knows the whole stroke alone replays the pose.
  Table other = table_with_mannequin();
  run(other, stroke);
  EXPECT_EQ(difference(other.project(), table.project()), 0.0);
}

TEST(Table, AStrokeThatGrowsMovesThePoseWithThePen) {
  Table table = table_with_mannequin();
  Json stroke = leaning_stroke(actor_of(table));
  const Json samples = stroke["samples"];
  Project before = table.project();
  for (std::size_t count = 2; count <= samples.size(); ++count) {
    stroke["samples"] = Json(samples.begin(), samples.begin() + static_cast<std::ptrdiff_t>(count));
    table.preview(stroke.dump());
    if (difference(table.project(), before) > 0.0) {  // once the pen has taken hold
      EXPECT_LT(difference(before, table.shown()), 0.2) << "a jump at sample " << count;
    }
    before = table.shown();
  }
}

TEST(Table, ARedrawnStrokeKeepsItsLineAndUndoneChangesComeBack) {
  Table table = table_with_mannequin();
  const Json drawn = run(table, leaning_stroke(actor_of(table)));
  const Project first = table.project();
  const int stroke = drawn["state"]["strokes"][0]["id"];
  Json samples = drawn["state"]["strokes"][0]["samples"];
  for (Json& sample : samples) sample[0] = 800.0 - sample[0].get<double>();  // leaning the other way
  const Json redrawn = run(table, {{"name", "redraw"}, {"stroke", stroke}, {"samples", samples}});
  EXPECT_EQ(redrawn["solved"]["line"]["name"], drawn["solved"]["line"]["name"]);
  EXPECT_GT(difference(first, table.project()), 0.05);
  table.undo();
  EXPECT_EQ(difference(first, table.project()), 0.0);
}

TEST(Table, RulesOfTheTableHoldForItsLines) {
  Table table = table_with_mannequin();
  const int actor = actor_of(table);
  const int hand = table.project().actors[0].character->humanoid.joint(HumanoidBone::leftHand);
  run(table, {{"name", "pin"}, {"actor", actor}, {"joint", hand}, {"on", true}, {"with_rotation", false}});
  const Project before = table.project();
  run(table, leaning_stroke(actor));
  const auto place = [&](const Project& project) {
    const Actor& figure = project.actors[0];
    return compute_positions(figure.character->skeleton, figure.pose)[static_cast<std::size_t>(hand)];
  };
  EXPECT_LT((place(before) - place(table.project())).norm(), 1e-3);
  EXPECT_THROW((void)table.execute(R"({"name":"set_table","settings":{"floor":"yes"}})", {}), Error);
}

TEST(Table, AnotherReadingIsAnotherPoseAndBackIsBack) {
  Table table = table_with_mannequin();
  const Json drawn = run(table, leaning_stroke(actor_of(table)));
  ASSERT_GT(drawn["solved"]["alternatives"].size(), 1U);
  const Project first = table.project();
  const int stroke = drawn["state"]["strokes"][0]["id"];
  run(table, {{"name", "set_stroke"}, {"stroke", stroke}, {"settings", {{"alternative", 1}}}});
  EXPECT_GT(difference(first, table.project()), 1e-3);
  run(table, {{"name", "set_stroke"}, {"stroke", stroke}, {"settings", {{"alternative", 0}}}});
  EXPECT_LT(difference(first, table.project()), 1e-9);
}

TEST(Table, TheSameJournalGivesTheSameProject) {
  Table one = table_with_mannequin(), two = table_with_mannequin();
  const int actor = actor_of(one);
  const int hand = one.project().actors[0].character->humanoid.joint(HumanoidBone::leftHand);
  const std::vector<Json> journal{leaning_stroke(actor),
                                  {{"name", "drag"}, {"actor", actor}, {"joint", hand}, {"target", {0.4, 1.6, 0.3}}},
                                  {{"name", "mirror"}, {"actor", actor}, {"side", "both"}},
                                  {{"name", "reset"}, {"actor", actor}, {"joints", Json::array()}, {"amount", 0.25}}};
  for (const Json& command : journal) {
    run(one, command);
    run(two, command);
  }
  EXPECT_EQ(difference(one.project(), two.project()), 0.0);
}

TEST(Table, RandomCommandsUndoneAndRedoneComeBackToTheSame) {
  Table table = table_with_mannequin();
  const int actor = actor_of(table);
  const int joints = table.project().actors[0].character->skeleton.joint_count();
  Random random(7);
  std::vector<Project> stages{table.project()};
  for (int i = 0; i < 200; ++i) {
    Json command;
    switch (random.index(5)) {
      case 0:
        command = {{"name", "rotate"},
                   {"actor", actor},
                   {"joint", random.index(joints)},
                   {"rotation_model", {0.1, 0.2, random.normal(), 1.0}}};
        break;
      case 1:
        command = {{"name", "mirror"}, {"actor", actor}, {"side", "both"}};
        break;
      case 2:
        command = {{"name", "reset"}, {"actor", actor}, {"joints", Json::array()}, {"amount", random.uniform()}};
        break;
      case 3:
        command = {{"name", "pin"},
                   {"actor", actor},
                   {"joint", random.index(joints)},
                   {"on", random.index(2) == 0},
                   {"with_rotation", false}};
        break;
      default:
        command = {{"name", "set_table"}, {"settings", {{"floor", random.index(2) == 0}}}};
        break;
    }
    run(table, command);
    stages.push_back(table.project());
  }
  for (std::size_t i = stages.size() - 1; i > 0; --i) {
    EXPECT_EQ(difference(stages[i], table.project()), 0.0);
    EXPECT_EQ(stages[i].actors[0].pins.size(), table.project().actors[0].pins.size());
    table.undo();
  }
  for (std::size_t i = 1; i < stages.size(); ++i) table.redo();
  EXPECT_EQ(difference(stages.back(), table.project()), 0.0);
}

TEST(Table, APoseOfTheShelfIsAppliedAndStandsOnTheFloor) {
  Table table = table_with_mannequin();
  const int actor = actor_of(table);
  const Json shelf = Json::parse(table.query("shelf", Json{{"actor", actor}}.dump()));
  int poses = 0, hands = 0;
  for (const Json& pose : shelf["poses"]) (pose["kind"] == "hand" ? hands : poses) += 1;
  EXPECT_GE(poses, 24);
  EXPECT_GE(hands, 8);
  const Project rest = table.project();
  run(table, {{"name", "apply_pose"},
              {"actor", actor},
              {"pose", shelf["poses"][4]["pose"]},
              {"strength", 1.0},
              {"flipped", false}});
  EXPECT_GT(difference(rest, table.project()), 0.1);
  const Actor& posed = table.project().actors[0];
  double lowest = 10.0;
  for (const Vec3& p : compute_positions(posed.character->skeleton, posed.pose)) lowest = std::min(lowest, p.y());
  double lowest_at_rest = 10.0;
  for (const Vec3& p : compute_positions(posed.character->skeleton, rest_pose(posed.character->skeleton))) {
    lowest_at_rest = std::min(lowest_at_rest, p.y());
  }
  EXPECT_NEAR(lowest, lowest_at_rest, 1e-6);
}

TEST(Table, WrongCommandsAreToldInWordsAndChangeNothing) {
  Table table = table_with_mannequin();
  const Project before = table.project();
  const std::vector<std::string> wrong{"",
                                       "[]",
                                       "{}",
                                       R"({"name":"fly"})",
                                       R"({"name":"mirror","actor":99,"side":"both"})",
                                       R"({"name":"mirror","actor":1,"side":"up"})",
                                       R"({"name":"draw","actor":1,"samples":[[0,0,0]],"camera":{},"settings":{}})",
                                       R"({"name":"drag","actor":1,"joint":999,"target":[0,0,0]})"};
  for (const std::string& command : wrong)
    EXPECT_THROW(static_cast<void>(table.execute(command, {})), Error) << command;
  EXPECT_EQ(difference(before, table.project()), 0.0);
}

TEST(Table, ASavedBuiltInCharacterComesBackWithTheSameJointsAndBodyLines) {
  for (const std::string name : {"mannequin", "cat", "snake", "tree"}) {
    Table table, later;
    Json before = run(table, {{"name", "add_character"}, {"character", name}})["state"]["actors"][0];
    Json after = Json::parse(later.restore(table.export_file("croquis", 0, "{}")))["state"]["actors"][0];
    for (const char* key : {"joints", "body_lines", "parts", "front", "extent", "palette_size", "builtin"}) {
      EXPECT_EQ(before[key], after[key]) << name << ' ' << key;
    }
  }
}

std::vector<float> joints_of(const Table& table, std::size_t actor) {
  return make_screen_joints(table.project().actors[actor]);
}

float most_apart(const std::vector<float>& a, const std::vector<float>& b) {
  float most = 0.0F;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
  return most;
}

TEST(Table, ANewcomerStandsBesideTheOthersAndStaysThere) {
  Table table = table_with_mannequin();
  run(table, {{"name", "add_character"}, {"character", "cat"}});
  const Actor& cat = table.project().actors[1];
  const int id = cat.id;
  const Box others = bounding_box(*table.project().actors[0].character, table.project().actors[0].pose);
  EXPECT_GT(bounding_box(*cat.character, cat.pose).min().x(), others.max().x());
  const std::vector<float> set_down = joints_of(table, 1);

  for (int twice = 0; twice < 2; ++twice) run(table, {{"name", "mirror"}, {"actor", id}, {"side", "both"}});
  EXPECT_LT(most_apart(joints_of(table, 1), set_down), 1e-5F) << "mirrored where it stands";
  const Json turn = {{"name", "rotate"}, {"actor", id}, {"joint", 2}, {"rotation_model", {0, 0.2, 0, 0.97}}};
  const Json reset = {{"name", "reset"}, {"actor", id}, {"joints", Json::array()}, {"amount", 1}};
  run(table, turn);
  run(table, reset);
  EXPECT_LT(most_apart(joints_of(table, 1), set_down), 1e-6F);

  Table later;
  later.restore(table.export_file("croquis", 0, "{}"));
  EXPECT_EQ(joints_of(later, 1), joints_of(table, 1));
  run(later, turn);
  run(later, reset);
  EXPECT_LT(most_apart(joints_of(later, 1), set_down), 1e-6F) << "a saved project knows where it was set down";
  run(later, {{"name", "set_proportions"}, {"actor", id}, {"proportions", Json::object()}});
  EXPECT_LT(most_apart(joints_of(later, 1), set_down), 1e-5F);
}

}  // namespace
}  // namespace croquis
