// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "croquis/math/camera.h"
#include "croquis/project/character.h"
#include "croquis/rig/body_line.h"
#include "croquis/sketch/stroke.h"

namespace croquis {

/// How a stroke is meant: everything needed to solve it again and get the same pose.
struct StrokeSettings {
  std::string method = "line";     ///< a method's name as on the command line
  std::string body_line;           ///< a standard line's name, or "auto"; empty where `joints` says it
  std::vector<int> joints;         ///< the path, in the stroke's order; empty where `body_line` says it
  std::string plane = "free";      ///< free | ground
  std::string root = "auto";       ///< lock | tangent | free | auto (free for the line solver, else lock)
  std::string direction = "auto";  ///< auto | forward | backward | length
  std::string move = "line";       ///< line | body: what else may move
  std::string length = "fit";      ///< fit | scale | trim | extend
  double exaggerate = 1.0;         ///< factor on the line's curvature, 0..2
  double weight = 1.0;             ///< against other strokes, > 0
  int alternative = 0;             ///< which reading of the line, 0 the likeliest
  int depth = 0;                   ///< which of the depths that the picture leaves open, 0 the best
  bool live = false;               ///< posed while it was drawn, each sample from the pose before it; else as a whole

  [[nodiscard]] friend bool operator==(const StrokeSettings&, const StrokeSettings&) = default;
};

/// A stroke in the view it was drawn in, on a character.
struct PlacedStroke {
  Stroke stroke;
  Camera camera;
  StrokeSettings settings;
  int actor = 0;
  bool hidden = false;
  int id = 0;                  ///< unlike any other stroke's; 0 where nobody refers to it
  std::optional<Pose> before;  ///< how the actor stood when it was drawn: where solving it again starts
  BodyLine line;               ///< the line that was solved last; no joints before
};

/// A joint that stays where it is while the rest moves.
struct Pin {
  int joint = 0;
  Vec3 position = Vec3::Zero();  ///< model space
  std::optional<Quat> rotation;  ///< model space; without it the joint may turn in its place

  [[nodiscard]] friend bool operator==(const Pin&, const Pin&) = default;
};

/// A character on the table with the pose it holds now.
struct Actor {
  std::shared_ptr<const Character> character;
  Pose pose;
  int id = 0;  ///< unlike any other actor's; 0 where nobody refers to it
  std::vector<Pin> pins;
  Vec3 place = Vec3::Zero();                  ///< where it was set down: its character stands there at rest
  std::string builtin;                        ///< the name of a built-in character; empty for one from a file
  std::map<std::string, double> proportions;  ///< of a built-in character, where they are not as designed
};

/// What holds for every line drawn on this table.
struct TableSettings {
  std::string limits = "anatomical";  ///< anatomical | dancer | cartoon | none
  bool floor = true;                  ///< nothing goes below the floor, feet that stand on it stay
  bool balance = false;               ///< the centre of mass stays over the feet
  std::string root = "free";          ///< lock | tangent | free

  [[nodiscard]] friend bool operator==(const TableSettings&, const TableSettings&) = default;
};

struct NamedPose {
  std::string name;
  int actor = 0;
  Pose pose;
};

struct NamedView {
  std::string name;
  Camera camera;
};

/// Everything that is saved, as a value: copying it shares the characters. See edit/ for what can be done with it.
struct Project {
  std::vector<Actor> actors;
  std::vector<PlacedStroke> strokes;
  std::vector<NamedPose> poses;
  std::vector<NamedView> views;
  TableSettings settings;
  int next_id = 1;  ///< for the next actor or stroke

  /// Throws invalid_argument unless indices and sizes fit.
  void check() const;
};

}  // namespace croquis
