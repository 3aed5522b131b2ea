// SPDX-License-Identifier: MIT
#include "croquis/posing/correspondence.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace croquis {

void Correspondence::solve(const StrokeCurve& curve, std::span<const BoneSpan> bones,
                           const CorrespondenceWeights& weights, std::vector<double>& along) {
  constexpr std::size_t kCells = static_cast<std::size_t>(kGrid);
  const std::size_t count = bones.size();
  const double step = curve.length() / (kGrid - 1);
  chord_.assign(kCells * kCells, 0.0);
  uneven_.assign(kCells * kCells, 0.0);
  for (std::size_t a = 0; a < kCells; ++a) {
    for (std::size_t b = a + 1; b < kCells; ++b) {
      const double from = step * static_cast<double>(a), to = step * static_cast<double>(b);
      chord_[a * kCells + b] = (curve.at(to) - curve.at(from)).norm();
      uneven_[a * kCells + b] = curve.unevenness(from, to);
    }
  }
  best_.assign((count + 1) * kCells, std::numeric_limits<double>::infinity());
  from_.assign((count + 1) * kCells, 0);
  best_[0] = 0.0;
  for (std::size_t k = 0; k < count; ++k) {
    const double length = std::max(bones[k].length, weights.short_bone);
    for (std::size_t a = 0; a < kCells; ++a) {
      const double before = best_[k * kCells + a];
      if (!std::isfinite(before)) continue;
      for (std::size_t b = a; b < kCells; ++b) {
        const double ratio = chord_[a * kCells + b] / length;
        const double depth = ratio < 1.0 ? std::sqrt(1.0 - ratio * ratio) : 0.0;
        const double over = std::max(0.0, ratio - 1.0);
        const double cost = before + weights.depth * (depth - bones[k].depth) * (depth - bones[k].depth) +
                            weights.stretch * over * over +
                            weights.uneven * uneven_[a * kCells + b] / (length * length);
        double& best = best_[(k + 1) * kCells + b];
        if (cost < best) {
          best = cost;
          from_[(k + 1) * kCells + b] = static_cast<int>(a);
        }
        if (ratio > 3.0) break;  // ever longer chords only get worse, but for loops
      }
    }
  }
  cost_ = best_[count * kCells + kCells - 1];
  along.resize(count + 1);
  std::size_t cell = kCells - 1;
  for (std::size_t k = count + 1; k-- > 0;) {
    along[k] = step * static_cast<double>(cell);
    cell = static_cast<std::size_t>(from_[k * kCells + cell]);
  }
  if (!std::isfinite(cost_)) {  // a stroke many times longer than the chain: by length
    double total = 0.0, sum = 0.0;
    for (const BoneSpan& bone : bones) total += bone.length;
    for (std::size_t k = 0; k <= count; ++k) {
      along[k] = total > 0.0 ? curve.length() * sum / total
                             : curve.length() * static_cast<double>(k) / static_cast<double>(count);
      if (k < count) sum += bones[k].length;
    }
  }
}

}  // namespace croquis
