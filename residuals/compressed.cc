#include <gable/residuals/compressed.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

namespace gable {

CompressedResiduals compress(const NormalEquations& normal) {
  const int n = static_cast<int>(normal.jtr.size());
  CompressedResiduals out;
  out.residuals.setZero(n + 1);
  out.jacobian.setZero(n + 1, n);
  double explained = 0.0;
  if (n > 0) {
    // P J'J P' = L D L', so R = sqrt(D) L' P and s = D^-1/2 L^-1 P J'r.
    const Eigen::LDLT<Eigen::MatrixXd> ldlt(normal.jtj);
    const Eigen::VectorXd d = ldlt.vectorD();
    const Eigen::MatrixXd upper = ldlt.matrixU();
    Eigen::VectorXd s = ldlt.transpositionsP() * normal.jtr;
    ldlt.matrixL().solveInPlace(s);
    const double smallest =
        n * std::numeric_limits<double>::epsilon() * std::max(d.maxCoeff(), 0.0);
    for (int i = 0; i < n; ++i) {
      if (!(d[i] > smallest)) continue;
      const double root = std::sqrt(d[i]);
      out.jacobian.row(i) = root * upper.row(i);
      out.residuals[i] = s[i] / root;
      explained += out.residuals[i] * out.residuals[i];
    }
    // P as a permutation of R's columns: R P is upper * P.
    out.jacobian.topRows(n) =
        (out.jacobian.topRows(n) *
         Eigen::MatrixXd(ldlt.transpositionsP() * Eigen::MatrixXd::Identity(n, n)))
            .eval();
  }
  out.residuals[n] = std::sqrt(std::max(0.0, normal.squared_residuals - explained));
  return out;
}

}  // namespace gable
