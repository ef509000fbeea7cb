#pragma once

#include <ceres/problem.h>

#include <string>
#include <vector>

namespace gable {

/// Bounds on how long and how finely the solver core works. Every refinement (houses, planes,
/// neighbours) goes through `minimize` with these.
struct MinimizerOptions {
  int max_iterations = 30;           ///< [1, 1000]
  double function_tolerance = 1e-5;  ///< relative change of the cost to stop at, [0, 1)
  /// Eliminates sparsely with SuiteSparse instead of densely: for many blocks that few residuals
  /// connect (neighbours refined together, planes of a whole scan).
  bool sparse = false;
};

/// Empty if the options are in range; otherwise names the violated bound.
std::string check(const MinimizerOptions& options);

/// Why the solver stopped.
enum class Termination { kConverged, kIterationLimit, kFailed };

/// "converged", "iteration limit" or "failed".
const char* termination_name(Termination termination);

/// What a run of the solver core did. Costs are half the sum of squared (robust) residuals.
struct MinimizerSummary {
  double initial_cost = -1.0;
  double final_cost = -1.0;
  int iterations = 0;  ///< steps tried, accepted or not
  double time_ms = 0.0;
  Termination termination = Termination::kFailed;
  std::string message;  ///< Ceres' own words
};

/// Minimises a problem by Levenberg-Marquardt within the bounds set on its parameter blocks.
MinimizerSummary minimize(const MinimizerOptions& options, ceres::Problem* problem);

/// Standard deviations of the parameters of `blocks` (in this order, concatenated) at the current
/// values: the diagonal of variance * pinv(J'J), where `variance` is that of one residual. A
/// parameter that no residual sees has an infinite deviation.
std::vector<double> parameter_deviations(const std::vector<double*>& blocks, double variance,
                                         ceres::Problem* problem);

}  // namespace gable
