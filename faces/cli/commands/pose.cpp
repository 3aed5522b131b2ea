// SPDX-License-Identifier: MIT
#include "cli/command.h"
#include "cli/files.h"
#include "cli/options.h"
#include "cli/outputs.h"
#include "cli/pictures.h"
#include "cli/progress.h"
#include "cli/writing.h"
#include <algorithm>
#include <iostream>
#include <memory>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "croquis/base/error.h"
#include "croquis/base/text.h"
#include "croquis/edit/commands.h"
#include "croquis/edit/frame.h"
#include "croquis/edit/line_choice.h"

namespace croquis::cli {
namespace {

struct Options {
  std::string rig;
  std::string line_file;
  std::string joints;
  StrokeSettings settings;
  ViewOptions view;
  std::string start;
  std::string form = "pose";
  bool add_positions = false;
  std::string output;
  std::string picture;
  std::string skinning = "linear";
  bool skeleton = false;
  bool json = false;
  ProportionOptions proportions;
};

PoseForm parse_form(const std::string& word) {
  if (word == "pose") return PoseForm::pose;
  if (word == "clip") return PoseForm::clip;
  if (word == "baked") return PoseForm::baked;
  throw_invalid_argument("--as '" + printable(word) + "': wanted pose, clip, baked");
}

/// The project with its first actor in the pose that the line is drawn over.
Project at_start(const Project& project, const std::string& start) {
  const Character& character = *project.actors.front().character;
  if (start.empty()) return set_pose(project, 0, rest_pose(character.skeleton));
  const Character source = load_start(start);
  try {
    return set_pose(project, 0, start_pose_of(source, character));
  } catch (const Error& error) {
    throw Error(error.code(), "--start " + start + ": " + error.what());
  }
}

/// The strokes of the file that are lines to pose along, in their order: those whose id names a body line, if there are
/// any and nothing else was asked for; else the first.
std::vector<PlacedStroke> read_strokes(const Options& options, const Character& character, const Camera& camera,
                                       std::vector<std::string>& notices) {
  const std::vector<BodyLine> lines = standard_body_lines(character.skeleton, character.humanoid);
  const auto is_line = [&](const Stroke& stroke) {
    return std::any_of(lines.begin(), lines.end(), [&](const BodyLine& line) { return line.name == stroke.name; });
  };
  PlacedStroke placed;
  placed.camera = camera;
  placed.settings = options.settings;
  if (!options.joints.empty()) placed.settings.joints = parse_joint_list(character.skeleton, options.joints);
  const bool by_id = placed.settings.joints.empty() && placed.settings.body_line.empty();

  const std::vector<Stroke> strokes = load_strokes(options.line_file, camera.width_px, camera.height_px);
  std::vector<PlacedStroke> used;
  for (const Stroke& stroke : strokes) {
    if (!by_id || !is_line(stroke)) continue;
    placed.stroke = stroke;
    placed.settings.body_line = stroke.name;
    used.push_back(placed);
  }
  if (used.empty()) {
    placed.stroke = strokes.front();
    used.push_back(placed);
  }
  if (used.size() < strokes.size()) {
    notices.push_back(options.line_file + " holds " + std::to_string(strokes.size()) + " strokes, of which " +
                      std::to_string(used.size()) +
                      (used.size() == 1 ? " is used: a further one needs" : " are used: the others need") +
                      " the name of a body line as its id");
  }
  return used;
}

void put(nlohmann::ordered_json& json, const LineReport& report, const Skeleton& skeleton) {
  json["status"] = report.status;
  json["body_line"] = report.body_line;
  json["direction"] = report.forward ? "forward" : "backward";
  json["fit"] = {
      {"mean_px", report.fit.mean_px}, {"max_px", report.fit.max_px}, {"tangent_deg", report.fit.tangent_deg}};
  json["bone_length_drift"] = report.bone_length_drift;
  json["limit_violations"] = nlohmann::ordered_json::array();
  for (const int joint : report.limit_violations) json["limit_violations"].push_back(skeleton.reference(joint));
  json["solve_ms"] = report.solve_ms;
  json["alternatives"] = nlohmann::ordered_json::array();  // of one line with one method there are none
}

/// The first line's report; where there are several, all of them under "lines"; without a line, nothing but "ok".
nlohmann::ordered_json to_json(const std::vector<LineReport>& reports, const Skeleton& skeleton,
                               const std::vector<std::string>& notices, const std::vector<std::string>& outputs) {
  nlohmann::ordered_json json;
  if (reports.empty()) {
    json["status"] = "ok";
    for (const char* key : {"body_line", "direction", "fit"}) json[key] = nullptr;
  } else {
    put(json, reports.front(), skeleton);
  }
  if (reports.size() > 1) {
    for (const LineReport& report : reports) put(json["lines"].emplace_back(), report, skeleton);
  }
  json["notices"] = notices;
  json["outputs"] = outputs;
  return json;
}

void print_text(const std::vector<LineReport>& reports, const std::vector<std::string>& notices,
                const std::vector<std::string>& outputs) {
  for (const LineReport& report : reports) {
    std::cout << "Posed " << printable(report.body_line) << ", " << (report.forward ? "forward" : "backward")
              << " along the stroke: " << format_double(report.fit.mean_px, 3) << " px from it on average, "
              << format_double(report.fit.max_px, 3) << " px at most, " << format_double(report.fit.tangent_deg, 3)
              << " degrees off its direction\n";
    if (report.status != "ok") std::cout << "Note: " << report.status << '\n';
  }
  if (!reports.empty() && !reports.back().limit_violations.empty()) {
    const std::size_t count = reports.back().limit_violations.size();
    std::cout << "Note: " << count << (count == 1 ? " joint is" : " joints are")
              << " bent beyond the anatomical range of motion\n";
  }
  for (const std::string& notice : notices) std::cout << "Note: " << notice << '\n';
  std::cout << "Wrote " << join(outputs, ", ") << '\n';
}

void run(Options options) {
  if (options.settings.root.empty()) options.settings.root = is_line_method(options.settings) ? "free" : "lock";
  Outputs outputs;
  const std::string format = output_format(options.output, character_formats());
  outputs.announce(options.output);
  if (!options.picture.empty()) {
    (void)output_format(options.picture, {"png"});
    outputs.announce(options.picture);
  }
  const WriteOptions writing{parse_form(options.form), options.add_positions};
  PictureOptions look;
  look.skinning = parse_skinning(options.skinning);
  look.skeleton = options.skeleton;
  check_words(options.settings);
  options.proportions.check(options.rig);

  Progress progress;
  progress.at("Reading " + options.rig);
  Project project = at_start(load_project(options.rig, options.proportions.proportions), options.start);
  const std::shared_ptr<const Character> character = project.actors.front().character;
  std::vector<std::string> notices = notices_for(*character, format, writing.form);
  const Camera camera = options.view.camera(project.actors);
  std::vector<LineReport> reports;
  std::vector<Stroke> ink;
  if (!options.line_file.empty()) {
    progress.at("Posing");
    const std::vector<PlacedStroke> strokes = read_strokes(options, *character, camera, notices);
    PosedLines posed = pose_along_lines(project, strokes);
    project = std::move(posed.project);
    reports = std::move(posed.reports);
    for (const PlacedStroke& stroke : strokes) ink.push_back(stroke.stroke);
  }
  progress.at("Writing " + options.output);
  outputs.add(options.output, to_file(project, format, options.output, writing));
  if (!options.picture.empty()) {
    progress.at("Rendering " + options.picture);
    outputs.add(options.picture, picture_of(project.actors, camera, ink, look));
  }
  outputs.write();
  if (options.json) {
    std::cout << to_json(reports, character->skeleton, notices, outputs.paths())
                     .dump(2, ' ', false, nlohmann::json::error_handler_t::replace)
              << '\n';
  } else {
    print_text(reports, notices, outputs.paths());
  }
}

void add_line_options(CLI::App& command, Options& options) {
  auto* line = command
                   .add_option("--line", options.line_file,
                               "The drawn line: an SVG in the picture's pixels; of several strokes each poses the body "
                               "line that its id names [default: none, the start pose is written]")
                   ->type_name("FILE.svg");
  auto* joints = command
                     .add_option("--joints", options.joints,
                                 "The joints to pose, in the order in which the stroke passes them; #index for a name "
                                 "that is not unique or has a comma [default: the character's default line]")
                     ->type_name("A,B,C,...");
  auto* body_line = command
                        .add_option("--body-line", options.settings.body_line,
                                    "The line to pose by its name; croquis info lists them [default: the first]")
                        ->type_name("NAME")
                        ->excludes(joints);
  auto* method = command
                     .add_option("--method", options.settings.method,
                                 "line solves for the pose, several strokes at once; rotation turns bone after bone "
                                 "along the stroke, rotation-index too but depends on the pen's speed; near and "
                                 "curvilinear stretch bones")
                     ->type_name("METHOD");
  auto* plane = command
                    .add_option("--plane", options.settings.plane,
                                "The plane the stroke lies in: free faces the camera, ground stands upright")
                    ->type_name("PLANE");
  auto* root =
      command
          .add_option("--root", options.settings.root,
                      "The body's root: lock leaves it, tangent turns it to the stroke's direction there, free "
                      "(line alone) turns and moves it as the line asks")
          ->default_str("free for line, lock for the others")
          ->type_name("MODE");
  auto* direction = command
                        .add_option("--direction", options.settings.direction,
                                    "Which way the stroke runs: auto, length (the side that fits in length), forward "
                                    "(it starts at the first joint named) or backward")
                        ->type_name("WAY");
  for (auto* option : {joints, body_line, method, plane, root, direction}) option->needs(line);
}

}  // namespace

Command add_pose_command(CLI::App& program) {
  const auto options = std::make_shared<Options>();
  options->settings.root.clear();  // its default depends on the method
  CLI::App* command = program.add_subcommand("pose", "Poses a character along a drawn line");
  command
      ->add_option("RIG", options->rig, "Any file with a skeleton, or one of " + join(builtin_character_names(), ", "))
      ->required();
  add_line_options(*command, *options);
  options->view.add_to(*command);
  command
      ->add_option("--start", options->start,
                   "The pose the line is drawn over: FILE as it opens, or frame N of it, from 0 [default: rest]")
      ->type_name("FILE[:N]");
  command
      ->add_option("--as", options->form,
                   "pose: into the joints; clip: a clip of one frame, joints at rest; baked: into the mesh")
      ->type_name("FORM");
  command->add_flag("--add-positions", options->add_positions,
                    "BVH: give stretched joints position channels [default: refuse]");
  command->add_option("-o,--output", options->output, "The posed file: " + join(character_formats(), ", "))
      ->required()
      ->type_name("OUT");
  command->add_option("--picture", options->picture, "A picture of it with the line, a .png [default: none]")
      ->type_name("OUT.png");
  command->add_option("--skinning", options->skinning, "linear or dual-quaternion, for the picture")
      ->type_name("METHOD");
  command->add_flag("--skeleton", options->skeleton, "Draw the bones in the picture [default: off]");
  command->add_flag("--json", options->json, "Report as one JSON object on standard output [default: as text]");
  options->proportions.add_to(*command);
  command->footer(
      "Example:\n"
      "  croquis pose mannequin --line line.svg --body-line left_foot-head --view front -o posed.glb "
      "--picture posed.png");
  return {command, [options] { run(*options); }};
}

}  // namespace croquis::cli
