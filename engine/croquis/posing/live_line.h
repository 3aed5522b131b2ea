// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>

#include "croquis/posing/line_solver.h"

namespace croquis {

/// A stroke while it is being drawn, and the pose that follows it. The stroke holds as much of the body line as its
/// length reaches; the rest goes on straight along its end, gently as long as the stroke is short. Each update descends
/// from the pose before it, and no joint turns by more than 2.5 degrees per pixel that the pen has gone: the pose moves
/// with the pen and never jumps between hypotheses, and lifting the pen changes nothing. Feet that stand (with a floor,
/// options.stand) go on standing until the line is out of their reach. After the first update nothing is allocated.
class LiveLine {
 public:
  /// `start` is the pose drawn over. The length policy is always `extend`. `skeleton` must outlive the object. Throws
  /// as solve_lines does.
  LiveLine(const Skeleton& skeleton, const HumanoidMap& humanoid, const Pose& start, const BodyLine& line,
           LineInput::Direction direction, const Camera& camera, const LineSolverOptions& options = {});
  ~LiveLine();
  LiveLine(LiveLine&&) noexcept;
  LiveLine& operator=(LiveLine&&) noexcept;

  /// All points drawn so far, pixels. With fewer than two points apart the pose is the start pose. An automatic
  /// direction is chosen with the first real points and then kept: the stroke starts at that end of the line which is
  /// nearer to its first point. Points that are not finite throw invalid_argument and leave the pose as it was.
  const Pose& update(std::span<const Vec2> points);

  [[nodiscard]] const Pose& pose() const;
  [[nodiscard]] bool forward() const;  ///< the stroke starts at the line's first joint
  [[nodiscard]] double energy() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace croquis
