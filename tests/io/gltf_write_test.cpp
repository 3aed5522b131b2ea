// SPDX-License-Identifier: MIT
#include "croquis/io/gltf_write.h"

#include "io/written_files.h"
#include "support/random_math.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "croquis/base/error.h"
#include "croquis/io/glb_container.h"
#include "croquis/io/json_place.h"
#include "croquis/math/rotation.h"

namespace croquis {
namespace {

Json json_of(const Bytes& bytes) {
  const std::string_view text = is_glb(bytes)
                                    ? parse_glb(bytes).json
                                    : std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  return Json::parse(text);
}

/// Members in any order: what JSON-equal means.
nlohmann::json unordered(const Json& json) { return nlohmann::json::parse(json.dump()); }

std::string own_format(const Character& character) { return character.source->format; }

/// Every third joint turned, every seventh moved.
Pose random_pose(const Character& character, std::uint64_t seed) {
  Random random(seed);
  Pose pose = character.start;
  for (std::size_t i = 0; i < pose.local.size(); i += 3) {
    pose.local[i].rotation = pose.local[i].rotation * rotation_from_vector(0.2 * random_vector(random));
    if (i % 7 == 0) pose.local[i].translation += 0.01 * random_vector(random);
  }
  return pose;
}

double largest_difference(const Character& a, const Pose& pose_a, const Character& b, const Pose& pose_b) {
  const auto pa = compute_positions(a.skeleton, pose_a), pb = compute_positions(b.skeleton, pose_b);
  double largest = pa.size() == pb.size() ? 0.0 : 1e30;
  for (std::size_t i = 0; i < pa.size() && i < pb.size(); ++i) largest = std::max(largest, (pa[i] - pb[i]).norm());
  return largest / a.skeleton.extent();
}

/// Everything a reader sees but for the pose.
void expect_same_body(const Character& a, const Character& b) {
  ASSERT_EQ(a.skeleton.joint_count(), b.skeleton.joint_count());
  for (int i = 0; i < a.skeleton.joint_count(); ++i) {
    EXPECT_EQ(a.skeleton.name(i), b.skeleton.name(i));
    EXPECT_EQ(a.skeleton.parent(i), b.skeleton.parent(i));
    EXPECT_EQ(a.skeleton.joint(i).helper, b.skeleton.joint(i).helper) << i;
  }
  ASSERT_EQ(a.parts.size(), b.parts.size());
  for (std::size_t i = 0; i < a.parts.size(); ++i) {
    const Part &p = a.parts[i], &q = b.parts[i];
    EXPECT_EQ(p.name, q.name);
    EXPECT_EQ(p.mesh.positions, q.mesh.positions);
    EXPECT_EQ(p.mesh.triangles, q.mesh.triangles);
    EXPECT_EQ(p.mesh.uvs, q.mesh.uvs);
    ASSERT_EQ(p.shapes.size(), q.shapes.size());
    ASSERT_EQ(p.skin.has_value(), q.skin.has_value());
    if (p.skin) {
      EXPECT_EQ(p.skin->weights, q.skin->weights);
    }
    EXPECT_EQ(p.material.base_color, q.material.base_color);
    ASSERT_EQ(p.material.base_color_image == nullptr, q.material.base_color_image == nullptr);
    if (p.material.base_color_image) {
      EXPECT_EQ(*p.material.base_color_image, *q.material.base_color_image);
    }
  }
  ASSERT_EQ(a.clips.size(), b.clips.size());
  for (std::size_t i = 0; i < a.clips.size(); ++i) {
    EXPECT_EQ(a.clips[i].name, b.clips[i].name);
    EXPECT_EQ(a.clips[i].curves.size(), b.clips[i].curves.size());
  }
}

class GltfWrite : public testing::TestWithParam<std::filesystem::path> {
 protected:
  [[nodiscard]] std::string stem() const {
    const std::string folder = GetParam().parent_path().filename().string();
    return (folder == "gltf" || folder == "vrm" ? "" : folder + "_") + GetParam().stem().string();
  }
};

TEST_P(GltfWrite, AnUnchangedPoseGivesTheFileBack) {
  const Character character = read_from(GetParam());
  const WrittenFile file = write_character(character, character.start, own_format(character), GetParam().string());
  EXPECT_EQ(unordered(json_of(file.bytes)), unordered(json_of(character.source->bytes)));
  EXPECT_EQ(file.companions, character.source->resources);
  if (is_glb(file.bytes)) {
    const auto was = parse_glb(character.source->bytes).binary, is = parse_glb(file.bytes).binary;
    EXPECT_TRUE(std::equal(is.begin(), is.end(), was.begin(), was.begin() + std::ssize(is)));
  }
}

TEST_P(GltfWrite, APoseChangesOnlyTheNodesThatMoved) {
  const Character character = read_from(GetParam());
  const Pose pose = random_pose(character, 1);
  const WrittenFile file = write_character(character, pose, own_format(character), GetParam().string());
  keep_for_validator(file, "pose/" + stem() + "." + own_format(character), GetParam().string());
  Json was = json_of(character.source->bytes), is = json_of(file.bytes);
  for (std::size_t joint = 0; joint < pose.local.size(); joint += 3) {
    const int node = character.source_nodes[joint];
    for (const char* member : {"translation", "rotation", "scale", "matrix"}) {
      if (node < 0) continue;
      was["nodes"][static_cast<std::size_t>(node)].erase(member);
      is["nodes"][static_cast<std::size_t>(node)].erase(member);
    }
  }
  const Character back = read_back(file, GetParam().string());
  if (character.source_nodes[0] < 0) {  // the root above several roots was moved: it became a node
    ASSERT_EQ(is["nodes"].size(), was["nodes"].size() + 1);
  } else {
    EXPECT_EQ(unordered(is), unordered(was));
    EXPECT_LT(largest_difference(character, pose, back, back.start), 1e-12);
  }
}

TEST_P(GltfWrite, AClipLeavesTheNodesAndAddsOneAnimation) {
  const Character character = read_from(GetParam());
  Pose pose = random_pose(character, 2);
  if (character.source_nodes[0] < 0) pose.local[0] = Transform();
  const WrittenFile file =
      write_character(character, pose, own_format(character), GetParam().string(), {.form = PoseForm::clip});
  keep_for_validator(file, "clip/" + stem() + "." + own_format(character), GetParam().string());
  const Character back = read_back(file, GetParam().string());
  ASSERT_EQ(back.clips.size(), character.clips.size() + 1);
  EXPECT_EQ(back.clips.back().frame_count(), 1);
  EXPECT_LT(largest_difference(character, character.start, back, back.start), 1e-9);
  // A clip moves what it moves in the nodes that it names; a file without a skin or clips reads as the same joints.
  if (back.skeleton.joint_count() == character.skeleton.joint_count()) {
    EXPECT_LT(largest_difference(character, pose, back, sample_pose(back.clips.back(), 0.0, back.start)), 1e-6);
  }
  const Json was = json_of(character.source->bytes), is = json_of(file.bytes);
  for (const char* array : {"meshes", "materials", "skins", "images", "extensions", "extras", "scenes"}) {
    EXPECT_EQ(was.value(array, Json()), is.value(array, Json())) << array;
  }
}

TEST_P(GltfWrite, AnotherContainerHoldsTheSameCharacter) {
  const Character character = read_from(GetParam());
  for (const std::string format : {"glb", "gltf"}) {
    const std::string name = "out." + format;
    const WrittenFile file = write_character(character, character.start, format, name);
    keep_for_validator(file, "convert/" + stem() + "_" + format + "/" + name, GetParam().string());
    EXPECT_EQ(is_glb(file.bytes), format == "glb");
    if (format == "glb" && own_format(character) == "gltf") {
      EXPECT_TRUE(file.companions.empty());
    }
    const Character back = read_back(file, name);
    expect_same_body(character, back);
    EXPECT_LT(largest_difference(character, character.start, back, back.start), 1e-12);
    const Json was = json_of(character.source->bytes), is = json_of(file.bytes);
    for (const char* array : {"asset", "scenes", "nodes", "meshes", "materials", "skins", "textures", "accessors",
                              "animations", "extensions", "extras", "extensionsUsed", "extensionsRequired"}) {
      EXPECT_EQ(was.value(array, Json()), is.value(array, Json())) << array;
    }
  }
}

TEST_P(GltfWrite, ABakedFileHoldsTheGivenVertices) {
  const Character character = read_from(GetParam());
  WriteOptions options{.form = PoseForm::baked};
  for (const Part& part : character.parts) {
    BakedPart baked{part.mesh.positions, part.mesh.normals, part.mesh.tangents, {}};
    for (Vec3f& position : baked.positions) position = 2.0F * position + Vec3f(0.0F, 1.0F, 0.0F);
    options.baked.push_back(std::move(baked));
  }
  const WrittenFile file =
      write_character(character, character.start, own_format(character), GetParam().string(), options);
  keep_for_validator(file, "baked/" + stem() + "." + own_format(character), GetParam().string());
  const Character back = read_back(file, GetParam().string());
  ASSERT_EQ(back.parts.size(), character.parts.size());
  const auto model = compute_model_transforms(back.skeleton, back.start);
  for (std::size_t i = 0; i < back.parts.size(); ++i) {
    const Part& part = back.parts[i];
    ASSERT_FALSE(part.skin);
    const Affine place = model[static_cast<std::size_t>(part.joint)] * part.joint_from_mesh;
    const auto& wanted = options.baked[i].positions;
    ASSERT_EQ(part.mesh.positions.size(), wanted.size());
    double size = 1e-3, off = 0.0;
    for (std::size_t v = 0; v < wanted.size(); ++v) {
      size = std::max(size, static_cast<double>(wanted[v].norm()));
      off = std::max(off, (place * part.mesh.positions[v].cast<double>() - wanted[v].cast<double>()).norm());
    }
    EXPECT_LT(off, 1e-5 * size) << part.name;
    for (const float weight : part.shape_weights) EXPECT_EQ(weight, 0.0F);
  }
}

TEST_P(GltfWrite, ANewFileHoldsTheSameCharacter) {
  Character character = read_from(GetParam());
  character.source = nullptr;
  const Pose pose = random_pose(character, 3);
  for (const PoseForm form : {PoseForm::pose, PoseForm::clip}) {
    const WrittenFile file = write_character(character, pose, "glb", "new.glb", {.form = form});
    keep_for_validator(file, (form == PoseForm::pose ? "new_pose/" : "new_clip/") + stem() + ".glb", "");
    const Character back = read_back(file, "new.glb");
    const std::size_t clips = static_cast<std::size_t>(std::count_if(
        character.clips.begin(), character.clips.end(), [](const Clip& clip) { return !clip.curves.empty(); }));
    EXPECT_EQ(back.clips.size(), clips + (form == PoseForm::clip ? 1 : 0));
    ASSERT_EQ(back.parts.size(),
              static_cast<std::size_t>(std::count_if(character.parts.begin(), character.parts.end(),
                                                     [](const Part& p) { return !p.mesh.triangles.empty(); })));
    if (back.skeleton.joint_count() != character.skeleton.joint_count()) continue;  // rigid animated carriers
    const Pose& shown = form == PoseForm::pose ? back.start : sample_pose(back.clips.back(), 0.0, back.start);
    EXPECT_LT(largest_difference(character, pose, back, shown), form == PoseForm::pose ? 1e-12 : 1e-6);
  }
}

/// The large files only where CROQUIS_FULL asks for them: they take as long as all the others.
std::vector<std::filesystem::path> some_files() {
  std::vector<std::filesystem::path> files;
  for (const auto& path : good_gltf_files()) {
    if (std::filesystem::file_size(path) < 500'000 || std::getenv("CROQUIS_FULL") != nullptr) files.push_back(path);
  }
  return files;
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(GltfWrite);
INSTANTIATE_TEST_SUITE_P(Files, GltfWrite, testing::ValuesIn(some_files()), [](const auto& file) {
  std::string name = file.param.stem().string();
  for (char& c : name) c = std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
  return name;
});

}  // namespace
}  // namespace croquis
