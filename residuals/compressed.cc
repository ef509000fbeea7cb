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
    // R is upper * P: P's transpositions swap columns, the last one first.
    const auto& transpositions = ldlt.transpositionsP().indices();
    for (int k = n - 1; k >= 0; --k) {
      const int other = static_cast<int>(transpositions[k]);
      if (other != k) out.jacobian.col(k).swap(out.jacobian.col(other));
    }
  }
  out.residuals[n] = std::sqrt(std::max(0.0, normal.squared_residuals - explained));
  return out;
}

}  // namespace gable
