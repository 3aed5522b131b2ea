// SPDX-License-Identifier: MIT
#include "croquis/mesh/skin.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "croquis/base/error.h"

namespace croquis {

void Skin::check(int vertex_count, int joint_count) const {
  const auto want = [&](bool holds, const std::string& what) {
    if (!holds) throw_invalid_argument("Skin: " + what);
  };
  want(influences >= 1, "wanted at least one influence per vertex");
  want(joints.size() == inverse_bind.size(), "wanted one inverse bind matrix per joint");
  want(joints.size() <= 65536, "wanted at most 65536 joints");
  const auto slots = static_cast<std::size_t>(vertex_count) * static_cast<std::size_t>(influences);
  want(joint_indices.size() == slots && weights.size() == slots,
       "wanted " + std::to_string(slots) + " joint indices and weights");
  want(std::all_of(joints.begin(), joints.end(), [&](int j) { return j >= 0 && j < joint_count; }),
       "a palette entry names a joint that is not there");
  want(std::all_of(joint_indices.begin(), joint_indices.end(), [&](std::uint16_t j) { return j < joints.size(); }),
       "a vertex names a palette entry that is not there");
  want(std::all_of(weights.begin(), weights.end(), [](float w) { return std::isfinite(w) && w >= 0.0F; }),
       "a weight is negative or not finite");
}

void normalise_weights(Skin& skin) {
  const auto slots = static_cast<std::size_t>(skin.influences);
  std::vector<std::pair<float, std::uint16_t>> vertex(slots);
  for (std::size_t first = 0; first < skin.weights.size(); first += slots) {
    float sum = 0.0F;
    for (std::size_t k = 0; k < slots; ++k) {
      vertex[k] = {skin.weights[first + k], skin.joint_indices[first + k]};
      sum += skin.weights[first + k];
    }
    std::stable_sort(vertex.begin(), vertex.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    for (std::size_t k = 0; k < slots; ++k) {
      const bool used = vertex[k].first > 0.0F && sum > 0.0F;
      skin.weights[first + k] = used ? vertex[k].first / sum : 0.0F;
      skin.joint_indices[first + k] = used ? vertex[k].second : std::uint16_t{0};
    }
  }
}

}  // namespace croquis
