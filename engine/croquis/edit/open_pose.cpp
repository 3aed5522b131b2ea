// SPDX-License-Identifier: MIT
#include "croquis/edit/open_pose.h"

#include <nlohmann/json.hpp>

#include "croquis/posing/pose_edit.h"

namespace croquis {

std::array<std::optional<Vec3>, kOpenPosePoints> compute_open_pose(const Character& character, const Pose& pose) {
  using B = HumanoidBone;
  std::array<std::optional<Vec3>, kOpenPosePoints> points;
  const HumanoidMap& map = character.humanoid;
  const std::vector<Vec3> positions = compute_positions(character.skeleton, pose);
  const auto place = [&](B bone) -> std::optional<Vec3> {
    if (!map.has(bone)) return std::nullopt;
    return positions[static_cast<std::size_t>(map.joint(bone))];
  };
  constexpr std::array<B, 12> kLimbs{B::rightUpperArm, B::rightLowerArm, B::rightHand,     B::leftUpperArm,
                                     B::leftLowerArm,  B::leftHand,      B::rightUpperLeg, B::rightLowerLeg,
                                     B::rightFoot,     B::leftUpperLeg,  B::leftLowerLeg,  B::leftFoot};
  for (std::size_t i = 0; i < kLimbs.size(); ++i) points[i + 2] = place(kLimbs[i]);
  if (points[2] && points[5]) points[1] = 0.5 * (*points[2] + *points[5]);
  if (!map.has(B::head)) return points;

  // The head's own axes: turned from rest as its joint is, facing `front` at rest.
  const auto head = static_cast<std::size_t>(map.joint(B::head));
  const Quat turn = compute_model_rotations(character.skeleton, pose)[head] *
                    compute_model_rotations(character.skeleton, rest_pose(character.skeleton))[head].conjugate();
  const Vec3 front = turn * character.front, up = turn * Vec3::UnitY(), left = up.cross(front);
  const Vec3 neck = points[1].value_or(positions[head]);
  const double size = std::max((positions[head] - neck).norm(), 0.05 * character.skeleton.extent());
  const Vec3 middle = positions[head] + 0.35 * size * up;
  points[0] = middle + 0.75 * size * front;
  const std::optional<Vec3> right_eye = place(B::rightEye), left_eye = place(B::leftEye);
  points[14] = right_eye.value_or(middle + size * (0.6 * front - 0.22 * left + 0.2 * up));
  points[15] = left_eye.value_or(middle + size * (0.6 * front + 0.22 * left + 0.2 * up));
  points[16] = middle - 0.5 * size * left;
  points[17] = middle + 0.5 * size * left;
  return points;
}

std::string write_open_pose(const Project& project, const Camera& camera) {
  nlohmann::ordered_json people = nlohmann::ordered_json::array();
  for (const Actor& actor : project.actors) {
    if (!actor.character->humanoid.is_humanoid()) continue;
    nlohmann::ordered_json numbers = nlohmann::ordered_json::array();
    for (const std::optional<Vec3>& point : compute_open_pose(*actor.character, actor.pose)) {
      const std::optional<Vec2> pixel = point ? camera.project(*point) : std::nullopt;
      const bool seen = pixel && pixel->x() >= 0.0 && pixel->y() >= 0.0 && pixel->x() <= camera.width_px &&
                        pixel->y() <= camera.height_px;
      numbers.push_back(seen ? pixel->x() : 0.0);
      numbers.push_back(seen ? pixel->y() : 0.0);
      numbers.push_back(seen ? 1.0 : 0.0);
    }
    people.push_back({{"pose_keypoints_2d", numbers}});
  }
  return nlohmann::ordered_json{{"people", people}, {"width", camera.width_px}, {"height", camera.height_px}}.dump();
}

}  // namespace croquis
