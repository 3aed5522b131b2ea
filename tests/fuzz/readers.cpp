// SPDX-License-Identifier: MIT
#include "fuzz/readers.h"

#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "croquis/base/error.h"
#include "croquis/io/bvh.h"
#include "croquis/io/camera_json.h"
#include "croquis/io/character_file.h"
#include "croquis/io/svg.h"

namespace croquis {
namespace {

void require(bool holds, const std::string& promise) {
  if (!holds) throw std::logic_error("broken promise: " + promise);
}

std::span<const std::byte> bytes_of(const std::string& text) {
  return {reinterpret_cast<const std::byte*>(text.data()), text.size()};
}

/// Runs a reader; false if it ended in an Error that blames the file, as it may.
bool reads(const std::function<void()>& read) {
  try {
    read();
    return true;
  } catch (const Error& error) {
    const bool blames_file =
        error.code() == ErrorCode::bad_file || error.code() == ErrorCode::unsupported || error.code() == ErrorCode::io;
    require(blames_file,
            std::string("a reader ended in ") + std::string(to_string(error.code())) + ": " + error.what());
    require(std::string_view(error.what()).find('\n') == std::string_view::npos, "a message is one line");
    return false;
  }
}

void check_character(const Character& character) {
  character.check();
  require(character.front.allFinite(), "the front is finite");
  for (int i = 0; i < character.skeleton.joint_count(); ++i) {
    require(character.skeleton.rest_model(i).matrix().allFinite(), "the rest pose is finite");
  }
}

}  // namespace

bool fuzz_bvh(std::span<const std::byte> bytes) {
  std::optional<Character> character;
  if (!reads([&] { character = read_bvh(bytes, "fuzz.bvh"); })) return false;
  check_character(*character);
  Pose pose = character->start;
  if (!character->clips.empty()) pose = sample_pose(character->clips[0], 0.0, pose);
  std::optional<Bytes> written;
  if (!reads([&] { written = write_bvh(*character, pose, {.add_positions = true}); })) return true;
  const Character again = read_bvh(*written, "again.bvh");
  require(again.skeleton.joint_count() == character->skeleton.joint_count(), "a BVH comes back with its joints");
  return true;
}

bool fuzz_camera(std::span<const std::byte> bytes) {
  Camera camera;
  if (!reads([&] { camera = read_camera(bytes); })) return false;
  const Camera again = read_camera(bytes_of(write_camera(camera)));
  require(again.position == camera.position && again.target == camera.target && again.up == camera.up &&
              again.fov_degrees == camera.fov_degrees && again.height == camera.height &&
              again.width_px == camera.width_px && again.height_px == camera.height_px,
          "a camera comes back as it was");
  require(camera.view_from_world().matrix().allFinite(), "a camera's view is finite");
  return true;
}

bool fuzz_gltf(std::span<const std::byte> bytes) {
  const ResourceReader none = [](std::string_view) -> Bytes { throw Error(ErrorCode::io, "no other file is there"); };
  std::optional<Character> character;
  if (!reads([&] { character = read_character(bytes, "fuzz.gltf", none); })) return false;
  check_character(*character);
  std::vector<BakedPart> parts;
  for (const Part& part : character->parts) parts.push_back({part.mesh.positions, part.mesh.normals});
  for (const PoseForm form : {PoseForm::pose, PoseForm::clip, PoseForm::baked}) {
    WrittenFile written;
    const auto write = [&] {
      written = write_character(*character, character->start, "glb", "fuzz.glb", {.form = form, .baked = parts});
    };
    if (!reads(write)) continue;
    std::optional<Character> again;
    reads([&] { again = read_character(written.bytes, "fuzz.glb", none); });
    // A baked file has no skin, so that its reader may look at animations that the source's reader had no need of.
    require(again.has_value() || form == PoseForm::baked, "what was written is read");
    if (again) check_character(*again);
  }
  return true;
}

bool fuzz_svg(std::span<const std::byte> bytes) {
  constexpr int kWidth = 640, kHeight = 480;
  std::vector<Stroke> strokes;
  if (!reads([&] { strokes = read_svg_strokes(bytes, kWidth, kHeight); })) return false;
  for (const Stroke& stroke : strokes) {
    require(stroke.samples.size() >= 2, "a stroke has two samples or more");
    for (const StrokeSample& sample : stroke.samples) require(sample.position.allFinite(), "samples are finite");
  }
  const std::string text = write_svg_strokes(strokes, kWidth, kHeight);
  std::vector<Stroke> again;
  // Points that differ in their last digit alone may fall together in the text, so some strokes may go.
  reads([&] { again = read_svg_strokes(bytes_of(text), kWidth, kHeight); });
  require(again.size() <= strokes.size(), "no stroke comes from nowhere");
  return true;
}

}  // namespace croquis
