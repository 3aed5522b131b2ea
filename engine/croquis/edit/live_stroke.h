// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "croquis/posing/live_line.h"
#include "croquis/project/project.h"

namespace croquis {

/// Whether a stroke with these settings is followed while it is drawn; otherwise it is solved as a whole.
[[nodiscard]] bool is_followed_live(const StrokeSettings& settings);

/// A stroke that is being drawn over the pose of an actor, and the pose that follows it. What comes of it depends on
/// the samples alone, not on how many came at a time: the pen is followed in steps of a few pixels. Where the settings
/// leave the body line open it is chosen once, when the stroke is a twentieth of the body long, by where it started and
/// where it went; until then nothing moves.
class LiveStroke {
 public:
  /// The samples of `stroke` are not looked at. Throws as choose_line and solve_lines do.
  LiveStroke(const Project& project, const PlacedStroke& stroke);

  /// Whether it is this stroke, over this pose, that is followed.
  [[nodiscard]] bool follows(const Project& project, const PlacedStroke& stroke) const;
  /// All samples so far. Where they do not go on from the ones before, they are followed from the start.
  const Pose& update(const std::vector<StrokeSample>& samples);

  [[nodiscard]] const Pose& pose() const { return line_ ? line_->pose() : start_; }
  [[nodiscard]] const BodyLine& body_line() const { return body_line_; }  ///< no joints before it is chosen
  [[nodiscard]] bool forward() const { return line_ ? line_->forward() : true; }

 private:
  void restart();
  void begin(const std::vector<Vec2>& points);

  std::shared_ptr<const Character> character_;
  std::vector<Pin> pins_;
  TableSettings table_;
  Pose start_;
  Camera camera_;
  StrokeSettings settings_;
  LineSolverOptions options_;
  double least_px_ = 0.0;  ///< the stroke's length when its line is chosen
  BodyLine body_line_;
  std::optional<LiveLine> line_;
  std::vector<StrokeSample> seen_;
  std::vector<Vec2> points_;  ///< of the samples that were followed
  double drawn_px_ = 0.0;
};

/// The body line, and the way along it, that a stroke is likeliest meant for of which only the beginning is drawn.
struct BegunLine {
  BodyLine line;
  bool forward = true;
};
[[nodiscard]] BegunLine choose_begun_line(const Character& character, const Pose& pose, const std::vector<Vec2>& points,
                                          const Camera& camera);

}  // namespace croquis
