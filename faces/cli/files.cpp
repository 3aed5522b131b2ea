// SPDX-License-Identifier: MIT
#include "cli/files.h"

#include <memory>
#include <optional>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/base/text.h"
#include "croquis/edit/commands.h"
#include "croquis/edit/frame.h"
#include "croquis/io/camera_json.h"
#include "croquis/io/character_file.h"
#include "croquis/io/disk.h"
#include "croquis/io/svg.h"

namespace croquis::cli {
namespace {

/// Runs `work`; an Error that it throws gets `file` in front, so that the message says where.
template <class Work>
auto naming(const std::string& file, Work work) -> decltype(work()) {
  try {
    return work();
  } catch (const Error& error) {
    const std::string text = error.what();
    if (text.find(file) != std::string::npos) throw;
    throw Error(error.code(), file + ": " + text);
  }
}

Character read_from_disk(const std::string& file) {
  const Bytes bytes = read_file(file);
  return naming(file, [&] { return read_character(bytes, file, resources_beside(file)); });
}

}  // namespace

Project load_project(const std::string& file, const Proportions& proportions) {
  if (is_builtin_character(file)) return add_builtin_character({}, file, proportions);
  if (file_format(file) == "croquis") {
    const Bytes bytes = read_file(file);
    Project project = naming(file, [&] { return read_project(bytes, file); });
    if (project.actors.empty()) throw Error(ErrorCode::bad_file, file + ": the project holds no character");
    return project;
  }
  return add_character({}, std::make_shared<const Character>(read_from_disk(file)));
}

Project at_frame(Project project, int frame, const std::string& file) {
  return naming(file, [&] {
    Actor& actor = project.actors.front();
    actor.character = std::make_shared<const Character>(character_at_frame(*actor.character, frame));
    actor.pose = actor.character->start;
    return project;
  });
}

Camera load_camera(const std::string& file) {
  const Bytes bytes = read_file(file);
  return naming(file, [&] {
    const Camera camera = read_camera(bytes);
    camera.check();
    return camera;
  });
}

std::vector<Stroke> load_strokes(const std::string& file, const Camera& camera) {
  const Bytes bytes = read_file(file);
  return naming(file, [&] {
    std::vector<Stroke> strokes = read_svg_strokes(bytes, camera.width_px, camera.height_px);
    for (const Stroke& stroke : strokes) check_stroke(stroke, camera);
    return strokes;
  });
}

Character load_start(const std::string& file_and_frame) {
  std::string file = file_and_frame;
  std::optional<int> frame;
  if (const auto colon = file.rfind(':'); colon != std::string::npos && colon > 0) {
    const std::string digits = file.substr(colon + 1);
    if (!digits.empty() && digits.find_first_not_of("0123456789") == std::string::npos) {
      frame = parse_int(digits);
      if (!frame) throw_invalid_argument("--start " + file_and_frame + ": there is no frame " + digits);
      file.resize(colon);
    }
  }
  Character character = is_builtin_character(file) ? make_builtin_character(file) : read_from_disk(file);
  return frame ? naming(file, [&] { return character_at_frame(std::move(character), *frame); }) : character;
}

}  // namespace croquis::cli
