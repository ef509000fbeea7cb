#pragma once

#include <cmath>

namespace gable {

/// A robust loss folded into the residual: with rho the soft L1 loss of scale a (metres),
/// rho(r^2) = 2 a^2 (sqrt(1 + r^2/a^2) - 1), the value `robust(r)` is signed and satisfies
/// robust(r)^2 = rho(r^2). Its square is the cost, so its derivative gives the exact gradient, and
/// J'J of robust residuals is the Gauss-Newton Hessian used everywhere in gable. Smooth at 0.
class SoftL1 {
 public:
  /// scale: metres, > 0. Residuals far above it count linearly.
  explicit SoftL1(double scale) : inverse_square_(1.0 / (scale * scale)) {}

  template <typename T>
  T robust(const T& r) const {
    using std::sqrt;
    return r * sqrt(T(2.0) / (T(1.0) + sqrt(T(1.0) + r * r * T(inverse_square_))));
  }

  /// robust(r) and its derivative.
  void evaluate(double r, double* value, double* derivative) const {
    const double root = std::sqrt(1.0 + r * r * inverse_square_);
    const double factor = std::sqrt(2.0 / (1.0 + root));
    *value = r * factor;
    *derivative = 1.0 / (root * factor);
  }

  /// rho(r^2) = robust(r)^2.
  double cost(double r) const {
    return 2.0 * r * r / (1.0 + std::sqrt(1.0 + r * r * inverse_square_));
  }

 private:
  double inverse_square_;
};

}  // namespace gable
