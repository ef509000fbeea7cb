#pragma once

#include <ceres/cost_function.h>

#include <vector>

namespace gable {

/// One residual that is linear in parameters: r = sum of coefficient * block[index] - constant.
struct LinearRow {
  struct Term {
    int block = 0;  ///< which of the cost function's parameter blocks
    int index = 0;  ///< which of the block's values
    double coefficient = 1.0;
  };
  std::vector<Term> terms;
  double constant = 0.0;
};

/// Linear residuals over any parameter blocks, one per row, in order; the Jacobian is constant.
/// Units are those of the coefficients times the parameters. What it can say of a house's
/// parameters (equal heights, symmetry, priors) is written down in house_relations.h.
class LinearCost : public ceres::CostFunction {
 public:
  LinearCost(const std::vector<int>& block_sizes, std::vector<LinearRow> rows);

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override;

 private:
  std::vector<LinearRow> rows_;
};

}  // namespace gable
