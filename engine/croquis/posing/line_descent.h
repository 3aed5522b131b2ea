// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Cholesky>

#include "croquis/posing/line_limits.h"
#include "croquis/posing/line_problem.h"

namespace croquis {

struct DescentOptions {
  int iterations = 30;      ///< at most
  double tolerance = 1e-7;  ///< relative decrease of the energy below which it stops
  double most_turn = 0.0;   ///< radians that a joint may turn in one step; 0: any
};

struct DescentReport {
  double energy = 0.0;
  int iterations = 0;
  bool converged = false;
};

/// Levenberg-Marquardt on a LineProblem (marquardt1963, damping after nielsen1999). Keeps its workspace: minimising the
/// same problem again allocates nothing. Joint limits hold exactly at every step: what starts outside is brought in
/// first, then steps slide along limits (projected descent with an active set, bertsekas1982).
class LineDescent {
 public:
  void prepare(const LineProblem& problem);
  /// Improves `state` in place; the problem must be the one prepared for (its numbers may have changed, not its sizes).
  DescentReport minimise(const LineProblem& problem, LineState& state, const DescentOptions& options);

 private:
  void damp(double damping, bool circling);
  [[nodiscard]] double try_step(const LineProblem& problem, const LineState& state, double damping, double most_turn);
  LineModel model_;
  LineState trial_;
  Eigen::MatrixXd damped_;
  Eigen::VectorXd step_;
  Eigen::LLT<Eigen::MatrixXd> factor_;
  std::vector<ActiveLimit> active_;
  std::vector<Crossing> crossings_;
};

}  // namespace croquis
