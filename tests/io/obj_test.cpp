// SPDX-License-Identifier: MIT
#include "croquis/io/obj.h"

#include "io/written_files.h"

#include <gtest/gtest.h>

#include "croquis/base/error.h"

namespace croquis {
namespace {

Character read(const std::string& text) { return read_obj(bytes_of(text), "a.obj"); }

TEST(Obj, AQuadBecomesTwoTrianglesOnOneJoint) {
  const Character character =
      read("# a quad\r\nv 0 0 0\r\nv 1 0 0\r\nv 1 1 0\r\nv 0 1 0\r\nvt 0 0\r\nf 1/1 2/1 3/1 4/1\r\n");
  EXPECT_EQ(character.name, "a");
  EXPECT_EQ(character.skeleton.joint_count(), 1);
  ASSERT_EQ(character.parts.size(), 1U);
  EXPECT_EQ(character.parts[0].mesh.triangles, (std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3}));
  EXPECT_EQ(character.parts[0].mesh.uvs[0], Vec2f(0, 1)) << "v runs down in Croquis, up in OBJ";
}

TEST(Obj, NegativeIndicesCountBack) {
  const Character character = read("v 5 0 0\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1");
  EXPECT_EQ(character.parts[0].mesh.positions[0], Vec3f(0, 0, 0));
}

TEST(Obj, CornersWithOtherNormalsAreOtherVertices) {
  const Character character =
      read("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 2\nvn 1 0 0\nf 1//1 2//1 3//1\nf 1//2 2//1 3//1\n");
  EXPECT_EQ(character.parts[0].mesh.vertex_count(), 4);
  EXPECT_EQ(character.parts[0].mesh.normals[0], Vec3f(0, 0, 1)) << "normals come out as unit vectors";
}

TEST(Obj, GroupsBecomeParts) {
  const Character character = read("o a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\ng b\nf 3 2 1\ng empty\n");
  ASSERT_EQ(character.parts.size(), 2U);
  EXPECT_EQ(character.parts[1].name, "b");
}

TEST(Obj, ALineGoesOnAfterABackslash) {
  EXPECT_EQ(read("v 0 0 \\\n0\nv 1 0 0\nv 0 1 0\nf 1 2 \\\n3\n").parts[0].mesh.triangle_count(), 1);
}

TEST(Obj, EveryComplaintNamesTheLine) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"v 0 0 0\nv 1 x 0\n", "line 2: 'x' is no number"},
      {"v 0 0 0\nv 1\n", "line 2: wanted 3 numbers"},
      {"v 0 0 0\nf 1 1\n", "line 2: a face wants three corners"},
      {"v 0 0 0\nf 1 1 2\n", "line 2: vertex '2' is not there"},
      {"v 0 0 0\nf 0 1 1\n", "line 2: vertex '0' is not there"},
      {"v 0 0 0\nf -2 1 1\n", "line 2: vertex '-2' is not there"},
      {"v 0 0 nan\n", "line 1: 'nan' is no number"},
      {"v 1e300 0 0\n", "line 1: '1e300' is no number"},
      {"hello\n", "no OBJ"},
  };
  for (const auto& [text, words] : cases) {
    try {
      (void)read(text);
      ADD_FAILURE() << text;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::bad_file);
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
  }
}

TEST(Obj, RealMeshesHaveTheFacesThatTheyAreKnownFor) {
  const auto path = data_file("mesh/spot_control_quads.obj");
  if (!path) GTEST_SKIP() << "no shared data";
  const Character character = read_from(*path);
  ASSERT_EQ(character.parts.size(), 1U);
  EXPECT_GE(character.parts[0].mesh.triangle_count(), 4 + 2 * 160 + 3 * 16);
  const WrittenFile file = write_character(character, character.start, "glb", "spot.glb");
  keep_for_validator(file, "obj/spot.glb", "");
  EXPECT_EQ(read_back(file, "spot.glb").parts[0].mesh.positions, character.parts[0].mesh.positions);
}

}  // namespace
}  // namespace croquis
