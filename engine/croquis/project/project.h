// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "croquis/math/camera.h"
#include "croquis/project/character.h"
#include "croquis/sketch/stroke.h"

namespace croquis {

/// How a stroke is meant: everything needed to solve it again and get the same pose.
struct StrokeSettings {
  std::string method = "rotation";  ///< a method's name as on the command line
  std::string body_line;            ///< a standard line's name; empty where `joints` says it
  std::vector<int> joints;          ///< the path, in the stroke's order; empty where `body_line` says it
  std::string plane = "free";       ///< free | ground
  std::string root = "lock";        ///< lock | tangent | free
  std::string direction = "auto";   ///< auto | forward | backward | length
};

/// A stroke in the view it was drawn in, on a character.
struct PlacedStroke {
  Stroke stroke;
  Camera camera;
  StrokeSettings settings;
  int actor = 0;
  bool hidden = false;
};

/// A character on the table with the pose it holds now.
struct Actor {
  std::shared_ptr<const Character> character;
  Pose pose;
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

  /// Throws invalid_argument unless indices and sizes fit.
  void check() const;
};

}  // namespace croquis
