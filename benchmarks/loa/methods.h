// SPDX-License-Identifier: MIT
#pragma once

#include "loa/draws.h"
#include <functional>
#include <string>
#include <vector>

namespace croquis::loa {

/// A way of answering a draw.
struct Method {
  std::string name;
  std::function<Pose(const Draw&)> answer;
};

/// start, near, curvilinear, rotation by index, rotation by arc length, the line solver, and the solver told the true
/// correspondence or the true depths. `direction_known`: they are told where the stroke starts.
[[nodiscard]] std::vector<Method> all_methods(bool direction_known);

}  // namespace croquis::loa
