// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Cholesky>

#include "croquis/posing/line_problem.h"

namespace croquis {

struct DescentOptions {
  int iterations = 30;      ///< at most
  double tolerance = 1e-7;  ///< relative decrease of the energy below which it stops
};

struct DescentReport {
  double energy = 0.0;
  int iterations = 0;
  bool converged = false;
};

/// Levenberg-Marquardt on a LineProblem (marquardt1963, damping after nielsen1999). Keeps its workspace: minimising the
/// same problem again allocates nothing.
class LineDescent {
 public:
  void prepare(const LineProblem& problem);
  /// Improves `state` in place; the problem must be the one prepared for (its numbers may have changed, not its sizes).
  DescentReport minimise(const LineProblem& problem, LineState& state, const DescentOptions& options);

 private:
  LineModel model_;
  LineState trial_;
  Eigen::MatrixXd damped_;
  Eigen::VectorXd step_;
  Eigen::LLT<Eigen::MatrixXd> factor_;
};

}  // namespace croquis
