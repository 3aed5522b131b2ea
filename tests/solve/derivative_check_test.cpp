// SPDX-License-Identifier: MIT
#include "croquis/solve/derivative_check.h"

#include <gtest/gtest.h>

namespace croquis {
namespace {

TEST(DerivativeCheck, AcceptsARightJacobianAndSeesAWrongOne) {
  const double factor[] = {2.0, 2.1};
  for (int wrong = 0; wrong < 2; ++wrong) {
    const ResidualFunction residuals = [&](const Eigen::VectorXd& x, Eigen::MatrixXd* jacobian) {
      if (jacobian != nullptr) {
        *jacobian = Eigen::MatrixXd::Zero(2, 2);
        (*jacobian)(0, 0) = factor[wrong] * x[0];
        (*jacobian)(1, 1) = 1.0;
      }
      return Eigen::VectorXd(Eigen::Vector2d(x[0] * x[0], x[1]));
    };
    const double error = jacobian_error(residuals, Eigen::Vector2d(3.0, 1.0));
    EXPECT_EQ(error < 1e-6, wrong == 0);
  }
}

}  // namespace
}  // namespace croquis
