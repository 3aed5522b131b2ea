// SPDX-License-Identifier: MIT
// D. W. Marquardt, An Algorithm for Least-Squares Estimation of Nonlinear Parameters (1963); the damping rule is H. B.
// Nielsen's, Damping Parameter in Marquardt's Method (1999).
#include "croquis/posing/line_descent.h"

#include <algorithm>
#include <cmath>

namespace croquis {

void LineDescent::prepare(const LineProblem& problem) {
  problem.prepare(model_);
  const Eigen::Index n = problem.unknowns();
  damped_.setZero(n, n);
  step_.setZero(n);
  factor_ = Eigen::LLT<Eigen::MatrixXd>(n);
  trial_ = problem.start_state();
}

DescentReport LineDescent::minimise(const LineProblem& problem, LineState& state, const DescentOptions& options) {
  DescentReport report;
  problem.linearise(state, model_);
  report.energy = model_.energy;
  double damping = 1e-3, growth = 2.0;
  while (report.iterations < options.iterations) {
    ++report.iterations;
    damped_.triangularView<Eigen::Lower>() = model_.normal;
    damped_.diagonal().array() += damping * (model_.normal.diagonal().array() + 1e-6) + 1e-12;
    factor_.compute(damped_);
    step_ = -model_.gradient;
    factor_.solveInPlace(step_);
    problem.advance(state, step_, trial_);
    const double energy = problem.energy(trial_);
    const double decrease = report.energy - energy;
    if (std::isfinite(energy) && decrease > 0.0) {
      double predicted = -0.5 * step_.dot(model_.gradient);
      for (Eigen::Index i = 0; i < step_.size(); ++i) {
        predicted += 0.5 * damping * (model_.normal(i, i) + 1e-6) * step_[i] * step_[i];
      }
      const double gain = predicted > 0.0 ? decrease / predicted : 1.0;
      damping = std::max(1e-9, damping * std::max(1.0 / 3.0, 1.0 - std::pow(2.0 * gain - 1.0, 3)));
      growth = 2.0;
      std::swap(state, trial_);
      report.energy = energy;
      report.converged = decrease <= options.tolerance * energy;
      if (report.converged) break;
      problem.linearise(state, model_);
    } else {
      report.converged = std::isfinite(energy) && -decrease <= 1e-14 * report.energy;
      if (report.converged || damping > 1e8) break;
      damping *= growth;
      growth *= 2.0;
    }
  }
  return report;
}

}  // namespace croquis
