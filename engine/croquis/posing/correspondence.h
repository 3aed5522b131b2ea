// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "croquis/posing/stroke_curve.h"

namespace croquis {

/// What the correspondence knows of a bone.
struct BoneSpan {
  double length = 0.0;  ///< as it would project lying flat in the picture
  double depth = 0.0;   ///< |depth| of the bone in the start pose, per its length: 0 flat, 1 end-on
};

struct CorrespondenceWeights {
  double depth = 1.0;        ///< (depth ratio - that of the start pose)^2
  double stretch = 200.0;    ///< (chord / length - 1)^2 of chords longer than the bone
  double uneven = 20.0;      ///< mean squared distance of the stroke from the chord, per squared length of the bone
  double short_bone = 0.02;  ///< bones shorter than this count as if they had this length
};

/// Where the joints of a chain land on a stroke: arc lengths s_0 = 0 <= s_1 <= ... <= s_n = length that minimise a sum
/// over bones of how implausible it is that this bone covers that piece of the stroke, by dynamic programming on a grid
/// of arc lengths, O(bones * grid^2).
class Correspondence {
 public:
  static constexpr int kGrid = 73;
  void solve(const StrokeCurve& curve, std::span<const BoneSpan> bones, const CorrespondenceWeights& weights,
             std::vector<double>& along);
  [[nodiscard]] double cost() const { return cost_; }

 private:
  std::vector<double> best_;  ///< (joint, grid point): least cost of the bones before
  std::vector<int> from_;
  std::vector<double> chord_, uneven_;
  double cost_ = 0.0;
};

}  // namespace croquis
