#include <ceres/cost_function.h>
#include <gable/engine/solver/minimizer.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

namespace gable {
namespace {

// Residuals a x - b of one block.
class LinearResiduals : public ceres::CostFunction {
 public:
  LinearResiduals(Eigen::MatrixXd a, Eigen::VectorXd b) : a_(std::move(a)), b_(std::move(b)) {
    set_num_residuals(static_cast<int>(a_.rows()));
    mutable_parameter_block_sizes()->push_back(static_cast<int>(a_.cols()));
  }
  bool Evaluate(double const* const* x, double* residuals, double** jacobians) const override {
    Eigen::Map<Eigen::VectorXd>(residuals, a_.rows()) =
        a_ * Eigen::Map<const Eigen::VectorXd>(x[0], a_.cols()) - b_;
    if (jacobians && jacobians[0]) {
      using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
      Eigen::Map<RowMajor>(jacobians[0], a_.rows(), a_.cols()) = a_;
    }
    return true;
  }

 private:
  Eigen::MatrixXd a_;
  Eigen::VectorXd b_;
};

const Eigen::MatrixXd kA = (Eigen::MatrixXd(4, 2) << 1, 0, 1, 1, 1, 2, 1, 3).finished();
const Eigen::VectorXd kB = (Eigen::VectorXd(4) << 1.0, 2.9, 5.2, 6.9).finished();

TEST(Minimizer, SolvesLeastSquaresDenselyAndSparsely) {
  // Closed form: (A'A)^-1 A'b.
  const Eigen::Vector2d expected = (kA.transpose() * kA).inverse() * kA.transpose() * kB;
  for (const bool sparse : {false, true}) {
    double x[2] = {10.0, -10.0};
    ceres::Problem problem;
    problem.AddResidualBlock(new LinearResiduals(kA, kB), nullptr, x);
    MinimizerOptions options;
    options.sparse = sparse;
    options.function_tolerance = 1e-14;
    const MinimizerSummary summary = minimize(options, &problem);
    EXPECT_NEAR(x[0], expected[0], 1e-6);
    EXPECT_NEAR(x[1], expected[1], 1e-6);
    EXPECT_EQ(summary.termination, Termination::kConverged);
    EXPECT_NEAR(summary.initial_cost, 0.5 * (kA * Eigen::Vector2d(10.0, -10.0) - kB).squaredNorm(),
                1e-9);
    EXPECT_NEAR(summary.final_cost, 0.5 * (kA * expected - kB).squaredNorm(), 1e-9);
    EXPECT_GE(summary.iterations, 1);
  }
}

TEST(Minimizer, StaysWithinBoundsAndReportsTheIterationLimit) {
  double x[2] = {0.0, 0.0};
  ceres::Problem problem;
  problem.AddResidualBlock(new LinearResiduals(kA, kB), nullptr, x);
  problem.SetParameterUpperBound(x, 1, 1.5);
  MinimizerOptions options;
  options.function_tolerance = 1e-14;
  const MinimizerSummary summary = minimize(options, &problem);
  EXPECT_EQ(x[1], 1.5);
  // Better than the free solution cut off at the bound.
  const Eigen::Vector2d free = (kA.transpose() * kA).inverse() * kA.transpose() * kB;
  EXPECT_LT(summary.final_cost,
            0.99 * 0.5 * (kA * Eigen::Vector2d(free[0], 1.5) - kB).squaredNorm());

  double y[2] = {100.0, -100.0};
  ceres::Problem short_problem;
  short_problem.AddResidualBlock(new LinearResiduals(kA, kB), nullptr, y);
  options.max_iterations = 1;
  options.function_tolerance = 0.0;
  EXPECT_EQ(minimize(options, &short_problem).termination, Termination::kIterationLimit);
}

TEST(ParameterDeviations, AreTheRootsOfTheCovariancesDiagonal) {
  double x[2] = {1.0, 2.0};
  ceres::Problem problem;
  problem.AddResidualBlock(new LinearResiduals(kA, kB), nullptr, x);
  const Eigen::Matrix2d covariance = 0.09 * (kA.transpose() * kA).inverse();
  const std::vector<double> deviations = parameter_deviations({x}, 0.09, &problem);
  ASSERT_EQ(deviations.size(), 2u);
  EXPECT_NEAR(deviations[0], std::sqrt(covariance(0, 0)), 1e-12);
  EXPECT_NEAR(deviations[1], std::sqrt(covariance(1, 1)), 1e-12);
}

TEST(ParameterDeviations, AreInfiniteWhereNoResidualSeesAParameter) {
  double x[3] = {1.0, 2.0, 3.0};
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(4, 3);
  a.leftCols(2) = kA;
  ceres::Problem problem;
  problem.AddResidualBlock(new LinearResiduals(a, kB), nullptr, x);
  const std::vector<double> deviations = parameter_deviations({x}, 1.0, &problem);
  ASSERT_EQ(deviations.size(), 3u);
  EXPECT_TRUE(std::isfinite(deviations[0]));
  EXPECT_TRUE(std::isfinite(deviations[1]));
  EXPECT_TRUE(std::isinf(deviations[2]));
}

TEST(Minimizer, CheckNamesTheViolatedBound) {
  MinimizerOptions options;
  EXPECT_EQ(check(options), "");
  options.max_iterations = 0;
  EXPECT_EQ(check(options), "max_iterations must lie in [1, 1000]");
  options = {};
  options.function_tolerance = 1.0;
  EXPECT_EQ(check(options), "function_tolerance must lie in [0, 1)");
}

TEST(Minimizer, TerminationsHaveNames) {
  EXPECT_STREQ(termination_name(Termination::kConverged), "converged");
  EXPECT_STREQ(termination_name(Termination::kIterationLimit), "iteration limit");
  EXPECT_STREQ(termination_name(Termination::kFailed), "failed");
}

}  // namespace
}  // namespace gable
