// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace croquis {

/// What an iterative algorithm says of its result.
struct SolveReport {
  std::string status = "ok";  ///< "ok", or one sentence on what is not as asked
  int iterations = 0;
  double residual = 0.0;  ///< of the algorithm's own measure at the end
};

}  // namespace croquis
