// SPDX-License-Identifier: MIT
#include "cli/options.h"

#include "cli/files.h"
#include <optional>

#include <CLI/CLI.hpp>

#include "croquis/base/error.h"
#include "croquis/base/text.h"
#include "croquis/edit/view.h"

namespace croquis::cli {
namespace {

constexpr int kMostPixels = 8192;  // a side; what every OpenGL can draw to

std::pair<int, int> parse_size(const std::string& text) {
  const std::vector<std::string> sides = split(text, 'x');
  const auto side = [&](std::size_t i) { return i < sides.size() ? parse_int(sides[i]).value_or(0) : 0; };
  if (sides.size() != 2 || side(0) < 1 || side(1) < 1 || side(0) > kMostPixels || side(1) > kMostPixels) {
    throw_invalid_argument("--size '" + printable(text) + "': wanted WxH, each from 1 to " +
                           std::to_string(kMostPixels) + " pixels");
  }
  return {side(0), side(1)};
}

}  // namespace

void ViewOptions::add_to(CLI::App& command) {
  std::vector<std::string> names;
  for (const View v : all_views()) names.emplace_back(to_string(v));
  auto* named = command.add_option("--view", view, "Seen from the character's " + join(names, ", "))->type_name("NAME");
  auto* size_option = command.add_option("--size", size, "Size of the picture in pixels")->type_name("WxH");
  command
      .add_option("--camera", camera_file,
                  "A camera file instead of a named view; it says the size too [default: the view]")
      ->type_name("FILE.json")
      ->excludes(named)
      ->excludes(size_option);
}

Camera ViewOptions::camera(const std::vector<Actor>& actors) const {
  if (!camera_file.empty()) return load_camera(camera_file);
  const std::optional<View> named = parse_view(view);
  if (!named) {
    std::vector<std::string> names;
    for (const View v : all_views()) names.emplace_back(to_string(v));
    throw_invalid_argument("--view '" + printable(view) + "': wanted " + join(names, ", "));
  }
  const auto [width, height] = parse_size(size);
  return make_named_view(actors, *named, width, height);
}

void ProportionOptions::add_to(CLI::App& command) {
  const auto add = [&](const char* name, double& value, const char* text) {
    command
        .add_option_function<double>(
            name,
            [this, &value](const double& number) {
              value = number;
              given = true;
            },
            text)
        ->default_str(format_double(value))
        ->type_name("NUMBER")
        ->group("Proportions of a built-in character");
  };
  add("--heads", proportions.heads, "Height of the mannequin in heads, 3 to 9");
  add("--shoulders", proportions.shoulders, "Width of the shoulders, 0.6 to 1.6");
  add("--hips", proportions.hips, "Width of the hips, 0.6 to 1.6");
  add("--limbs", proportions.limbs, "Length of arms and legs, 0.7 to 1.4");
  add("--hands", proportions.hands, "Size of hands and feet, 0.6 to 1.8");
  add("--head", proportions.head, "Size of the head, 0.7 to 1.6");
  add("--muscle", proportions.muscle, "Thickness of the forms, 0.6 to 1.6");
}

void ProportionOptions::check(const std::string& file) const {
  if (given && !is_builtin_character(file)) {
    throw_invalid_argument("proportions are for the built-in characters (" + join(builtin_character_names(), ", ") +
                           "), not for " + file);
  }
  if (proportions.heads != Proportions{}.heads && file != "mannequin") {
    throw_invalid_argument("--heads is for the mannequin, not for " + file);
  }
}

SkinningMethod parse_skinning(const std::string& word) {
  if (word == "linear") return SkinningMethod::linear;
  if (word == "dual-quaternion") return SkinningMethod::dual_quaternion;
  throw_invalid_argument("--skinning '" + printable(word) + "': wanted linear, dual-quaternion");
}

}  // namespace croquis::cli
