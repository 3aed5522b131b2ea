// SPDX-License-Identifier: MIT
#include "cli/command.h"
#include "cli/files.h"
#include "cli/options.h"
#include "cli/outputs.h"
#include "cli/progress.h"
#include <algorithm>
#include <iostream>
#include <memory>

#include <CLI/CLI.hpp>

#include "croquis/base/error.h"
#include "croquis/base/text.h"
#include "croquis/body/body.h"
#include "croquis/edit/gestures.h"
#include "croquis/picture/picture.h"

namespace croquis::cli {
namespace {

struct SheetArguments {
  std::vector<std::string> rigs;
  std::string output;
  std::string gestures;
  int cell = 256;
  bool skeleton = false;
  bool no_line = false;
};

std::vector<Gesture> chosen_gestures(const std::string& list) {
  if (list.empty()) return all_gestures();
  std::vector<Gesture> chosen;
  for (const std::string& entry : split(list, ',')) {
    const std::string name(trim(entry));
    std::vector<std::string> names;
    for (const Gesture& gesture : all_gestures()) {
      names.push_back(gesture.name);
      if (gesture.name == name) chosen.push_back(gesture);
    }
    if (chosen.empty() || chosen.back().name != name) {
      throw_invalid_argument("--gestures '" + printable(name) + "': wanted " + join(names, ", "));
    }
  }
  return chosen;
}

/// Drawn at twice the size and halved: small figures want smooth edges.
Image cell_of(PictureRenderer& renderer, const Project& project, const Gesture& gesture,
              const SheetArguments& options) {
  const GesturePose posed = pose_gesture(project, gesture, 2 * options.cell);
  std::vector<Stroke> ink;
  for (const PlacedStroke& stroke : posed.project.strokes) ink.push_back(stroke.stroke);
  if (options.no_line) ink.clear();
  const Actor& actor = posed.project.actors.front();
  PictureOptions look;
  look.skeleton = options.skeleton;
  return halve(renderer.render({{actor.character.get(), &actor.pose}}, posed.camera, ink, look));
}

void run_sheet(const SheetArguments& options) {
  Outputs outputs;
  (void)output_format(options.output, {"png"});
  outputs.announce(options.output);
  if (options.cell < 64 || options.cell > 1024) {
    throw_invalid_argument("--cell " + std::to_string(options.cell) + ": wanted 64 to 1024 pixels");
  }
  const std::vector<Gesture> gestures = chosen_gestures(options.gestures);
  const std::vector<std::string> rigs =
      options.rigs.empty() ? std::vector<std::string>{"mannequin", "cat", "snake", "tree"} : options.rigs;
  if (rigs.size() > 16) throw_invalid_argument("a sheet shows at most 16 characters");
  Progress progress;
  PictureRenderer renderer;
  std::vector<Image> cells;
  for (const std::string& rig : rigs) {
    progress.at("Posing " + rig);
    const Project project = load_project(rig);
    try {
      for (const Gesture& gesture : gestures) cells.push_back(cell_of(renderer, project, gesture, options));
    } catch (const Error& error) {
      throw Error(error.code(), rig + ": " + error.what());
    }
  }
  outputs.add(options.output, encode_png(compose_sheet(cells, static_cast<int>(gestures.size()), 4)));
  outputs.write();
  std::cout << "Wrote " << options.output << '\n';
}

}  // namespace

Command add_sheet_command(CLI::App& program) {
  const auto options = std::make_shared<SheetArguments>();
  std::vector<std::string> names;
  for (const Gesture& gesture : all_gestures()) names.push_back(gesture.name);
  CLI::App* command = program.add_subcommand("sheet", "Draws characters in the gestures that people learn from");
  command->add_option("RIG", options->rigs,
                      "Any files with a skeleton, or built-in characters; a row each [default: mannequin, cat, snake, "
                      "tree]");
  command->add_option("-o,--output", options->output, "The sheet, a .png")->required()->type_name("OUT.png");
  command
      ->add_option("--gestures", options->gestures,
                   "The columns, some of " + join(names, ", ") + " [default: all of them]")
      ->type_name("A,B,...");
  command->add_option("--cell", options->cell, "Side of each picture in pixels")->type_name("PIXELS");
  command->add_flag("--skeleton", options->skeleton, "Draw the bones over the bodies [default: off]");
  command->add_flag("--no-line", options->no_line, "Leave the drawn lines out [default: off]");
  command->footer("Example:\n  croquis sheet mannequin snake --cell 128 -o sheet.png");
  return {command, [options] { run_sheet(*options); }};
}

}  // namespace croquis::cli
