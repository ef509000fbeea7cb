#include <ceres/crs_matrix.h>
#include <ceres/solver.h>
#include <gable/engine/solver/minimizer.h>

#include <Eigen/Dense>
#include <cmath>
#include <limits>

namespace gable {

std::string check(const MinimizerOptions& options) {
  if (options.max_iterations < 1 || options.max_iterations > 1000) {
    return "max_iterations must lie in [1, 1000]";
  }
  if (!(options.function_tolerance >= 0.0 && options.function_tolerance < 1.0)) {
    return "function_tolerance must lie in [0, 1)";
  }
  return "";
}

const char* termination_name(Termination termination) {
  switch (termination) {
    case Termination::kConverged:
      return "converged";
    case Termination::kIterationLimit:
      return "iteration limit";
    default:
      return "failed";
  }
}

MinimizerSummary minimize(const MinimizerOptions& options, ceres::Problem* problem) {
  ceres::Solver::Options ceres_options;
  ceres_options.linear_solver_type =
      options.sparse ? ceres::SPARSE_NORMAL_CHOLESKY : ceres::DENSE_NORMAL_CHOLESKY;
  ceres_options.max_num_iterations = options.max_iterations;
  ceres_options.function_tolerance = options.function_tolerance;
  ceres_options.num_threads = 1;
  ceres_options.logging_type = ceres::SILENT;
  ceres::Solver::Summary ceres_summary;
  ceres::Solve(ceres_options, problem, &ceres_summary);

  MinimizerSummary summary;
  summary.initial_cost = ceres_summary.initial_cost;
  summary.final_cost = ceres_summary.final_cost;
  summary.iterations = ceres_summary.num_successful_steps + ceres_summary.num_unsuccessful_steps;
  summary.time_ms = 1e3 * ceres_summary.total_time_in_seconds;
  summary.message = ceres_summary.message;
  if (ceres_summary.termination_type == ceres::CONVERGENCE) {
    summary.termination = Termination::kConverged;
  } else if (ceres_summary.termination_type == ceres::NO_CONVERGENCE) {
    summary.termination = Termination::kIterationLimit;
  }
  return summary;
}

std::vector<double> parameter_deviations(const std::vector<double*>& blocks, double variance,
                                         ceres::Problem* problem) {
  ceres::Problem::EvaluateOptions options;
  options.parameter_blocks = blocks;
  options.apply_loss_function = true;
  options.num_threads = 1;
  ceres::CRSMatrix crs;
  problem->Evaluate(options, nullptr, nullptr, nullptr, &crs);
  const int n = crs.num_cols;
  Eigen::MatrixXd jtj = Eigen::MatrixXd::Zero(n, n);
  for (int row = 0; row < crs.num_rows; ++row) {
    for (int i = crs.rows[row]; i < crs.rows[row + 1]; ++i) {
      for (int j = crs.rows[row]; j < crs.rows[row + 1]; ++j) {
        jtj(crs.cols[i], crs.cols[j]) += crs.values[i] * crs.values[j];
      }
    }
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(jtj);
  const Eigen::VectorXd& lambda = eigen.eigenvalues();
  const double smallest = n > 0 ? 1e-12 * std::max(lambda[n - 1], 1e-300) : 0.0;
  std::vector<double> deviations(n, 0.0);
  for (int p = 0; p < n; ++p) {
    double sum = 0.0, unseen = 0.0;
    for (int k = 0; k < n; ++k) {
      const double share = eigen.eigenvectors()(p, k) * eigen.eigenvectors()(p, k);
      if (lambda[k] > smallest) {
        sum += share / lambda[k];
      } else {
        unseen += share;
      }
    }
    deviations[p] =
        unseen > 1e-6 ? std::numeric_limits<double>::infinity() : std::sqrt(variance * sum);
  }
  return deviations;
}

}  // namespace gable
