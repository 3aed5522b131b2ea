// SPDX-License-Identifier: MIT
// D. W. Marquardt, An Algorithm for Least-Squares Estimation of Nonlinear Parameters (1963); the damping rule is H. B.
// Nielsen's, Damping Parameter in Marquardt's Method (1999). D. P. Bertsekas, Projected Newton Methods for Optimization
// Problems with Simple Constraints (1982).
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
  active_.reserve(3 * problem.limits.size());
  crossings_.reserve(problem.limits.size());
}

/// Factors the damped matrix of a step that keeps to the active limits; `circling`: Newton's, else Gauss-Newton's.
void LineDescent::damp(double damping, bool circling) {
  damped_.triangularView<Eigen::Lower>() = model_.normal;
  if (circling) damped_.triangularView<Eigen::Lower>() += model_.circling;
  damped_.diagonal().array() += damping * (model_.normal.diagonal().array() + 1e-6) + 1e-12;
  for (const ActiveLimit& limit : active_) {
    const double stiff = 1e6 * (1.0 + model_.normal.diagonal().segment<3>(limit.column).maxCoeff());
    damped_.block<3, 3>(limit.column, limit.column) += stiff * limit.normal * limit.normal.transpose();
  }
  factor_.compute(damped_);
}

/// The energy after a damped step from `state` that keeps to the active limits, left in trial_.
double LineDescent::try_step(const LineProblem& problem, const LineState& state, double damping, double most_turn) {
  constexpr int kAttempts = 3;
  double energy = 0.0;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    damp(damping, model_.exact);
    if (model_.exact && factor_.info() != Eigen::Success) damp(damping, false);
    step_ = -model_.gradient;
    factor_.solveInPlace(step_);
    if (most_turn > 0.0) {
      double largest = 0.0;
      for (const LineNode& node : problem.nodes) {
        if (node.column >= 0) largest = std::max(largest, step_.segment<3>(node.column).norm());
      }
      if (largest > most_turn) step_ *= most_turn / largest;
    }
    problem.advance(state, step_, trial_);
    clamp_to_limits(problem, trial_, crossings_);
    energy = problem.energy(trial_);
    if (energy < model_.energy) break;
    // A limit that cut the step short joins the active ones, and its neighbours try again without it.
    bool more = false;
    for (const Crossing& crossing : crossings_) {
      const bool known = std::any_of(active_.begin(), active_.end(),
                                     [&](const ActiveLimit& limit) { return limit.limit == crossing.limit; });
      if (known || active_.size() >= active_.capacity()) continue;
      const LineNode& node = problem.nodes[static_cast<std::size_t>(problem.limits[crossing.limit].node)];
      active_.push_back({crossing.limit, node.column, limit_normal(problem, state, crossing.limit, crossing.outward)});
      more = true;
    }
    if (!more) break;
  }
  return energy;
}

DescentReport LineDescent::minimise(const LineProblem& problem, LineState& state, const DescentOptions& options) {
  // Far from a minimum Newton's matrix leads astray; near one, where strokes are out of reach and residuals remain, it
  // settles in a few steps where Gauss-Newton takes hundreds.
  constexpr double kNear = 0.02, kCrawl = 1e-6;
  DescentReport report;
  clamp_to_limits(problem, state, crossings_);
  model_.exact = false;
  problem.linearise(state, model_);
  find_active_limits(problem, state, model_.gradient, active_);
  report.energy = model_.energy;
  double damping = 1e-3, growth = 2.0;
  while (report.iterations < options.iterations) {
    ++report.iterations;
    const double energy = try_step(problem, state, damping, options.most_turn);
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
      // Along a curved limit steps get small before the energy stands still.
      const bool crawls = decrease <= kCrawl * energy && step_.norm() < std::sqrt(kCrawl);
      report.converged = decrease <= options.tolerance * energy || crawls;
      model_.exact = decrease <= kNear * energy;
      if (report.converged) break;
      problem.linearise(state, model_);
    } else {
      report.converged = std::isfinite(energy) && -decrease <= 1e-14 * report.energy;
      if (report.converged || damping > 1e8) break;
      damping *= growth;
      growth *= 2.0;
    }
    find_active_limits(problem, state, model_.gradient, active_);
  }
  report.converged = report.converged || damping > 1e8;  // no step of any size gains anything
  return report;
}

}  // namespace croquis
