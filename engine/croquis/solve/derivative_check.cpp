// SPDX-License-Identifier: MIT
#include "croquis/solve/derivative_check.h"

#include <algorithm>

namespace croquis {

double jacobian_error(const ResidualFunction& residuals, const Eigen::VectorXd& x, double step) {
  Eigen::MatrixXd analytic;
  const Eigen::VectorXd at_x = residuals(x, &analytic);
  Eigen::MatrixXd numeric(at_x.size(), x.size());
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    Eigen::VectorXd forward = x, backward = x;
    forward[i] += step;
    backward[i] -= step;
    numeric.col(i) = (residuals(forward, nullptr) - residuals(backward, nullptr)) / (2.0 * step);
  }
  if (numeric.size() == 0) return 0.0;
  return (analytic - numeric).cwiseAbs().maxCoeff() / std::max(1.0, numeric.cwiseAbs().maxCoeff());
}

}  // namespace croquis
