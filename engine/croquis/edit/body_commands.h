// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "croquis/posing/pose_edit.h"
#include "croquis/project/project.h"

/// What a hand does to a body on the table: pure functions of the project, as in commands.h. Actors are named by their
/// ids; an id that no actor has throws invalid_argument.
namespace croquis {

/// The place of an actor in `project.actors`.
[[nodiscard]] int actor_index(const Project& project, int id);

/// Removes an actor with its strokes and poses.
[[nodiscard]] Project remove_actor(const Project& project, int id);

/// Drags a joint to a point in model space: a hand, foot or head by its limb; the hips carry the body while pinned
/// joints, and with `settings.floor` the feet that stand, stay. `status` (if given) receives "ok" or what could not be.
[[nodiscard]] Project drag_joint(const Project& project, int id, int joint, const Vec3& target_model,
                                 std::string* status = nullptr);
/// Turns a joint and what hangs on it about its place; pinned joints below it are held.
[[nodiscard]] Project rotate_joint(const Project& project, int id, int joint, const Quat& turn_model);
/// Holds a joint where it is now (with its rotation, too), or lets it go.
[[nodiscard]] Project pin_joint(const Project& project, int id, int joint, bool on, bool with_rotation);

[[nodiscard]] Project mirror_actor(const Project& project, int id, MirrorSide side);
/// Moves an actor's pose toward its rest pose by `amount`; of the joints given, or of all where there are none.
[[nodiscard]] Project reset_actor(const Project& project, int id, const std::vector<int>& joints, double amount);
/// Poses an actor as in a frame of one of its clips.
[[nodiscard]] Project go_to_frame(const Project& project, int id, int clip, int frame);

/// A pose as text that other characters understand (see edit/pose_text.h), applied with `strength` 0..1.
[[nodiscard]] Project apply_pose_text(const Project& project, int id, std::string_view pose, double strength,
                                      bool flipped);
/// Keeps the actor's pose under a name; one of that name is replaced.
[[nodiscard]] Project keep_pose(const Project& project, int id, const std::string& name);

/// Moves the limbs of pinned joints (and, with `settings.floor`, of feet that stand in `before`) back to where they
/// are held.
[[nodiscard]] Pose hold_pins(const Project& project, const Actor& actor, const Pose& before, const Pose& after,
                             std::string* status = nullptr);

}  // namespace croquis
