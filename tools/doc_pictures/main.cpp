// SPDX-License-Identifier: MIT
// Draws the pictures of docs/images that show the built-in characters and their skinning.
// usage: doc_pictures FOLDER [SHEET...]
#include <algorithm>
#include <cmath>
#include <exception>
#include <fstream>
#include <functional>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include "croquis/body/body.h"
#include "croquis/body/pose_shelf.h"
#include "croquis/edit/view.h"
#include "croquis/picture/picture.h"

namespace croquis {
namespace {

const Vec3 kX = Vec3::UnitX(), kY = Vec3::UnitY(), kZ = Vec3::UnitZ();

/// A camera `azimuth` degrees round from the front (positive: towards the left hand of what it looks at) and
/// `elevation` degrees up.
struct Shot {
  Vec3 target = Vec3::Zero();
  double height = 2.0;  ///< metres in the picture
  double azimuth = 0.0, elevation = 0.0;

  [[nodiscard]] Camera camera(int width, int height_px) const {
    Camera result;
    const double a = azimuth * kDegree, e = elevation * kDegree;
    result.target = target;
    result.position = target + 10.0 * Vec3(std::sin(a) * std::cos(e), std::sin(e), std::cos(a) * std::cos(e));
    result.height = height;
    result.width_px = width;
    result.height_px = height_px;
    return result;
  }
};

class Studio {
 public:
  Image draw(const Character& character, const Pose& pose, const Camera& camera,
             SkinningMethod skinning = SkinningMethod::linear) {
    return renderer_.render({{&character, &pose}}, camera, {}, {.transparent = true, .skinning = skinning});
  }

 private:
  PictureRenderer renderer_;
};

struct Turn {
  std::string joint;
  Vec3 axis;  ///< of model space, as the body stands at rest
  double degrees;
};

Pose bent(const Character& character, const std::vector<Turn>& turns) {
  Pose pose = character.start;
  for (const Turn& turn : turns) {
    Quat& rotation = pose.local[static_cast<std::size_t>(character.skeleton.resolve(turn.joint))].rotation;
    rotation = Quat(Eigen::AngleAxisd(turn.degrees * kDegree, turn.axis)) * rotation;
  }
  return pose;
}

Vec3 place(const Character& character, const Pose& pose, const std::string& joint) {
  const std::vector<Vec3> positions = compute_positions(character.skeleton, pose);
  return positions[static_cast<std::size_t>(character.skeleton.resolve(joint))];
}

Pose shelf_pose(const Character& character, const std::string& name) {
  for (const ShelfPose& shelf : make_pose_shelf()) {
    if (shelf.name != name) continue;
    return apply_humanoid_pose(character.skeleton, character.humanoid, character.front, shelf.pose, character.start);
  }
  throw std::logic_error("no pose on the shelf is named " + name);
}

/// Eight views, a turn of 45 degrees between each and the next.
Image draw_turntable(Studio& studio) {
  const Character mannequin = make_builtin_character("mannequin");
  const Pose pose = shelf_pose(mannequin, "Relaxed");
  std::vector<Image> views;
  for (int view = 0; view < 8; ++view) {
    views.push_back(studio.draw(mannequin, pose, Shot{{0.0, 0.88, 0.0}, 1.86, 45.0 * view, 0.0}.camera(192, 430)));
  }
  return compose_sheet(views, 4, 0);
}

/// What a drawing hangs on: head, shoulders, hands, feet.
Image draw_details(Studio& studio) {
  const Character mannequin = make_builtin_character("mannequin");
  const Pose& rest = mannequin.start;
  const Pose relaxed = shelf_pose(mannequin, "Relaxed");
  const Vec3 face = place(mannequin, rest, "head") + Vec3(0.0, 0.06, 0.03);
  const Vec3 hand = place(mannequin, rest, "leftMiddleProximal");
  const Vec3 foot = place(mannequin, rest, "leftToes") + Vec3(0.0, 0.06, -0.06);
  const Vec3 chest = place(mannequin, rest, "upperChest") + Vec3(0.05, -0.05, 0.0);
  const Vec3 hips = place(mannequin, rest, "hips") + Vec3(0.05, 0.0, 0.0);
  const std::pair<const Pose*, Shot> shots[] = {
      {&rest, {face, 0.32, 0.0, 0.0}},      {&rest, {face, 0.32, 40.0, 5.0}},      {&rest, {face, 0.32, 90.0, 0.0}},
      {&relaxed, {chest, 0.56, 15.0, 5.0}}, {&relaxed, {chest, 0.56, 180.0, 5.0}}, {&relaxed, {hips, 0.56, 30.0, 5.0}},
      {&rest, {hand, 0.26, 0.0, 70.0}},     {&rest, {hand, 0.26, -35.0, -15.0}},   {&rest, {foot, 0.34, 25.0, 25.0}},
      {&rest, {foot, 0.34, 110.0, 12.0}},
  };
  std::vector<Image> views;
  for (const auto& [pose, shot] : shots) views.push_back(studio.draw(mannequin, *pose, shot.camera(230, 230)));
  return compose_sheet(views, 5, 0);
}

struct Bend {
  std::vector<Turn> turns;
  std::string around;
  Shot shot;  ///< its target is beside the joint `around`
};

/// The six bends that a mannequin must stand.
std::vector<Bend> six_bends() {
  const std::vector<Turn> spine{{"spine", kY, 20.0}, {"chest", kY, 20.0}, {"upperChest", kY, 20.0}};
  return {
      {{{"leftLowerArm", -kY, 120.0}}, "leftLowerArm", {{-0.06, 0.0, 0.1}, 0.56, 0.0, 60.0}},
      {{{"leftLowerLeg", kX, 130.0}}, "leftLowerLeg", {{0.0, 0.04, -0.1}, 0.72, 70.0, 5.0}},
      {{{"leftShoulder", kZ, 20.0}, {"leftUpperArm", kZ, 65.0}}, "leftUpperArm", {{-0.08, 0.02, 0.0}, 0.76, 0.0, 0.0}},
      {{{"leftUpperLeg", -kX, 100.0}}, "leftUpperLeg", {{0.0, 0.0, 0.12}, 0.86, 60.0, 5.0}},
      {spine, "chest", {{0.0, 0.06, 0.0}, 0.86, 0.0, 0.0}},
      {{{"leftHand", -kZ, 80.0}}, "leftHand", {{0.0, -0.04, 0.0}, 0.36, 20.0, 8.0}},
  };
}

Image draw_bends(Studio& studio) {
  const Character mannequin = make_builtin_character("mannequin");
  std::vector<Image> views;
  for (const Bend& bend : six_bends()) {
    const Pose pose = bent(mannequin, bend.turns);
    Shot shot = bend.shot;
    shot.target += place(mannequin, pose, bend.around);
    views.push_back(studio.draw(mannequin, pose, shot.camera(360, 360)));
  }
  return compose_sheet(views, 3, 0);
}

/// Left linear blending, right dual quaternions: a forearm twisted, an elbow bent.
Image draw_skinning(Studio& studio) {
  const Character mannequin = make_builtin_character("mannequin");
  std::vector<Image> views;
  const Vec3 elbow = mannequin.skeleton.rest_position(mannequin.skeleton.resolve("leftLowerArm"));
  const Vec3 wrist = mannequin.skeleton.rest_position(mannequin.skeleton.resolve("leftHand"));
  const std::pair<Turn, Shot> rows[] = {
      {{"leftHand", kX, 120.0}, {wrist, 0.24, 0.0, 40.0}},
      {{"leftLowerArm", -kY, 120.0}, {elbow + Vec3(-0.04, 0.0, 0.08), 0.36, 0.0, 60.0}},
  };
  for (const auto& [turn, shot] : rows) {
    const Pose pose = bent(mannequin, {turn});
    for (const SkinningMethod method : {SkinningMethod::linear, SkinningMethod::dual_quaternion}) {
      views.push_back(studio.draw(mannequin, pose, shot.camera(420, 250), method));
    }
  }
  return compose_sheet(views, 2, 0);
}

/// The larger side of what a camera sees of a box, in scene units.
double seen_size(const Box& box, const Camera& camera) {
  Box seen;
  for (int corner = 0; corner < 8; ++corner) {
    seen.extend(Vec3(camera.view_from_world() * box.corner(static_cast<Box::CornerType>(corner))));
  }
  return std::max(seen.sizes().x(), seen.sizes().y());
}

Image draw_other_characters(Studio& studio) {
  std::vector<Image> views;
  for (const std::string& name : builtin_character_names()) {
    if (name == "mannequin") continue;
    const Character character = make_builtin_character(name);
    const Box box = posed_box(character, character.start);
    for (const double azimuth : {0.0, 40.0, 90.0}) {
      const Camera camera = Shot{box.center(), 1.0, azimuth, 12.0}.camera(320, 320);
      Camera framed = camera;
      framed.height = 1.1 * seen_size(box, camera);
      views.push_back(studio.draw(character, character.start, framed));
    }
  }
  return compose_sheet(views, 3, 0);
}

/// Mannequins of other proportions, all to one scale.
Image draw_proportions(Studio& studio) {
  std::vector<Proportions> bodies;
  for (const double heads : {3.0, 4.5, 6.0, 9.0}) {
    bodies.emplace_back();
    bodies.back().heads = heads;
  }
  bodies.push_back({.shoulders = 1.4, .hips = 0.8, .muscle = 1.5});
  bodies.push_back({.shoulders = 0.75, .hips = 1.4, .muscle = 0.8});
  bodies.push_back({.limbs = 1.35, .hands = 1.6, .head = 0.8});
  bodies.push_back({.limbs = 0.75, .hands = 0.7, .head = 1.5});
  std::vector<Image> views;
  for (const Proportions& proportions : bodies) {
    const Character mannequin = make_builtin_character("mannequin", proportions);
    const Pose pose = shelf_pose(mannequin, "Contrapposto");
    views.push_back(studio.draw(mannequin, pose, Shot{{0.0, 1.0, 0.0}, 2.2, 20.0, 0.0}.camera(250, 480)));
  }
  return compose_sheet(views, 4, 0);
}

void run(const std::string& folder, const std::vector<std::string>& wanted) {
  Studio studio;
  const std::pair<std::string, std::function<Image(Studio&)>> sheets[] = {
      {"mannequin_turntable", draw_turntable},
      {"mannequin_details", draw_details},
      {"mannequin_bends", draw_bends},
      {"skinning", draw_skinning},
      {"other_characters", draw_other_characters},
      {"mannequin_proportions", draw_proportions},
  };
  for (const auto& [name, draw] : sheets) {
    if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), name) == wanted.end()) continue;
    const std::vector<std::byte> png = encode_png(draw(studio));
    const std::string path = folder + "/" + name + ".png";
    std::ofstream file(path, std::ios::binary);
    file.write(reinterpret_cast<const char*>(png.data()), static_cast<std::streamsize>(png.size()));
    if (!file.flush()) throw std::runtime_error(path + ": cannot be written");
    std::cout << path << ", " << png.size() / 1000 << " kB\n";
  }
}

}  // namespace
}  // namespace croquis

int main(int count, char** arguments) {
  if (count < 2) {
    std::cerr << "usage: doc_pictures FOLDER [SHEET...]\n";
    return 2;
  }
  try {
    croquis::run(arguments[1], {arguments + 2, arguments + count});
  } catch (const std::exception& error) {
    std::cerr << "doc_pictures: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
