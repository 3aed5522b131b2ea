// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include <Eigen/Core>

namespace croquis {

/// A residual vector r(x) and, where `jacobian` is not null, dr/dx (rows: residuals, columns: unknowns).
using ResidualFunction = std::function<Eigen::VectorXd(const Eigen::VectorXd& x, Eigen::MatrixXd* jacobian)>;

/// The one check of every analytic Jacobian: the largest difference to central differences with step `step`, relative
/// to max(1, the largest entry).
[[nodiscard]] double jacobian_error(const ResidualFunction& residuals, const Eigen::VectorXd& x, double step = 1e-6);

}  // namespace croquis
