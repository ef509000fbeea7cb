#pragma once

#include <cmath>

namespace gable {

/// The robust losses of heights.
enum class LossKind {
  kSoftL1,       ///< rho(r) = 2 a^2 (sqrt(1 + r^2/a^2) - 1): linear far out, pulls from anywhere
  kGemanMcClure  ///< rho(r) = r^2 / (1 + r^2/a^2): never above a^2, deaf to trees and outliers
};

/// A robust loss rho of a residual r in metres with rho(r) = r^2 for |r| much smaller than the
/// scale a. T: double or an automatic differentiation scalar.
class RobustLoss {
 public:
  /// scale: a, metres, > 0.
  RobustLoss(LossKind kind, double scale) : kind_(kind), inverse_square_(1.0 / (scale * scale)) {}

  template <typename T>
  T cost(const T& r) const {
    using std::sqrt;
    const T square = r * r;
    const T ratio = square * T(inverse_square_);
    if (kind_ == LossKind::kSoftL1) {
      return square * T(2.0) / (T(1.0) + sqrt(T(1.0) + ratio));
    }
    return square / (T(1.0) + ratio);
  }

  /// The loss folded into the residual: signed, smooth at 0, robust(r)^2 = rho(r). Its square is
  /// the cost, so its derivative gives the exact gradient.
  template <typename T>
  T robust(const T& r) const {
    using std::sqrt;
    const T ratio = r * r * T(inverse_square_);
    if (kind_ == LossKind::kSoftL1) {
      return r * sqrt(T(2.0) / (T(1.0) + sqrt(T(1.0) + ratio)));
    }
    return r / sqrt(T(1.0) + ratio);
  }

  /// d rho / d (r^2): what a squared residual weighs at r, 1 near 0.
  double slope(double r) const {
    const double ratio = r * r * inverse_square_;
    if (kind_ == LossKind::kSoftL1) return 1.0 / std::sqrt(1.0 + ratio);
    return 1.0 / ((1.0 + ratio) * (1.0 + ratio));
  }

  /// robust(r) and its derivative.
  void evaluate(double r, double* value, double* derivative) const {
    const double root = std::sqrt(1.0 + r * r * inverse_square_);
    if (kind_ == LossKind::kSoftL1) {
      const double factor = std::sqrt(2.0 / (1.0 + root));
      *value = r * factor;
      *derivative = 1.0 / (root * factor);
    } else {
      *value = r / root;
      *derivative = 1.0 / (root * root * root);
    }
  }

 private:
  LossKind kind_;
  double inverse_square_;
};

}  // namespace gable
