// SPDX-License-Identifier: MIT
#include "croquis/edit/gestures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "croquis/edit/line_setup.h"
#include "croquis/edit/pose_text.h"
#include "croquis/edit/view.h"
#include "croquis/io/svg.h"
#include "croquis/posing/body_points.h"
#include "croquis/rig/mirror.h"

namespace croquis {
namespace {

constexpr double kSide = 1000.0, kFigure = 700.0, kFloor = 900.0;
// The mannequin's hips, upper arms and crown in that picture, and its ankles.
constexpr std::array<double, 4> kHeights{kFloor, 517.0, 339.0, 200.0};
const Vec2 kAnkle(500, 869), kHips(500, 517), kHead(500, 279);

std::vector<Stroke> read_paths(const std::string& paths) {
  const std::string svg = "<svg viewBox=\"0 0 1000 1000\">" + paths + "</svg>";
  return read_svg_strokes(std::as_bytes(std::span(svg)), static_cast<int>(kSide), static_cast<int>(kSide));
}

/// The camera in which a figure stands as gestures are drawn for.
Camera gesture_camera(const Actor& actor, View view, int side_px) {
  const Box box = posed_box(*actor.character, rest_pose(actor.character->skeleton));
  Camera camera = make_view_camera(view, box, actor.character->front, side_px, side_px);
  camera.height = box.sizes().y() * kSide / kFigure;
  const Vec3 soles(box.center().x(), box.min().y(), box.center().z());
  const Vec3 target = soles + Vec3::UnitY() * camera.height * (kFloor / kSide - 0.5);
  camera.position += target - camera.target;
  camera.target = target;
  return camera;
}

/// Where a height in the gestures' picture is on a body with hips and shoulders of its own.
double fitted_height(double y, const std::array<double, 4>& own) {
  std::size_t i = 1;
  while (i + 1 < kHeights.size() && y < kHeights[i]) ++i;
  const double t = (y - kHeights[i - 1]) / (kHeights[i] - kHeights[i - 1]);
  return own[i - 1] + t * (own[i] - own[i - 1]);
}

std::array<double, 4> own_heights(const Actor& actor, const Camera& camera) {
  using B = HumanoidBone;
  const HumanoidMap& map = actor.character->humanoid;
  const std::vector<Vec3> rest = compute_positions(actor.character->skeleton, rest_pose(actor.character->skeleton));
  const auto height_of = [&](B bone, double otherwise) {
    if (!map.has(bone)) return otherwise;
    const auto pixel = camera.project(rest[static_cast<std::size_t>(map.joint(bone))]);
    return pixel ? pixel->y() * kSide / camera.height_px : otherwise;
  };
  std::array<double, 4> own{kHeights[0], height_of(B::hips, kHeights[1]), height_of(B::leftUpperArm, kHeights[2]),
                            kHeights[3]};
  const bool ordered = own[0] > own[1] + 50 && own[1] > own[2] + 20 && own[2] > own[3] + 20;
  return ordered ? own : kHeights;
}

/// The standard line with the longest way along the middle of the body, else the first that begins at the body's root.
BodyLine middle_line(const Character& character) {
  const std::vector<BodyLine> lines = standard_body_lines(character.skeleton, character.humanoid);
  const std::vector<int> partner = compute_mirror_map(character.skeleton, character.humanoid);
  BodyLine best = lines.front();
  double most = -1.0;
  for (const BodyLine& line : lines) {
    const bool from_root = *std::min_element(line.joints.begin(), line.joints.end()) == line.joints.front();
    double length = from_root ? 1e-6 : 0.0;
    for (std::size_t k = 1; k < line.joints.size(); ++k) {
      const int a = line.joints[k - 1], b = line.joints[k];
      if (partner[static_cast<std::size_t>(a)] != a || partner[static_cast<std::size_t>(b)] != b) continue;
      length += (character.skeleton.rest_position(a) - character.skeleton.rest_position(b)).norm();
    }
    if (length > most * (1.0 + 1e-9)) {
      most = length;
      best = line;
    }
  }
  return best;
}

GesturePose pose_humanoid(const Project& alone, const Gesture& gesture, int side_px) {
  Project project = alone;
  Actor& actor = project.actors.front();
  actor.pose = find_shelf_pose(*actor.character, "Relaxed").value_or(actor.pose);
  const Camera camera = gesture_camera(actor, gesture.view, side_px);
  const std::array<double, 4> own = own_heights(actor, camera);
  project.settings.floor = gesture.on_floor;
  std::vector<PlacedStroke> strokes;
  for (Stroke& stroke : read_paths(gesture.paths)) {
    for (StrokeSample& sample : stroke.samples) {
      sample.position = side_px / kSide * Vec2(sample.position.x(), fitted_height(sample.position.y(), own));
    }
    PlacedStroke placed;
    placed.camera = camera;
    placed.settings.body_line = stroke.name;
    placed.settings.direction = "forward";
    placed.stroke = std::move(stroke);
    strokes.push_back(std::move(placed));
  }
  PosedLines posed = pose_along_lines(project, strokes);
  return {std::move(posed.project), camera, std::move(posed.reports)};
}

GesturePose pose_other(const Project& alone, const Gesture& gesture, int side_px) {
  Project project = alone;
  const Actor& actor = project.actors.front();
  const Character& character = *actor.character;
  const BodyLine line = middle_line(character);
  const Vec3 first = character.skeleton.rest_position(line.joints.front());
  const Vec3 last = character.skeleton.rest_position(line.joints.back());
  const Box box = posed_box(character, actor.pose);
  Camera camera;
  double longest = 0.0;
  for (const View view : {View::left, View::front, View::top}) {
    Camera seen = make_view_camera(view, box, character.front, side_px, side_px);
    seen.height = 1.5 * box.sizes().maxCoeff();
    const double length = (*seen.project(first) - *seen.project(last)).norm();
    if (length < 1.05 * longest) continue;
    longest = length;
    camera = seen;
  }
  PlacedStroke placed;
  placed.stroke = read_paths(gesture.paths).front();
  // The similarity that takes the drawn figure's ankle (or hips) and head to the line's ends.
  const Vec2 foot = placed.stroke.name == "trunk" ? kHips : kAnkle;
  const Vec2 from = *camera.project(first), whole = *camera.project(last) - from, drawn = kHead - foot;
  const double scale = 1.0 / drawn.squaredNorm();
  const double c = scale * drawn.dot(whole), s = scale * (drawn.x() * whole.y() - drawn.y() * whole.x());
  placed.stroke.name.clear();
  for (StrokeSample& sample : placed.stroke.samples) {
    const Vec2 p = sample.position - foot;
    sample.position = from + Vec2(c * p.x() - s * p.y(), s * p.x() + c * p.y());
  }
  placed.camera = camera;
  placed.settings.joints = line.joints;
  placed.settings.direction = "forward";
  placed.settings.length = "scale";
  const std::vector<Vec3> joints = compute_positions(character.skeleton, actor.pose);
  const bool stands = !find_standing_feet(character.skeleton, character.humanoid, joints, floor_under(actor)).empty();
  project.settings.floor = gesture.on_floor && stands;
  PosedLines posed = pose_along_lines(project, {placed});
  return {std::move(posed.project), camera, std::move(posed.reports)};
}

}  // namespace

const std::vector<Gesture>& all_gestures() {
  static const std::vector<Gesture> kGestures{
      {"C", View::front, true,
       R"(<path id="left_foot-head" d="M545 868 C 500 740 455 600 465 500 C 472 420 500 340 560 285"/>
          <path id="left_arm" d="M575 362 C 620 330 680 260 700 165"/>
          <path id="right_arm" d="M437 395 C 400 450 375 520 385 605"/>)"},
      {"reversed C", View::front, true,
       R"(<path id="right_foot-head" d="M455 868 C 500 740 545 600 535 500 C 528 420 500 340 440 285"/>
          <path id="right_arm" d="M425 362 C 380 330 320 260 300 165"/>
          <path id="left_arm" d="M563 395 C 600 450 625 520 615 605"/>)"},
      {"S", View::front, true,
       R"(<path id="right_foot-head" d="M469 869 C 490 780 535 660 517 538 C 506 448 464 405 490 305"/>
          <path id="left_leg" d="M553 545 C 580 640 585 760 572 869"/>
          <path id="left_arm" d="M548 375 C 603 405 640 450 610 560"/>
          <path id="right_arm" d="M415 375 C 355 405 335 475 405 525"/>)"},
      {"lunge", View::right, true,
       R"(<path id="right_foot-head" d="M250 868 C 350 760 440 660 500 590 C 545 530 585 450 610 370"/>
          <path id="left_leg" d="M505 590 C 590 590 650 610 665 650 C 670 720 665 800 660 869"/>
          <path id="left_arm" d="M585 420 C 650 400 720 380 800 365"/>
          <path id="right_arm" d="M575 425 C 510 450 440 470 365 465"/>)"},
      {"jump", View::right, false,
       R"(<path id="right_foot-head" d="M330 720 C 400 660 470 560 495 440 C 510 360 500 280 470 190"/>
          <path id="left_leg" d="M495 440 C 440 520 400 560 350 590 C 320 620 300 650 270 690"/>
          <path id="left_arm" d="M500 260 C 520 190 540 130 575 60"/>
          <path id="right_arm" d="M500 260 C 500 190 505 130 520 50"/>)"},
      {"bow", View::right, true,
       R"(<path id="trunk" d="M455 525 C 480 450 560 410 680 455"/>
          <path id="left_arm" d="M600 440 C 600 500 610 570 620 650"/>
          <path id="right_arm" d="M590 440 C 570 500 560 570 560 650"/>)"},
      {"throw", View::front, true,
       R"(<path id="left_foot-head" d="M620 869 C 600 740 540 620 490 530 C 450 450 430 380 440 300"/>
          <path id="right_leg" d="M455 530 C 420 640 390 750 360 869"/>
          <path id="left_arm" d="M520 390 C 600 350 660 320 735 300"/>
          <path id="right_arm" d="M385 390 C 320 370 270 330 300 240"/>)"},
      {"contrapposto", View::front, true,
       R"(<path id="trunk" d="M476 532 C 492 476 508 416 488 301"/>
          <path id="shoulders" d="M560 341 L 428 371"/>
          <path id="hips" d="M512 546 L 441 526"/>
          <path id="left_leg" d="M512 546 C 535 610 552 680 548 730 C 545 780 548 830 552 869"/>
          <path id="right_leg" d="M441 526 C 446 650 456 760 466 869"/>
          <path id="left_arm" d="M562 346 C 587 416 600 486 590 561"/>
          <path id="right_arm" d="M428 376 C 395 426 375 476 425 536"/>)"},
  };
  return kGestures;
}

GesturePose pose_gesture(const Project& project, const Gesture& gesture, int side_px) {
  Project alone;
  alone.actors = {project.actors.front()};
  alone.settings = project.settings;
  const Character& character = *alone.actors.front().character;
  alone.actors.front().pose = rest_pose(character.skeleton);
  return character.humanoid.is_humanoid() ? pose_humanoid(alone, gesture, side_px)
                                          : pose_other(alone, gesture, side_px);
}

}  // namespace croquis
