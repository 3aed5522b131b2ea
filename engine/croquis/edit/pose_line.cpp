// SPDX-License-Identifier: MIT
#include "croquis/edit/pose_line.h"

#include <utility>

#include "croquis/base/error.h"
#include "croquis/base/text.h"
#include "croquis/edit/line_choice.h"

namespace croquis {

PoseLine read_pose_line(const Actor& actor, const StrokeSettings& settings, const Camera& camera) {
  const Character& character = *actor.character;
  LineChoice choice = choose_line(character, settings);
  if (choice.line.joints.empty()) {
    throw_invalid_argument("joints " + printable(choice.line.name) + ": a line is read off a path of joints");
  }
  const Polyline2 curve = extract_line(character.skeleton, actor.pose, choice.line, camera);
  PoseLine read;
  read.stroke.name = choice.line.name;
  for (const Vec2& point : curve.points()) read.stroke.samples.push_back({point});
  read.line = std::move(choice.line);
  read.character = classify_line(curve);
  return read;
}

}  // namespace croquis
