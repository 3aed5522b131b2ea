// SPDX-License-Identifier: MIT
#include "croquis/io/bvh.h"

#include "support/data.h"

#include <gtest/gtest.h>

#include "croquis/base/error.h"
#include "croquis/math/rotation.h"

namespace croquis {
namespace {

const char* const kArm =
    "HIERARCHY\n"
    "ROOT Hips\n"
    "{\n"
    "  OFFSET 0 10 0\n"
    "  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\n"
    "  JOINT Arm\n"
    "  {\n"
    "    OFFSET 5 0 0\n"
    "    CHANNELS 3 Yrotation Xrotation Zrotation\n"
    "    End Site\n"
    "    {\n"
    "      OFFSET 2 0 0\n"
    "    }\n"
    "  }\n"
    "}\n"
    "MOTION\n"
    "Frames: 2\n"
    "Frame Time: 0.5\n"
    "0 0 0 0 0 0 0 0 0\n"
    "1 2 3 90 0 0 0 0 90\n";

Character read(std::string_view text) { return read_bvh(bytes_of(text), "arm.bvh"); }

std::string replaced(std::string text, std::string_view from, std::string_view to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) {
    text.replace(at, from.size(), to);
  }
  return text;
}

Error error_of(std::string_view text) {
  try {
    (void)read(text);
  } catch (const Error& error) {
    return error;
  }
  ADD_FAILURE() << "no error";
  return {ErrorCode::internal, ""};
}

Pose frame_pose(const Character& character, int frame) {
  const Clip& clip = character.clips.front();
  return sample_pose(clip, clip.frame_time(frame), rest_pose(character.skeleton));
}

void expect_near(const Vec3& got, const Vec3& wanted) { EXPECT_LT((got - wanted).norm(), 1e-9) << got.transpose(); }

TEST(Bvh, RestHasZeroRotationsAndEveryJointAtItsOffset) {
  const Character arm = read(kArm);
  ASSERT_EQ(arm.skeleton.joint_count(), 3);
  EXPECT_EQ(arm.name, "arm");
  EXPECT_EQ(arm.skeleton.name(1), "Arm");
  EXPECT_EQ(arm.skeleton.name(2), "Arm_end");
  expect_near(arm.skeleton.rest_position(0), {0, 10, 0});
  expect_near(arm.skeleton.rest_position(2), {7, 10, 0});
  EXPECT_TRUE(arm.oddities.empty());
}

TEST(Bvh, FramesReplaceTheRootsOffsetAndTurnTheJoints) {
  const Character arm = read(kArm);
  ASSERT_EQ(arm.clips.size(), 1U);
  EXPECT_EQ(arm.clips[0].frame_count(), 2);
  EXPECT_DOUBLE_EQ(arm.clips[0].frame_time(1), 0.5);
  const std::vector<Vec3> at = compute_positions(arm.skeleton, frame_pose(arm, 1));
  expect_near(at[0], {1, 2, 3});
  expect_near(at[1], {1, 7, 3});   // the root turned by 90 degrees about Z
  expect_near(at[2], {-1, 7, 3});  // and the arm by 90 more
}

TEST(Bvh, MultipliesRotationsInEachJointsOwnOrder) {
  const Character arm = read(replaced(kArm, "1 2 3 90 0 0 0 0 90", "0 0 0 10 20 30 40 50 60"));
  const Pose pose = frame_pose(arm, 1);
  const Quat hips = from_euler({2, 0, 1}, Vec3(10, 20, 30) * kDegree),
             upper = from_euler({1, 0, 2}, Vec3(40, 50, 60) * kDegree);
  EXPECT_LT(pose.local[0].rotation.angularDistance(hips), 1e-12);
  EXPECT_LT(pose.local[1].rotation.angularDistance(upper), 1e-12);
}

TEST(Bvh, ReadsTheSameThroughEveryDialect) {
  const Character plain = read(kArm);
  const std::string text = kArm;
  const std::vector<std::string> dialects = {
      replaced(text, "\n", "\r\n"),
      replaced(text, "\n", "\r"),
      replaced(text, "  ", "\t"),
      replaced(text, " ", "   "),
      "\xEF\xBB\xBF" + text,
      replaced(replaced(text, "CHANNELS", "Channels"), "Zrotation", "ZROTATION"),
      replaced(text, "\n  {", " {"),
      replaced(text, "1 2 3 90 0 0", "1e0 2.0E+000 +3 9e1 \n -0 .0"),
      replaced(text, "0 0 0 0 0 0 0 0 0\n", "0 0 0 0 0 0 0 0 0  \n\n"),
      replaced(text, "Frames: 2", "Frames:\t2 "),
      replaced(text, "End Site", "End site"),
      text.substr(0, text.size() - 1),
  };
  for (const std::string& dialect : dialects) {
    const Character other = read(dialect);
    ASSERT_EQ(other.skeleton.joint_count(), 3) << dialect;
    EXPECT_EQ(other.skeleton.name(1), "Arm");
    ASSERT_EQ(other.clips.size(), 1U) << dialect;
    for (int frame = 0; frame < 2; ++frame) {
      const Pose a = frame_pose(plain, frame), b = frame_pose(other, frame);
      for (int i = 0; i < 3; ++i)
        expect_near(compute_positions(plain.skeleton, a)[i], compute_positions(other.skeleton, b)[i]);
    }
  }
}

TEST(Bvh, TakesRotationsBeforePositionsAndPositionsOnAnyJoint) {
  std::string text = replaced(kArm, "CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation",
                              "CHANNELS 6 Zrotation Xrotation Yrotation Xposition Yposition Zposition");
  text =
      replaced(text, "CHANNELS 3 Yrotation Xrotation Zrotation", "CHANNELS 4 Yposition Yrotation Xrotation Zrotation");
  text = replaced(text, "0 0 0 0 0 0 0 0 0\n1 2 3 90 0 0 0 0 90", "0 0 0 0 0 0 4 0 0 0\n90 0 0 1 2 3 4 0 0 0");
  const Character arm = read(text);
  const std::vector<Vec3> at = compute_positions(arm.skeleton, frame_pose(arm, 1));
  expect_near(at[0], {1, 2, 3});
  expect_near(at[1], {-3, 7, 3});  // (5, 4, 0) turned: x keeps its OFFSET
}

TEST(Bvh, AddsPositionsThatLieAboutZeroToTheOffsets) {
  std::string text = replaced(kArm, "CHANNELS 3 Yrotation Xrotation Zrotation",
                              "CHANNELS 6 Xposition Yposition Zposition Yrotation Xrotation Zrotation");
  text =
      replaced(text, "0 0 0 0 0 0 0 0 0\n1 2 3 90 0 0 0 0 90", "0 10 0 0 0 0 0 0 0 0 0 0\n0 10 0 0 0 0 0 0.5 0 0 0 0");
  const Character arm = read(text);
  EXPECT_EQ(arm.oddities.size(), 1U);
  expect_near(compute_positions(arm.skeleton, frame_pose(arm, 1))[1], {5, 10.5, 0});
}

TEST(Bvh, ReadsTheFramesThatAreThereAndNotesAnotherNumber) {
  const Character more = read(std::string(kArm) + "0 0 0 0 0 0 0 0 0\n");
  EXPECT_EQ(more.clips[0].frame_count(), 3);
  ASSERT_EQ(more.oddities.size(), 1U);
  EXPECT_EQ(more.oddities[0], "2 frames are announced, 3 are there");
  const Character none = read(replaced(kArm, "0 0 0 0 0 0 0 0 0\n1 2 3 90 0 0 0 0 90\n", ""));
  EXPECT_TRUE(none.clips.empty());
  EXPECT_EQ(none.oddities.size(), 1U);
  const Character stated =
      read(replaced(replaced(kArm, "0 0 0 0 0 0 0 0 0\n1 2 3 90 0 0 0 0 90\n", ""), "Frames: 2", "Frames: 0"));
  EXPECT_TRUE(stated.clips.empty());
  EXPECT_TRUE(stated.oddities.empty());
}

TEST(Bvh, LeavesOutABrokenRowOnlyBehindTheAnnouncedFrames) {
  const Character after = read(std::string(kArm) + "0 0 0\n");
  EXPECT_EQ(after.clips[0].frame_count(), 2);
  EXPECT_EQ(after.oddities.size(), 1U);
  EXPECT_EQ(error_of(replaced(kArm, "1 2 3 90 0 0 0 0 90", "1 2 3 90")).what(),
            std::string("line 20: the row that begins here is not a multiple of the 9 channels"));
}

TEST(Bvh, AnAnnouncedSizeIsNotTrusted) {
  EXPECT_EQ(read(replaced(kArm, "Frames: 2", "Frames: 2147483647")).clips[0].frame_count(), 2);
}

TEST(Bvh, ReadsOneJointAlone) {
  const Character one =
      read("HIERARCHY ROOT A { OFFSET 0 0 0 CHANNELS 1 Yrotation } MOTION\nFrames: 1\nFrame Time: .1\n90\n");
  EXPECT_EQ(one.skeleton.joint_count(), 1);
  EXPECT_EQ(one.skeleton.name(0), "A");
  const Character bare = read("HIERARCHY\nROOT A\n{\nOFFSET 1 2 3\n}\n");
  EXPECT_TRUE(bare.clips.empty());
  expect_near(bare.skeleton.rest_position(0), {1, 2, 3});
}

TEST(Bvh, JoinsSeveralRootsUnderAHelper) {
  const std::string text = kArm;
  const std::size_t begin = text.find("ROOT"), end = text.find("MOTION");
  std::string two = text.substr(0, end) + text.substr(begin, end - begin) + text.substr(end);
  two = replaced(replaced(two, "0 0 0 0 0 0 0 0 0\n", "0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0\n"), "1 2 3 90 0 0 0 0 90",
                 "1 2 3 90 0 0 0 0 90 4 5 6 0 0 0 0 0 0");
  const Character both = read(two);
  ASSERT_EQ(both.skeleton.joint_count(), 7);
  EXPECT_TRUE(both.skeleton.joint(0).helper);
  EXPECT_EQ(both.skeleton.name(6), "Arm_end2");
  const std::vector<Vec3> at = compute_positions(both.skeleton, frame_pose(both, 1));
  expect_near(at[1], {1, 2, 3});
  expect_near(at[5], {9, 5, 6});
}

TEST(Bvh, KeepsNamesWithSpacesAndUtf8AndMendsOthers) {
  EXPECT_EQ(read(replaced(kArm, "JOINT Arm", "JOINT 左 腕 {x}")).skeleton.name(1), "左 腕 {x}");
  EXPECT_EQ(read(replaced(kArm, "JOINT Arm", "JOINT")).skeleton.name(1), "");
  const Character latin = read(replaced(kArm, "JOINT Arm", "JOINT t\xeate"));
  EXPECT_EQ(latin.skeleton.name(1), "tête");
  EXPECT_EQ(latin.oddities.size(), 1U);
}

TEST(Bvh, NamesTheLineOfWhatIsWrong) {
  const auto expect_error = [](const std::string& text, const std::string& wanted) {
    const Error error = error_of(text);
    EXPECT_EQ(error.code(), ErrorCode::bad_file);
    EXPECT_EQ(std::string(error.what()).substr(0, wanted.size()), wanted);
  };
  expect_error("", "line 1: got the end of the file, wanted HIERARCHY");
  expect_error(replaced(kArm, "1 2 3 90", "1 2 nan 90"), "line 20: got 'nan', wanted a number");
  expect_error(replaced(kArm, "1 2 3 90", "1 2 1e300 90"), "line 20: '1e300' is too large");
  expect_error(replaced(kArm, "OFFSET 5 0 0", "OFFSET 5 0"), "line 9: got 'CHANNELS', wanted a number for OFFSET");
  expect_error(replaced(kArm, "OFFSET 5 0 0", ""), "line 14: the block of joint 'Arm' ends without an OFFSET");
  expect_error(replaced(kArm, "CHANNELS 3 Y", "CHANNELS 3 W"), "line 9: got 'Wrotation', wanted a channel");
  expect_error(replaced(kArm, "CHANNELS 3 Y", "CHANNELS 3 X"), "line 9: the channel Xrotation twice on joint 'Arm'");
  expect_error(replaced(kArm, "Frames: 2", "Frames: -2"), "line 17: got '-2', wanted the number of frames");
  expect_error(replaced(kArm, "Frame Time: 0.5", "Frame Time: 0,5"), "line 18: got '0,5', wanted the seconds");
}

TEST(Bvh, ATruncatedFileIsReadOrRefusedNeverHalf) {
  const std::string text = kArm;
  for (std::size_t length = 0; length < text.size(); ++length) {
    try {
      const Character cut = read(text.substr(0, length));
      cut.check();
      EXPECT_EQ(cut.skeleton.joint_count(), 3) << length;  // the hierarchy is whole, or the file is refused
      EXPECT_TRUE(cut.clips.empty() || length > text.find("0 0 0 0 0 0 0 0 0")) << length;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::bad_file) << length << error.what();
    }
  }
}

TEST(Bvh, RefusesAFrameTimeThatIsNone) {
  const Character arm = read(replaced(kArm, "Frame Time: 0.5", "Frame Time: 0"));
  EXPECT_NEAR(arm.clips[0].frame_time(1), 1.0 / 30.0, 1e-12);
  EXPECT_EQ(arm.oddities.size(), 1U);
}

TEST(BvhFiles, EveryRealFileIsReadWhole) {
  const auto files = data_files("bvh");
  if (files.empty()) GTEST_SKIP() << "no shared data";
  for (const auto& path : files) {
    SCOPED_TRACE(path.filename().string());
    const Character character = read_bvh(load_bytes(path), path.filename().string());
    EXPECT_GE(character.skeleton.joint_count(), 3);
    ASSERT_EQ(character.clips.size(), 1U);
    EXPECT_EQ(character.source->bytes.size(), std::filesystem::file_size(path));
  }
}

TEST(BvhFiles, RecognisesTheHumanoidAndTellsTheUnitThatWasMeant) {
  const auto remark = [](const char* name) {
    const auto path = data_file(name);
    const Character character = read_bvh(load_bytes(*path), name);
    EXPECT_TRUE(character.humanoid.is_humanoid()) << name;
    return character.oddities.empty() ? std::string() : character.oddities.back();
  };
  if (!data_file("bvh/cmu_01_01.bvh")) GTEST_SKIP() << "no shared data";
  EXPECT_NE(remark("bvh/bandai1_walk_normal_001.bvh").find("looks like centimetres"), std::string::npos);
  EXPECT_NE(remark("bvh/bva_example1.bvh").find("looks like inches"), std::string::npos);
  EXPECT_NE(remark("bvh/cmu_01_01.bvh").find("looks like a unit of its own"), std::string::npos);
}

TEST(BvhFiles, ThreeThousandAndSeventyFramesWhereOneLessIsAnnounced) {
  const auto path = data_file("bvh/motionbank_boxing_toes.bvh");
  if (!path) GTEST_SKIP() << "no shared data";
  const Character character = read_bvh(load_bytes(*path), "boxing.bvh");
  EXPECT_EQ(character.clips[0].frame_count(), 3070);
}

TEST(BvhFiles, TheDamagedFileKeepsItsAnnouncedFrames) {
  const auto path = data_file("malformed/bvh/ragged_rows.bvh");
  if (!path) GTEST_SKIP() << "no shared data";
  const Character character = read_bvh(load_bytes(*path), "ragged_rows.bvh");
  EXPECT_EQ(character.clips[0].frame_count(), 433);
  ASSERT_FALSE(character.oddities.empty());
  EXPECT_NE(character.oddities[0].find("is left out"), std::string::npos);
}

}  // namespace
}  // namespace croquis
