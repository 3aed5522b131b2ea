// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "croquis/edit/readings.h"

namespace CLI {
class App;
}

namespace croquis::cli {

/// --line and what says how it is meant, and the rules that hold for the whole figure.
struct LineOptions {
  std::string file;
  std::string joints;
  StrokeSettings settings;
  int alternatives = 0;
  int alternative = 0;
  std::string limits;  ///< empty: as the project says
  std::optional<bool> floor;
  bool balance = false;
  std::vector<std::string> pins;

  void add_to(CLI::App& command);
  /// Throws invalid_argument for a word or a number that cannot be, whatever the character.
  void check() const;
  /// The project with these rules; pins hold in the pose that its first actor has now.
  [[nodiscard]] Project with_rules(Project project, bool is_new) const;
};

/// The strokes of a line file and how else they may be read.
struct PlacedLines {
  std::vector<PlacedStroke> strokes;
  std::vector<std::vector<StrokeReading>> alternatives;  ///< per stroke, as many as were asked for at most
};

/// Reads the strokes for the first actor: a lone one is for the line that was asked for, that its id names, or the
/// default one; several are each for a line of their own, found by their ids or by where they were drawn.
[[nodiscard]] PlacedLines read_lines(const LineOptions& options, const Project& project, const Camera& camera,
                                     std::vector<std::string>& notices);

}  // namespace croquis::cli
