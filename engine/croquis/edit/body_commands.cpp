// SPDX-License-Identifier: MIT
#include "croquis/edit/body_commands.h"

#include <algorithm>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/base/index.h"
#include "croquis/base/text.h"
#include "croquis/edit/commands.h"
#include "croquis/edit/line_setup.h"
#include "croquis/edit/pose_text.h"
#include "croquis/posing/pose_edit.h"
#include "croquis/posing/reach.h"
#include "croquis/rig/joint_limits.h"
#include "croquis/rig/mirror.h"

namespace croquis {
namespace {

using B = HumanoidBone;

const Actor& actor_with_id(const Project& project, int id) { return project.actors[at(actor_index(project, id))]; }

void want_joint(const Actor& actor, int joint) {
  if (joint < 0 || joint >= actor.character->skeleton.joint_count()) {
    throw_invalid_argument("joint " + std::to_string(joint) + " is not there");
  }
}

/// Feet within a fiftieth of the body of the lowest joint: they stand.
std::vector<int> standing_feet(const Character& character, const std::vector<Vec3>& positions) {
  double lowest = positions.front().y();
  for (int i = 0; i < character.skeleton.joint_count(); ++i) {
    if (!character.skeleton.joint(i).helper) lowest = std::min(lowest, positions[at(i)].y());
  }
  std::vector<int> standing;
  for (const auto& [foot, toes] : {std::pair{B::leftFoot, B::leftToes}, std::pair{B::rightFoot, B::rightToes}}) {
    if (!character.humanoid.has(foot)) continue;
    const int sole = character.humanoid.has(toes) ? character.humanoid.joint(toes) : character.humanoid.joint(foot);
    if (positions[at(sole)].y() < lowest + 0.02 * character.skeleton.extent()) {
      standing.push_back(character.humanoid.joint(foot));
    }
  }
  return standing;
}

}  // namespace

int actor_index(const Project& project, int id) {
  for (int i = 0; i < std::ssize(project.actors); ++i) {
    if (project.actors[at(i)].id == id) return i;
  }
  throw_invalid_argument("no character on the table has the number " + std::to_string(id));
}

Project remove_actor(const Project& project, int id) {
  const int index = actor_index(project, id);
  Project next = project;
  next.actors.erase(next.actors.begin() + index);
  const auto settle = [index](auto& things) {
    std::erase_if(things, [index](const auto& thing) { return thing.actor == index; });
    for (auto& thing : things) {
      if (thing.actor > index) --thing.actor;
    }
  };
  settle(next.strokes);
  settle(next.poses);
  return next;
}

Pose hold_pins(const Project& project, const Actor& actor, const Pose& before, const Pose& after, std::string* status) {
  const Character& character = *actor.character;
  const Skeleton& skeleton = character.skeleton;
  std::vector<ReachGoal> goals;
  for (const Pin& pin : actor.pins) goals.push_back({pin.joint, pin.position, pin.rotation});
  if (project.settings.floor) {
    const std::vector<Vec3> positions = compute_positions(skeleton, before);
    const std::vector<Quat> rotations = compute_model_rotations(skeleton, before);
    for (const int foot : standing_feet(character, positions)) {
      const bool pinned = std::any_of(goals.begin(), goals.end(), [&](const ReachGoal& g) { return g.joint == foot; });
      if (!pinned) goals.push_back({foot, positions[at(foot)], rotations[at(foot)]});
    }
  }
  const std::vector<JointLimit> limits = limits_of(project.settings, character);
  Pose pose = after;
  for (const ReachGoal& goal : goals) {
    const std::vector<ReachGoal> one{goal};
    const ReachResult result =
        solve_reach(skeleton, pose, one, limb_above(skeleton, character.humanoid, goal.joint), limits);
    pose = result.pose;
    if (status != nullptr && result.status != "ok") *status = result.status;
  }
  return pose;
}

Project drag_joint(const Project& project, int id, int joint, const Vec3& target_model, std::string* status) {
  const Actor& actor = actor_with_id(project, id);
  want_joint(actor, joint);
  if (!target_model.allFinite()) throw_invalid_argument("drag_joint: the target is not finite");
  const Character& character = *actor.character;
  const Skeleton& skeleton = character.skeleton;
  if (status != nullptr) *status = "ok";
  Pose pose;
  if (joint == carrying_joint(skeleton, character.humanoid)) {
    pose = hold_pins(project, actor, actor.pose, place_joint(skeleton, actor.pose, joint, target_model), status);
  } else {
    const std::vector<int> limb = limb_above(skeleton, character.humanoid, joint);
    const bool keeps_turn =
        character.humanoid.bone_of(joint) == B::leftFoot || character.humanoid.bone_of(joint) == B::rightFoot;
    ReachGoal goal{joint, target_model, {}};
    if (keeps_turn) goal.rotation = compute_model_rotations(skeleton, actor.pose)[at(joint)];
    const std::vector<ReachGoal> goals{goal};
    const ReachResult result = solve_reach(skeleton, actor.pose, goals, limb, limits_of(project.settings, character));
    if (status != nullptr) *status = result.status;
    pose = result.pose;
  }
  return set_pose(project, actor_index(project, id), std::move(pose));
}

Project rotate_joint(const Project& project, int id, int joint, const Quat& turn_model) {
  const Actor& actor = actor_with_id(project, id);
  want_joint(actor, joint);
  const Skeleton& skeleton = actor.character->skeleton;
  Pose pose = turn_joint(skeleton, actor.pose, joint, turn_model);
  for (const JointLimit& limit : limits_of(project.settings, *actor.character)) {
    if (limit.joint != joint) continue;
    Quat& local = pose.local[at(joint)].rotation;
    local = clamp_to_limit(limit, local);
  }
  Project pinned_only = project;
  pinned_only.settings.floor = false;  // a leg that is turned by hand leaves the floor
  pose = hold_pins(pinned_only, actor, actor.pose, pose);
  return set_pose(project, actor_index(project, id), std::move(pose));
}

Project pin_joint(const Project& project, int id, int joint, bool on, bool with_rotation) {
  const Actor& actor = actor_with_id(project, id);
  want_joint(actor, joint);
  Project next = project;
  std::vector<Pin>& pins = next.actors[at(actor_index(project, id))].pins;
  std::erase_if(pins, [&](const Pin& pin) { return pin.joint == joint; });
  if (on) {
    const Skeleton& skeleton = actor.character->skeleton;
    Pin pin{joint, compute_positions(skeleton, actor.pose)[at(joint)], {}};
    if (with_rotation) pin.rotation = compute_model_rotations(skeleton, actor.pose)[at(joint)];
    pins.push_back(pin);
  }
  return next;
}

Project mirror_actor(const Project& project, int id, MirrorSide side) {
  const Actor& actor = actor_with_id(project, id);
  const Character& character = *actor.character;
  const std::vector<int> partners = compute_mirror_map(character.skeleton, character.humanoid);
  return set_pose(project, actor_index(project, id),
                  mirror_pose(character.skeleton, character.humanoid, partners, character.front, actor.pose, side));
}

Project reset_actor(const Project& project, int id, const std::vector<int>& joints, double amount) {
  const Actor& actor = actor_with_id(project, id);
  if (!(amount >= 0.0 && amount <= 1.0)) throw_invalid_argument("reset_actor: wanted an amount from 0 to 1");
  return set_pose(project, actor_index(project, id), blend_pose(actor.pose, actor.character->start, amount, joints));
}

Project go_to_frame(const Project& project, int id, int clip, int frame) {
  const Actor& actor = actor_with_id(project, id);
  const std::vector<Clip>& clips = actor.character->clips;
  if (clip < 0 || clip >= std::ssize(clips)) throw_invalid_argument("clip " + std::to_string(clip) + " is not there");
  const Clip& chosen = clips[at(clip)];
  return set_pose(project, actor_index(project, id),
                  sample_pose(chosen, chosen.frame_time(frame), actor.character->start));
}

Project apply_pose_text(const Project& project, int id, std::string_view pose, double strength, bool flipped) {
  const Actor& actor = actor_with_id(project, id);
  if (!(strength >= 0.0 && strength <= 1.0)) throw_invalid_argument("apply_pose: wanted a strength from 0 to 1");
  const Character& character = *actor.character;
  Pose goal = read_pose_text(pose, character, actor.pose);
  if (flipped) {
    const std::vector<int> partners = compute_mirror_map(character.skeleton, character.humanoid);
    goal = mirror_pose(character.skeleton, character.humanoid, partners, character.front, goal);
  }
  return set_pose(project, actor_index(project, id), blend_pose(actor.pose, goal, strength));
}

Project keep_pose(const Project& project, int id, const std::string& name) {
  const int index = actor_index(project, id);
  if (trim(name).empty()) throw_invalid_argument("a pose needs a name");
  Project next = project;
  std::erase_if(next.poses, [&](const NamedPose& kept) { return kept.actor == index && kept.name == name; });
  next.poses.push_back({name, index, next.actors[at(index)].pose});
  return next;
}

}  // namespace croquis
