#pragma once

#include <Eigen/Core>

namespace gable {

/// The normal equations of m residuals r with Jacobian J over n parameters: all that a
/// Gauss-Newton or Levenberg-Marquardt step needs of them, whatever m is.
struct NormalEquations {
  Eigen::MatrixXd jtj;             ///< n x n, J'J
  Eigen::VectorXd jtr;             ///< n, J'r
  double squared_residuals = 0.0;  ///< r'r

  void set_zero(int n) {
    jtj.setZero(n, n);
    jtr.setZero(n);
    squared_residuals = 0.0;
  }
};

/// n + 1 residuals that stand for the m original ones: with `jacobian` R and residuals (s, c),
///   R'R = J'J,   R's = J'r,   |s|^2 + c^2 = r'r,
/// so cost, gradient and Gauss-Newton Hessian are those of the original problem. The last row is
/// constant (its Jacobian is zero). Directions that no residual sees have a zero row.
struct CompressedResiduals {
  Eigen::VectorXd residuals;  ///< n + 1
  Eigen::MatrixXd jacobian;   ///< (n + 1) x n
};

/// Compresses by a pivoted Cholesky factorisation of J'J, which tolerates rank deficiency.
CompressedResiduals compress(const NormalEquations& normal);

}  // namespace gable
