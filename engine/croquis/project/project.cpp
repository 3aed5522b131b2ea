// SPDX-License-Identifier: MIT
#include "croquis/project/project.h"

#include "croquis/base/error.h"

namespace croquis {

void Project::check() const {
  const auto want = [](bool holds, const std::string& what) {
    if (!holds) throw_invalid_argument("Project: " + what);
  };
  const auto is_actor = [&](int actor) { return actor >= 0 && actor < std::ssize(actors); };
  const auto fits = [&](const Pose& pose, int actor) {
    return std::ssize(pose.local) == actors[static_cast<std::size_t>(actor)].character->skeleton.joint_count();
  };
  for (int i = 0; i < std::ssize(actors); ++i) {
    const Actor& actor = actors[static_cast<std::size_t>(i)];
    want(actor.character != nullptr, "an actor has no character");
    want(fits(actor.pose, i), "an actor's pose does not fit its skeleton");
    for (const Pin& pin : actor.pins) {
      want(pin.joint >= 0 && pin.joint < actor.character->skeleton.joint_count(),
           "a pin holds a joint that is not there");
    }
  }
  for (const PlacedStroke& placed : strokes) {
    want(is_actor(placed.actor), "a stroke belongs to an actor that is not there");
    want(!placed.before || fits(*placed.before, placed.actor), "the pose under a stroke does not fit its actor");
    placed.camera.check();
  }
  for (const NamedPose& named : poses) {
    want(is_actor(named.actor) && fits(named.pose, named.actor), "the pose '" + named.name + "' fits no actor");
  }
  for (const NamedView& view : views) view.camera.check();
}

}  // namespace croquis
