// SPDX-License-Identifier: MIT
#include "support/data.h"
#include "support/test_rigs.h"
#include <numeric>

#include <gtest/gtest.h>

#include "croquis/base/error.h"
#include "croquis/base/text.h"
#include "croquis/io/bvh.h"
#include "croquis/io/bvh_text.h"

namespace croquis {
namespace {

std::string text_of(const Bytes& bytes) { return {reinterpret_cast<const char*>(bytes.data()), bytes.size()}; }

Character from_text(std::string_view text) { return read_bvh(bytes_of(text), "test.bvh"); }

Character without_source(const Skeleton& skeleton) {
  return Character{.name = "made", .skeleton = skeleton, .start = rest_pose(skeleton)};
}

/// The pose of the only frame.
Pose only_frame(const Character& character) {
  EXPECT_EQ(character.clips.size(), 1U);
  EXPECT_EQ(character.clips.front().frame_count(), 1);
  return sample_pose(character.clips.front(), 0.0, rest_pose(character.skeleton));
}

/// Joints of one name in both must stand at one place, to `tolerance` of the body's size.
void expect_same_places(const Character& before, const Pose& pose, const Character& after, double tolerance) {
  const std::vector<Vec3> a = compute_positions(before.skeleton, pose);
  const std::vector<Vec3> b = compute_positions(after.skeleton, only_frame(after));
  int compared = 0;
  for (int i = 0; i < before.skeleton.joint_count(); ++i) {
    const std::vector<int> same = after.skeleton.find(before.skeleton.name(i));
    if (before.skeleton.joint(i).helper || before.skeleton.find(before.skeleton.name(i)).size() != 1) continue;
    ASSERT_EQ(same.size(), 1U) << before.skeleton.name(i);
    const double off = (a[static_cast<std::size_t>(i)] - b[static_cast<std::size_t>(same[0])]).norm();
    ASSERT_LT(off, tolerance * before.skeleton.extent()) << before.skeleton.name(i);
    ++compared;
  }
  EXPECT_GT(compared, 0);
}

const char* const kTwo =
    "HIERARCHY\r\nROOT  Hüfte \r\n{\r\n\tOFFSET 0.10 9e1\t0\r\n\tCHANNELS 6 Zrotation Xrotation Yrotation "
    "Xposition Yposition Zposition\r\n"
    "\tJOINT B\r\n\t{\r\n\t\tOFFSET 1 0 0\r\n\t\tCHANNELS 3 Yrotation Zrotation Xrotation\r\n"
    "\t\tEnd Site\r\n\t\t{\r\n\t\t\tOFFSET 0 2 0\r\n\t\t}\r\n\t}\r\n}\r\n";

TEST(BvhWriter, KeepsTheHierarchyOfABvhByteForByteAndWritesOneFrame) {
  const Character two = from_text(
      std::string(kTwo) + "MOTION\r\nFrames: 2\r\nFrame Time: .0083333\r\n0 0 0 0 0 0 0 0 0\r\n1 2 3 4 5 6 7 8 9\r\n");
  Pose pose = rest_pose(two.skeleton);
  pose.local[0].translation = Vec3(1, 2, 3);
  pose.local[1].rotation = from_euler({1, 2, 0}, Vec3(10, 20, 30) * kDegree);
  EXPECT_EQ(text_of(write_bvh(two, pose)),
            std::string(kTwo) + "MOTION\r\nFrames: 1\r\nFrame Time: .0083333\r\n0 0 0 1 2 3 10 20 30\r\n");
}

TEST(BvhWriter, WritesAtLeastNineDigits) {
  const Character two = from_text(kTwo);
  Pose pose = rest_pose(two.skeleton);
  pose.local[0].translation = Vec3(1.0 / 3.0, 200.0 / 3.0, -1e-5 / 3.0);
  const Pose after = only_frame(read_bvh(write_bvh(two, pose), "again.bvh"));
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(after.local[0].translation[axis] / pose.local[0].translation[axis], 1.0, 1e-9);
  }
}

TEST(BvhWriter, SaysAPoseOfAnotherBvhInItsOwnOrders) {
  Random random(7);
  const Character two = from_text(kTwo);
  for (int i = 0; i < 200; ++i) {
    Pose pose = random_pose(two.skeleton, random, 3.0);
    if (i % 4 == 0)
      pose.local[1].rotation =
          from_euler({1, 2, 0}, Vec3(random.uniform(-3, 3), (i % 8 == 0 ? 0.5 : -0.5) * kPi, random.uniform(-3, 3)));
    const Pose after = only_frame(read_bvh(write_bvh(two, pose), "again.bvh"));
    for (const std::size_t joint : {0U, 1U}) {
      const Mat3 a = pose.local[joint].rotation.toRotationMatrix(), b = after.local[joint].rotation.toRotationMatrix();
      EXPECT_LT((a - b).norm(), 5e-9) << i;
    }
  }
}

TEST(BvhWriter, RefusesAStretchedBoneUnlessPositionsMayBeAdded) {
  const Character two = from_text(kTwo);
  Pose pose = rest_pose(two.skeleton);
  pose.local[1].translation.x() = 1.5;
  pose.local[2].translation.y() = 2.5;
  try {
    (void)write_bvh(two, pose);
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::unsupported);
    EXPECT_NE(std::string(error.what()).find("joint 'B' stands off its bone by 0.5"), std::string::npos)
        << error.what();
  }
  const Bytes bytes = write_bvh(two, pose, {.add_positions = true});
  const std::string text = text_of(bytes);
  EXPECT_NE(text.find("CHANNELS 6 Xposition Yposition Zposition Yrotation Zrotation Xrotation\r\n"), std::string::npos)
      << text;
  EXPECT_NE(text.find("OFFSET 0 2.5 0\r\n"), std::string::npos) << text;
  expect_same_places(two, pose, read_bvh(bytes, "again.bvh"), 1e-9);
}

TEST(BvhWriter, AddsOnlyTheAxesThatAreMissingAndChannelsWhereThereAreNone) {
  const Character bones =
      from_text("HIERARCHY\nROOT A\n{\nOFFSET 0 0 0\nJOINT B\n{\nOFFSET 1 0 0\nCHANNELS 2 Zrotation Yposition\n}\n}\n");
  Pose pose = rest_pose(bones.skeleton);
  pose.local[0].translation = Vec3(1, 2, 3);
  pose.local[1].translation = Vec3(2, 3, 4);
  const Bytes bytes = write_bvh(bones, pose, {.add_positions = true});
  EXPECT_NE(text_of(bytes).find("OFFSET 0 0 0\nCHANNELS 3 Xposition Yposition Zposition\nJOINT B"), std::string::npos);
  EXPECT_NE(text_of(bytes).find("CHANNELS 4 Xposition Zposition Zrotation Yposition"), std::string::npos);
  expect_same_places(bones, pose, read_bvh(bytes, "again.bvh"), 1e-9);
}

TEST(BvhWriter, RefusesATurnThatAHingeCannotHold) {
  const Character hinge = from_text(
      "HIERARCHY\nROOT A\n{\nOFFSET 0 0 0\nCHANNELS 1 Yrotation\nJOINT B\n{\nOFFSET 1 0 0\nCHANNELS 0\n}\n}\n");
  Pose pose = rest_pose(hinge.skeleton);
  pose.local[0].rotation = rotation_from_vector(Vec3(0, 3.0, 0));
  expect_same_places(hinge, pose, read_bvh(write_bvh(hinge, pose), "again.bvh"), 1e-8);
  pose.local[0].rotation = rotation_from_vector(Vec3(0.2, 0, 0));
  EXPECT_THROW((void)write_bvh(hinge, pose), Error);
}

TEST(BvhWriter, AddedPositionsStayAdded) {
  const Character added = from_text(
      "HIERARCHY\nROOT A\n{\nOFFSET 0 0 0\nCHANNELS 3 Xposition Yposition Zposition\nJOINT B\n{\nOFFSET 1 0 0\n"
      "CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\n}\n}\nMOTION\nFrames: 1\nFrame Time: 1\n"
      "0 0 0 0 0 0 0 0 0\n");
  Pose pose = rest_pose(added.skeleton);
  pose.local[1].translation.y() = 0.05;
  const std::string text = text_of(write_bvh(added, pose));
  EXPECT_NE(text.find("\n0 0 0 0 0.05 0 0 0 0\n"), std::string::npos) << text;
}

TEST(BvhWriter, MakesABvhOfAnyRigWhateverItsRestOrientations) {
  Random random(3);
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    for (const Skeleton& skeleton : {make_test_humanoid(seed), make_test_quadruped(seed), make_chain(1, 0.1, seed)}) {
      const Character made = without_source(skeleton);
      Pose pose = random_pose(skeleton, random, 1.5);
      pose.local[0].translation += random_vector(random);
      const Character after = read_bvh(write_bvh(made, pose), "made.bvh");
      expect_same_places(made, pose, after, 1e-7);
      for (int i = 0; i < after.skeleton.joint_count(); ++i) {
        const std::vector<int> same = skeleton.find(after.skeleton.name(i));
        if (same.size() != 1) continue;
        EXPECT_LT((after.skeleton.rest_position(i) - skeleton.rest_position(same[0])).norm(), 1e-8);
      }
    }
  }
}

TEST(BvhWriter, WritesZxyWithPositionsOnTheRootAndEndSites) {
  const std::string text = text_of(write_bvh(without_source(make_chain(2)), rest_pose(make_chain(2))));
  EXPECT_EQ(text,
            "HIERARCHY\nROOT joint0\n{\n\tOFFSET 0 0 0\n"
            "\tCHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\n\tJOINT joint1\n\t{\n"
            "\t\tOFFSET 0 0.1 0\n\t\tCHANNELS 3 Zrotation Xrotation Yrotation\n\t\tEnd Site\n\t\t{\n"
            "\t\t\tOFFSET 0 0.05 0\n\t\t}\n\t}\n}\nMOTION\nFrames: 1\nFrame Time: 0.0333333\n0 0 0 0 0 0 0 0 0\n");
}

/// Scene > armature (turned and scaled like a file in centimetres, Z up) > bones.
Skeleton make_armature(double scale_y) {
  std::vector<Joint> joints(6);
  joints[0] = {.name = "Scene", .helper = true};
  joints[1] = {.name = "Armature", .parent = 0, .helper = true};
  joints[1].rest.rotation = rotation_from_vector(Vec3(-0.5 * kPi, 0, 0));
  joints[1].rest.scale = Vec3(0.01, 0.01 * scale_y, 0.01);
  joints[2] = {.name = "Body mesh", .parent = 0, .helper = true};
  joints[3] = {.name = "my hips", .parent = 1, .rest = {.translation = Vec3(0, 0, 90)}};
  joints[4] = {.name = "", .parent = 3, .rest = {.translation = Vec3(0, 20, 30), .scale = Vec3(-1, 1, 1)}};
  joints[5] = {.name = "my hips", .parent = 4, .rest = {.translation = Vec3(10, 20, 30)}};
  return Skeleton(joints);
}

TEST(BvhWriter, LeavesOutHelpersAndMendsNames) {
  const Skeleton skeleton = make_armature(1.0);
  Random random(5);
  const Pose pose = random_pose(skeleton, random, 1.0);
  const Character after = read_bvh(write_bvh(without_source(skeleton), pose), "armature.bvh");
  ASSERT_EQ(after.skeleton.joint_count(), 4);
  EXPECT_EQ(after.skeleton.name(0), "my_hips");
  EXPECT_EQ(after.skeleton.name(1), "joint_4");
  EXPECT_EQ(after.skeleton.name(2), "my_hips_2");
  const std::vector<Vec3> a = compute_positions(skeleton, pose),
                          b = compute_positions(after.skeleton, only_frame(after));
  for (const std::size_t i : {0U, 1U, 2U}) EXPECT_LT((a[i + 3] - b[i]).norm(), 1e-9);
  EXPECT_LT((after.skeleton.rest_position(0) - Vec3(0, 0.9, 0)).norm(), 1e-9);
}

TEST(BvhWriter, AScaleThatIsNotUniformNeedsPositionsOnceTheBodyTurns) {
  const Skeleton skeleton = make_armature(2.0);
  Pose pose = rest_pose(skeleton);
  EXPECT_NO_THROW((void)write_bvh(without_source(skeleton), pose));
  pose.local[3].rotation = rotation_from_vector(Vec3(1.0, 0, 0));
  EXPECT_THROW((void)write_bvh(without_source(skeleton), pose), Error);
  const Character after = read_bvh(write_bvh(without_source(skeleton), pose, {.add_positions = true}), "armature.bvh");
  const std::vector<Vec3> a = compute_positions(skeleton, pose),
                          b = compute_positions(after.skeleton, only_frame(after));
  for (const std::size_t i : {0U, 1U, 2U}) EXPECT_LT((a[i + 3] - b[i]).norm(), 1e-8);
}

TEST(BvhWriter, ABakedPoseHasNoPlaceInABvh) {
  const Character two = from_text(kTwo);
  EXPECT_THROW((void)write_bvh(two, two.start, {.form = PoseForm::baked}), Error);
}

TEST(BvhWriter, AChainOfManyThousandJointsStaysAFileOfReasonableSize) {
  const Skeleton skeleton = make_chain(5000, 1e-4);
  const Bytes bytes = write_bvh(without_source(skeleton), rest_pose(skeleton));
  EXPECT_LT(bytes.size(), 5'000'000U);
  EXPECT_EQ(read_bvh(bytes, "snake.bvh").skeleton.joint_count(), 5001);
}

TEST(BvhFiles, PosesOfTheirClipsComeBackThroughAFile) {
  const auto files = data_files("bvh");
  if (files.empty()) GTEST_SKIP() << "no shared data";
  for (const auto& path : files) {
    SCOPED_TRACE(path.filename().string());
    const std::vector<std::byte> bytes = load_bytes(path);
    const Character character = read_bvh(bytes, path.filename().string());
    const std::size_t end = parse_bvh(bytes, 1).hierarchy_end;
    const Clip& clip = character.clips.front();
    for (const int frame : {0, clip.frame_count() / 2}) {
      const Pose pose = sample_pose(clip, clip.frame_time(frame), rest_pose(character.skeleton));
      const Bytes written = write_bvh(character, pose);
      EXPECT_EQ(text_of(written).substr(0, end), text_of(bytes).substr(0, end));
      expect_same_places(character, pose, read_bvh(written, "again.bvh"), 1e-7);
      Character sourceless = character;
      sourceless.source = nullptr;
      expect_same_places(sourceless, pose, read_bvh(write_bvh(sourceless, pose, {.add_positions = true}), "other.bvh"),
                         5e-6);  // what is less than a millionth of the body's size is no stretch
    }
  }
}

TEST(BvhFiles, RandomPosesComeBackThroughAFile) {
  const auto files = data_files("bvh");
  if (files.empty()) GTEST_SKIP() << "no shared data";
  Random random(11);
  for (const auto& path : files) {
    SCOPED_TRACE(path.filename().string());
    const Character character = read_bvh(load_bytes(path), path.filename().string());
    const Pose pose = random_pose(character.skeleton, random, 2.0);
    expect_same_places(character, pose, read_bvh(write_bvh(character, pose), "again.bvh"), 1e-7);
  }
}

}  // namespace
}  // namespace croquis
