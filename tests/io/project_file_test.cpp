// SPDX-License-Identifier: MIT
#include "croquis/io/project_file.h"

#include "io/small_character.h"
#include "io/written_files.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "croquis/base/error.h"
#include "croquis/math/rotation.h"

namespace croquis {
namespace {

/// Two actors, one with a source file (if there is one to read) and one without, and one of everything else.
Project some_project() {
  Project project;
  const auto path = data_file("gltf/cesium_man.gltf");
  const auto first = std::make_shared<const Character>(path ? read_from(*path) : small_character());
  const auto second = std::make_shared<const Character>(small_character());
  Actor a{.character = first, .pose = first->start, .id = 3};
  a.pose.local[1].rotation = rotation_from_vector(Vec3(0.1, 0.2, 0.3));
  a.pins.push_back({.joint = 1, .position = Vec3(1, 2, 3), .rotation = rotation_from_vector(Vec3(0, 1, 0))});
  Actor b{.character = second, .pose = second->start, .id = 4, .builtin = "mannequin"};
  b.pose.local[1].translation = Vec3(0.1, 1.0 / 3.0, 0);
  b.proportions["heads"] = 7.5;
  project.actors = {a, b};
  PlacedStroke stroke;
  stroke.stroke = {"spine", {{Vec2(1, 2), 0.0, 0.5}, {Vec2(30.5, 1.0 / 3.0), 0.25, 1.0}}, true};
  stroke.settings.body_line = "tip-root";
  stroke.settings.joints = {0, 1};
  stroke.settings.exaggerate = 1.5;
  stroke.settings.depth = 2;
  stroke.settings.live = true;
  stroke.actor = 1;
  stroke.id = 5;
  stroke.before = second->start;
  stroke.line = {"tip-root", {1, 0}};
  project.strokes = {stroke};
  project.poses = {{"wave", 1, b.pose}};
  project.views = {{"side", Camera{.position = Vec3(5, 1, 0), .height = 3.0}}};
  project.settings = {"dancer", false, true, "lock"};
  project.next_id = 6;
  return project;
}

TEST(ProjectFile, EverythingComesBack) {
  const Project project = some_project();
  const Bytes bytes = write_project(project);
  keep_for_validator({bytes, {}}, "project/a.croquis.glb", "");
  const Project back = read_project(bytes, "a.croquis");
  ASSERT_EQ(back.actors.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    const Actor &was = project.actors[i], &is = back.actors[i];
    EXPECT_EQ(is.id, was.id);
    EXPECT_EQ(is.builtin, was.builtin);
    EXPECT_EQ(is.proportions, was.proportions);
    EXPECT_EQ(is.character->name, was.character->name);
    ASSERT_EQ(is.pose.local.size(), was.pose.local.size());
    for (std::size_t j = 0; j < was.pose.local.size(); ++j) {
      EXPECT_EQ(is.pose.local[j].translation, was.pose.local[j].translation);
      EXPECT_LT((is.pose.local[j].rotation.coeffs() - was.pose.local[j].rotation.coeffs()).norm(), 1e-15);
    }
    ASSERT_EQ(is.character->parts.size(), was.character->parts.size());
    EXPECT_EQ(is.character->parts[0].mesh.positions, was.character->parts[0].mesh.positions);
    EXPECT_EQ(is.character->clips.size(), was.character->clips.size());
  }
  if (project.actors[0].character->source != nullptr) {
    EXPECT_EQ(back.actors[0].character->source->bytes, project.actors[0].character->source->bytes);
    EXPECT_EQ(back.actors[0].character->source->format, "gltf");
  }
  ASSERT_EQ(back.actors[0].pins.size(), 1U);
  EXPECT_EQ(back.actors[0].pins[0].position, Vec3(1, 2, 3));
  EXPECT_TRUE(back.actors[0].pins[0].rotation);
  ASSERT_EQ(back.strokes.size(), 1U);
  const PlacedStroke &was = project.strokes[0], &is = back.strokes[0];
  EXPECT_EQ(is.stroke.name, was.stroke.name);
  EXPECT_TRUE(is.stroke.raw_pen);
  EXPECT_EQ(is.stroke.samples[1].position, was.stroke.samples[1].position);
  EXPECT_EQ(is.settings.joints, was.settings.joints);
  EXPECT_EQ(is.settings.exaggerate, 1.5);
  EXPECT_EQ(is.settings.depth, 2);
  EXPECT_TRUE(is.settings.live);
  EXPECT_EQ(is.line.joints, was.line.joints);
  EXPECT_TRUE(is.before);
  EXPECT_EQ(back.poses[0].name, "wave");
  EXPECT_EQ(back.poses[0].pose.local[1].translation, project.poses[0].pose.local[1].translation);
  EXPECT_EQ(back.views[0].camera.height, 3.0);
  EXPECT_EQ(back.settings.limits, "dancer");
  EXPECT_FALSE(back.settings.floor);
  EXPECT_TRUE(back.settings.balance);
  EXPECT_EQ(back.settings.root, "lock");
  EXPECT_EQ(back.next_id, 6);
}

TEST(ProjectFile, AViewerSeesTheActorsAsTheyStand) {
  const Project project = some_project();
  Bytes bytes = write_project(project);
  const GlbContainer glb = parse_glb(bytes);
  auto json = nlohmann::ordered_json::parse(glb.json);
  json.erase("extensions");
  json.erase("extensionsUsed");
  const Character seen = read_character(make_glb(json.dump(), glb.binary), "a.glb", nullptr);
  const Actor& second = project.actors[1];
  const auto tip = seen.skeleton.find("tip");
  ASSERT_FALSE(tip.empty());
  EXPECT_EQ(seen.start.local[static_cast<std::size_t>(tip.back())].translation, second.pose.local[1].translation);
}

TEST(ProjectFile, ReadAsACharacterItIsTheFirstOneInItsPose) {
  const Project project = some_project();
  const Character character = read_character(write_project(project), "a.croquis", nullptr);
  EXPECT_LT((character.start.local[1].rotation.coeffs() - project.actors[0].pose.local[1].rotation.coeffs()).norm(),
            1e-12);
  // Writing it as it stands puts the pose into the file that it came from.
  const Character back = read_back(write_character(character, character.start, "glb", "b.glb"), "b.glb");
  EXPECT_LT((back.start.local[1].rotation.coeffs() - character.start.local[1].rotation.coeffs()).norm(), 1e-12);
}

TEST(ProjectFile, AnEmptyProjectIsAProject) {
  const Bytes bytes = write_project({});
  EXPECT_TRUE(is_project(bytes));
  EXPECT_TRUE(read_project(bytes, "a.croquis").actors.empty());
  EXPECT_THROW((void)read_character(bytes, "a.croquis", nullptr), Error);
  keep_for_validator({bytes, {}}, "project/empty.glb", "");
}

Bytes changed(const Bytes& bytes, const std::function<void(nlohmann::ordered_json&)>& change) {
  const GlbContainer glb = parse_glb(bytes);
  auto json = nlohmann::ordered_json::parse(glb.json);
  change(json["extensions"]["CROQUIS_project"]);
  return make_glb(json.dump(), glb.binary);
}

TEST(ProjectFile, AStrokeThatNamesNoMethodWasMatchedByRotation) {
  const Bytes old = changed(write_project(some_project()), [](auto& p) {
    p["strokes"][0]["settings"].erase("method");
    p["strokes"][0]["settings"].erase("root");
  });
  const Project back = read_project(old, "old.croquis");
  EXPECT_EQ(back.strokes[0].settings.method, "rotation");
  EXPECT_EQ(back.strokes[0].settings.root, "lock");
}

TEST(ProjectFile, ANewerVersionIsRefusedInWords) {
  try {
    (void)read_project(changed(write_project({}), [](auto& p) { p["version"] = 2; }), "a.croquis");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::unsupported);
    EXPECT_NE(std::string(error.what()).find("newer Croquis"), std::string::npos);
  }
}

TEST(ProjectFile, BrokenProjectsAreRefusedWithThePlace) {
  const Bytes good = write_project(some_project());
  const std::vector<std::pair<std::string, std::function<void(nlohmann::ordered_json&)>>> cases = {
      {"/strokes/0/actor", [](auto& p) { p["strokes"][0]["actor"] = 7; }},
      {"/strokes/0/samples/1",
       [](auto& p) {
         p["strokes"][0]["samples"][1] = {1, 2};
       }},
      {"/strokes/0/line/joints/0", [](auto& p) { p["strokes"][0]["line"]["joints"][0] = 4711; }},
      {"/strokes/0/camera", [](auto& p) { p["strokes"][0]["camera"]["height"] = -1; }},
      {"/actors/0/source/bufferView", [](auto& p) { p["actors"][0]["source"]["bufferView"] = 100000; }},
      {"/actors/0/pose/0/rotation",
       [](auto& p) {
         p["actors"][0]["pose"][0]["rotation"] = {0, 0, 0, 0};
       }},
      {"/version", [](auto& p) { p.erase("version"); }},
  };
  for (const auto& [place, change] : cases) {
    try {
      (void)read_project(changed(good, change), "a.croquis");
      ADD_FAILURE() << place;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::bad_file);
      EXPECT_NE(std::string(error.what()).find(place), std::string::npos) << error.what();
    }
  }
  EXPECT_THROW((void)read_project(make_glb(R"({"asset":{"version":"2.0"}})", {}), "a.croquis"), Error);
}

}  // namespace
}  // namespace croquis
