// SPDX-License-Identifier: MIT
#include "croquis/io/gltf_read.h"

#include "io/small_character.h"
#include "io/written_files.h"
#include <cstring>

#include <gtest/gtest.h>

#include "croquis/base/error.h"
#include "croquis/io/uri.h"

namespace croquis {
namespace {

using Json = nlohmann::ordered_json;

Character read_small(const std::function<void(Json&)>& change = nullptr) {
  return read_character(small_glb(change), "small.glb", nullptr);
}

/// The text of the bad_file (or unsupported) error that the changed file gives.
std::string error_of(const std::function<void(Json&)>& change) {
  try {
    (void)read_small(change);
  } catch (const Error& error) {
    EXPECT_NE(error.code(), ErrorCode::invalid_argument) << error.what();
    return error.what();
  }
  return "read without an error";
}

bool has_oddity(const Character& character, const std::string& words) {
  for (const std::string& oddity : character.oddities) {
    if (oddity.find(words) != std::string::npos) return true;
  }
  return false;
}

template <class Number>
std::string data_uri(const std::vector<Number>& numbers) {
  Bytes bytes(numbers.size() * sizeof(Number));
  std::memcpy(bytes.data(), numbers.data(), bytes.size());
  return "data:application/octet-stream;base64," + encode_base64(bytes);
}

/// Appends numbers as a buffer, view and accessor; the accessor's index.
template <class Number>
int add_accessor(Json& json, const std::vector<Number>& numbers, int component, const std::string& type, int count) {
  json["buffers"].push_back({{"byteLength", numbers.size() * sizeof(Number)}, {"uri", data_uri(numbers)}});
  json["bufferViews"].push_back(
      {{"buffer", json["buffers"].size() - 1}, {"byteLength", numbers.size() * sizeof(Number)}});
  json["accessors"].push_back(
      {{"bufferView", json["bufferViews"].size() - 1}, {"componentType", component}, {"count", count}, {"type", type}});
  return static_cast<int>(json["accessors"].size()) - 1;
}

TEST(GltfRead, GivesBackASmallCharacterWhole) {
  const Character character = read_small();
  ASSERT_EQ(character.skeleton.joint_count(), 2);
  EXPECT_EQ(character.skeleton.name(1), "tip");
  EXPECT_EQ(character.skeleton.rest_position(1), Vec3(0, 1, 0));
  EXPECT_FALSE(character.skeleton.joint(0).helper);
  ASSERT_EQ(character.parts.size(), 1U);
  const Part& part = character.parts[0];
  EXPECT_EQ(part.name, "flag");
  EXPECT_EQ(part.mesh.positions[2], Vec3f(0, 2, 0));
  EXPECT_EQ(part.mesh.triangles, (std::vector<std::uint32_t>{0, 1, 2}));
  ASSERT_TRUE(part.skin);
  EXPECT_EQ(part.skin->weights, small_character().parts[0].skin->weights);
  EXPECT_EQ(part.skin->inverse_bind[1].translation(), Vec3(0, -1, 0));
  ASSERT_EQ(part.shapes.size(), 1U);
  EXPECT_EQ(part.shapes[0].name, "wide");
  EXPECT_EQ(part.shape_weights[0], 0.25F);
  ASSERT_EQ(character.clips.size(), 1U);
  EXPECT_EQ(character.clips[0].curves[0].joint, 1);
  EXPECT_EQ(character.source_nodes, (std::vector<int>{0, 1}));
  EXPECT_TRUE(character.oddities.empty()) << character.oddities.front();
}

TEST(GltfRead, AMatrixIsTakenApart) {
  const Character character = read_small([](Json& json) {
    json["nodes"][1].erase("translation");
    json["nodes"][1]["matrix"] = {0, 2, 0, 0, -2, 0, 0, 0, 0, 0, 2, 0, 3, 4, 5, 1};  // 90 degrees about z, doubled
  });
  const Transform& local = character.start.local[1];
  EXPECT_LT((local.translation - Vec3(3, 4, 5)).norm(), 1e-12);
  EXPECT_LT((local.scale - Vec3(2, 2, 2)).norm(), 1e-12);
  EXPECT_LT((local.rotation * Vec3::UnitX() - Vec3::UnitY()).norm(), 1e-12);
}

TEST(GltfRead, AncestorsOfJointsComeAlongAsHelpers) {
  const Character character = read_small([](Json& json) {
    json["nodes"].push_back({{"name", "armature"}, {"children", {0}}, {"scale", {0.01, 0.01, 0.01}}});
    json["scenes"][0]["nodes"][0] = json["nodes"].size() - 1;
  });
  ASSERT_EQ(character.skeleton.joint_count(), 3);
  EXPECT_EQ(character.skeleton.name(0), "armature");
  EXPECT_TRUE(character.skeleton.joint(0).helper);
  EXPECT_FALSE(character.skeleton.joint(1).helper);
  EXPECT_LT((character.skeleton.rest_position(2) - Vec3(0, 0.01, 0)).norm(), 1e-15);
}

TEST(GltfRead, SeveralRootsHangUnderOneMoreJoint) {
  const Character character = read_small([](Json& json) {
    json["nodes"][0].erase("children");
    json["scenes"][0]["nodes"].push_back(1);
  });
  ASSERT_EQ(character.skeleton.joint_count(), 3);
  EXPECT_EQ(character.source_nodes[0], -1);
  EXPECT_TRUE(character.skeleton.joint(0).helper);
  EXPECT_EQ(character.skeleton.children(0).size(), 2U);
}

TEST(GltfRead, AMeshWithoutASkinHangsOnTheJointAboveIt) {
  const Character character = read_small([](Json& json) {
    Json mesh = json["meshes"][0];
    mesh["primitives"][0]["attributes"].erase("JOINTS_0");
    mesh["primitives"][0]["attributes"].erase("WEIGHTS_0");
    json["meshes"].push_back(mesh);
    json["nodes"].push_back({{"name", "hat"}, {"mesh", 1}, {"translation", {0, 0, 3}}});
    json["nodes"].push_back(
        {{"name", "between"}, {"children", {json["nodes"].size() - 1}}, {"translation", {1, 0, 0}}});
    json["nodes"][1]["children"] = Json::array({json["nodes"].size() - 1});
  });
  ASSERT_EQ(character.parts.size(), 2U);
  const Part& hat = character.parts[0].skin ? character.parts[1] : character.parts[0];
  EXPECT_EQ(hat.joint, 1);
  EXPECT_EQ(hat.joint_from_mesh.translation(), Vec3(1, 0, 3));
}

TEST(GltfRead, QuantisedAndSparseNumbersAreRead) {
  const Character character = read_small([](Json& json) {
    Json& attributes = json["meshes"][0]["primitives"][0]["attributes"];
    const int positions =
        add_accessor<std::int16_t>(json, {0, 0, 0, 0, 32767, 0, 0, 0, 0, -32768, 0, 0}, 5122, "VEC3", 3);
    json["accessors"][static_cast<std::size_t>(positions)]["normalized"] = true;
    json["bufferViews"].back()["byteStride"] = 8;
    attributes["POSITION"] = positions;
    // Normals: none in a view, one put in by a sparse accessor; the others are zero.
    const int values = add_accessor<float>(json, {0, 1, 0}, 5126, "VEC3", 1);
    const int indices = add_accessor<std::uint8_t>(json, {2}, 5121, "SCALAR", 1);
    const auto view_of = [&](int index) { return json["accessors"][static_cast<std::size_t>(index)]["bufferView"]; };
    json["accessors"].push_back({{"componentType", 5126}, {"count", 3}, {"type", "VEC3"}});
    json["accessors"].back()["sparse"] = {{"count", 1},
                                          {"indices", {{"bufferView", view_of(indices)}, {"componentType", 5121}}},
                                          {"values", {{"bufferView", view_of(values)}}}};
    attributes["NORMAL"] = json["accessors"].size() - 1;
  });
  const Mesh& mesh = character.parts[0].mesh;
  EXPECT_EQ(mesh.positions[1], Vec3f(1, 0, 0));
  EXPECT_EQ(mesh.positions[2], Vec3f(0, -1, 0)) << "-32768 means -1";
  EXPECT_EQ(mesh.normals[0], Vec3f(0, 0, 0));
  EXPECT_EQ(mesh.normals[2], Vec3f(0, 1, 0));
}

TEST(GltfRead, EightInfluencesAreRead) {
  const Character character = read_small([](Json& json) {
    Json& attributes = json["meshes"][0]["primitives"][0]["attributes"];
    attributes["JOINTS_1"] = add_accessor<std::uint16_t>(json, {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, 5123, "VEC4", 3);
    attributes["WEIGHTS_1"] = add_accessor<float>(json, {3, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, 5126, "VEC4", 3);
  });
  const Skin& skin = *character.parts[0].skin;
  ASSERT_EQ(skin.influences, 8);
  EXPECT_EQ(skin.weights[0], 0.75F) << "1 and 3 sum to 4, the largest first";
  EXPECT_EQ(skin.joint_indices[0], 1);
  EXPECT_EQ(skin.weights[1], 0.25F);
  EXPECT_TRUE(has_oddity(character, "do not sum to 1"));
}

TEST(GltfRead, StripsAndFansBecomeTriangles) {
  const auto triangles = [](int mode) {
    return read_small([mode](Json& json) {
             Json& primitive = json["meshes"][0]["primitives"][0];
             primitive["indices"] = add_accessor<std::uint16_t>(json, {0, 1, 2, 0}, 5123, "SCALAR", 4);
             primitive["mode"] = mode;
           })
        .parts[0]
        .mesh.triangles;
  };
  EXPECT_EQ(triangles(5), (std::vector<std::uint32_t>{0, 1, 2, 1, 0, 2}));
  EXPECT_EQ(triangles(6), (std::vector<std::uint32_t>{1, 2, 0, 2, 0, 0}));
}

TEST(GltfRead, APrimitiveThatUsesLittleOfASharedAccessorGetsItsOwnVertices) {
  const Character character = read_small([](Json& json) {
    Json& primitive = json["meshes"][0]["primitives"][0];
    std::vector<float> many(300, 0.0F);
    for (std::size_t i = 0; i < 100; ++i) many[3 * i] = static_cast<float>(i);
    primitive["attributes"] = {{"POSITION", add_accessor(json, many, 5126, "VEC3", 100)}};
    primitive.erase("targets");
    primitive["indices"] = add_accessor<std::uint16_t>(json, {90, 7, 50}, 5123, "SCALAR", 3);
    json["nodes"].back().erase("skin");
  });
  const Mesh& mesh = character.parts[0].mesh;
  ASSERT_EQ(mesh.positions.size(), 3U);
  EXPECT_EQ(mesh.positions[mesh.triangles[0]].x(), 90.0F);
  EXPECT_EQ(mesh.positions[mesh.triangles[1]].x(), 7.0F);
}

TEST(GltfRead, EveryComplaintNamesThePlace) {
  const std::vector<std::pair<std::string, std::function<void(Json&)>>> cases = {
      {"node 0 is a child of node",
       [](Json& j) {
         j["nodes"].push_back({{"children", {0, 1}}}), j["nodes"][1]["children"] = {0};
       }},
      {"the nodes run in a circle", [](Json& j) { j["nodes"][1]["children"] = {0}, j["scenes"][0].erase("nodes"); }},
      {"/nodes/0/rotation: wanted a unit quaternion",
       [](Json& j) {
         j["nodes"][0]["rotation"] = {0, 0, 0, 0};
       }},
      {"/nodes/2/mesh: mesh 9 is not there", [](Json& j) { j["nodes"][2]["mesh"] = 9; }},
      {"/skins/0/joints/0: node 77 is not there", [](Json& j) { j["skins"][0]["joints"][0] = 77; }},
      {"wanted 3 matrices", [](Json& j) { j["skins"][0]["joints"].push_back(2); }},
      {"bytes that are left of buffer view", [](Json& j) { j["accessors"][0]["count"] = 2000000000; }},
      {"/accessors/0/count: wanted a whole number", [](Json& j) { j["accessors"][0]["count"] = 1e18; }},
      {"/accessors/0/componentType", [](Json& j) { j["accessors"][0]["componentType"] = 5124; }},
      {"/bufferViews/0: wanted bytes", [](Json& j) { j["bufferViews"][0]["byteOffset"] = 4294967295; }},
      {"far more data than the file has",
       [](Json& j) { j["accessors"][0].erase("bufferView"), j["accessors"][0]["count"] = 2147483647; }},
      {"/buffers/0/byteLength: wanted", [](Json& j) { j["buffers"][0]["byteLength"] = 100000; }},
      {"/buffers/0/uri: 'http://a.b/c.bin' is no file", [](Json& j) { j["buffers"][0]["uri"] = "http://a.b/c.bin"; }},
      {"/asset/version: glTF 1.0", [](Json& j) { j["asset"]["version"] = "1.0"; }},
      {"KHR_draco_mesh_compression is not read",
       [](Json& j) { j["extensionsRequired"] = Json::array({"KHR_draco_mesh_compression"}); }},
      {"EXT_meshopt_compression is not read",
       [](Json& j) {
         j["buffers"].push_back({{"byteLength", 1000000}});
         j["bufferViews"][0]["buffer"] = j["buffers"].size() - 1;
         j["bufferViews"][0]["extensions"]["EXT_meshopt_compression"] = Json::object();
       }},
      {"hangs on joint 1 of a skin that has 1",
       [](Json& j) { j["skins"][0]["joints"].erase(1), j["skins"][0].erase("inverseBindMatrices"); }},
      {"has the weight -0.5",
       [](Json& j) {
         j["meshes"][0]["primitives"][0]["attributes"]["WEIGHTS_0"] =
             add_accessor<float>(j, {1, 0, 0, 0, 1, 0, 0, 0, -0.5, 1.5, 0, 0}, 5126, "VEC4", 3);
       }},
      {"element 2 holds a number that is not finite",
       [](Json& j) {
         j["meshes"][0]["primitives"][0]["attributes"]["WEIGHTS_0"] =
             add_accessor<float>(j, {1, 0, 0, 0, 1, 0, 0, 0, NAN, 1, 0, 0}, 5126, "VEC4", 3);
       }},
      {"wanted 3 elements as of POSITION",
       [](Json& j) {
         j["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = add_accessor<float>(j, {0, 0, 1}, 5126, "VEC3", 1);
       }},
  };
  for (const auto& [words, change] : cases) {
    const std::string text = error_of(change);
    EXPECT_NE(text.find(words), std::string::npos) << "wanted: " << words << "\nfound: " << text;
    EXPECT_EQ(text.find('\n'), std::string::npos);
  }
}

TEST(GltfRead, WhatIsOddIsSaidInWords) {
  const Character unnamed = read_small([](Json& json) { json["nodes"][1].erase("name"); });
  EXPECT_TRUE(has_oddity(unnamed, "1 joint has no name"));
  const Character twice = read_small([](Json& json) { json["nodes"][1]["name"] = "root"; });
  EXPECT_TRUE(has_oddity(twice, "such as 'root'"));
  const Character moved = read_small([](Json& json) { json["nodes"][1]["translation"] = {0, 2, 0}; });
  EXPECT_TRUE(has_oddity(moved, "It does not stand as it was bound"));
  const Character unknown = read_small([](Json& json) { json["extensionsUsed"] = Json::array({"ACME_hair"}); });
  EXPECT_TRUE(has_oddity(unknown, "ACME_hair"));
}

TEST(GltfRead, AFileWithoutASkinIsItsAnimatedNodesElseAllNodes) {
  const Character animated = read_small([](Json& json) {
    json.erase("skins");
    json["nodes"].back().erase("skin");
  });
  ASSERT_EQ(animated.skeleton.joint_count(), 3) << "scene, root (helper), tip";
  EXPECT_FALSE(animated.skeleton.joint(2).helper);
  const Character all = read_small([](Json& json) {
    json.erase("skins");
    json.erase("animations");
    json["nodes"].back().erase("skin");
  });
  EXPECT_EQ(all.skeleton.joint_count(), 4) << "scene, root, tip, flag";
}

TEST(GltfRead, EveryGoodFileIsReadWhole) {
  const auto files = good_gltf_files();
  if (files.empty()) GTEST_SKIP() << "no shared data";
  for (const auto& path : files) {
    SCOPED_TRACE(path.string());
    try {
      const Character character = read_from(path);
      EXPECT_GT(character.skeleton.joint_count(), 0);
    } catch (const Error& error) {
      ADD_FAILURE() << error.what();
    }
  }
  EXPECT_GT(files.size(), 60U);
}

TEST(GltfRead, WhatIsKnownOfRealFilesComesOut) {
  const auto open = [](const std::string& name) -> std::optional<Character> {
    const auto path = data_file(name);
    return path ? std::optional(read_from(*path)) : std::nullopt;
  };
  const auto knight = open("gltf/kaykit_knight.glb");
  if (!knight) GTEST_SKIP() << "no shared data";
  EXPECT_EQ(knight->clips.size(), 76U);
  int joints = 0;
  for (const Joint& joint : knight->skeleton.joints()) joints += joint.helper ? 0 : 1;
  EXPECT_EQ(joints, 41);
  EXPECT_EQ(open("gltf/momentum_8_influences.glb")->parts[0].skin->influences, 8);
  EXPECT_EQ(open("gltf/morph_stress_test.gltf")->parts[0].shapes.size(), 8U);
  EXPECT_EQ(open("gltf/morph_stress_test.gltf")->clips.size(), 3U);
  EXPECT_EQ(open("gltf/rigged_figure.glb")->parts[0].mesh.triangle_count(), 256);
  EXPECT_EQ(open("gltf/fox_khronos.glb")->parts[0].mesh.vertex_count(), 1728);
  EXPECT_TRUE(has_oddity(*open("gltf/cesium_man.gltf"), "The weights of 210 vertices do not sum to 1"));
  ASSERT_NE(open("gltf/fox_khronos.glb")->parts[0].material.base_color_image, nullptr);
  try {
    (void)open("gltf/quaternius_space_enemy_DRACO.glb");
    FAIL() << "Draco must be refused";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::unsupported);
    EXPECT_NE(std::string(error.what()).find("KHR_draco_mesh_compression"), std::string::npos);
  }
}

}  // namespace
}  // namespace croquis
