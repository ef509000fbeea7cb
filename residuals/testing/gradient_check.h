#pragma once

#include <ceres/cost_function.h>

#include <functional>
#include <string>
#include <vector>

namespace gable {

/// How derivatives are compared with numeric differences.
struct GradientCheckOptions {
  /// First step of the differences, times max(1, |value|); the interval of a parameter never
  /// exceeds it to either side. Keep it shorter than the distance to the nearest kink.
  double step = 1e-3;
  /// Entries below `floor` times the largest derivative are compared with that instead of with
  /// themselves: differences of a large number cannot resolve them.
  double floor = 1e-3;
};

/// The worst disagreement found.
struct GradientCheckResult {
  bool evaluated = false;       ///< false: Evaluate() failed or gave numbers that are not finite
  double relative_error = 0.0;  ///< |analytic - numeric| / max(|both|, floor * largest derivative)
  int residual = -1;            ///< where it is
  int block = -1;
  int parameter = -1;
  double analytic = 0.0;
  double numeric = 0.0;

  std::string report() const;
};

/// Derivative at 0 of a function of one variable by Ridders' method: central differences at steps
/// that shrink by 1.4, extrapolated to step zero; the entry of the tableau whose estimated error is
/// smallest wins, so neither truncation nor rounding has to be balanced by hand. Vector-valued:
/// every component is extrapolated on its own. The function is called within [-step, step] only.
std::vector<double> ridders_derivative(const std::function<std::vector<double>(double)>& function,
                                       double step);

/// Compares all Jacobians of a cost function at `parameters` (one vector per block) with Ridders
/// differences of its residuals. Residuals must be smooth within the step around every parameter.
/// For users who write a residual: EXPECT_LT(check_gradient(cost, at).relative_error, 1e-6).
GradientCheckResult check_gradient(const ceres::CostFunction& cost,
                                   const std::vector<std::vector<double>>& parameters,
                                   const GradientCheckOptions& options = {});

/// Compares one derivative with one difference in the manner of `check_gradient`; `largest` is the
/// largest derivative beside it.
double relative_error(double analytic, double numeric, double largest, double floor);

}  // namespace gable
