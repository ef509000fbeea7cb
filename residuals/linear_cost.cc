#include <gable/residuals/linear_cost.h>
#include <glog/logging.h>

#include <algorithm>

namespace gable {

LinearCost::LinearCost(const std::vector<int>& block_sizes, std::vector<LinearRow> rows)
    : rows_(std::move(rows)) {
  for (const LinearRow& row : rows_) {
    for (const LinearRow::Term& term : row.terms) {
      CHECK(term.block >= 0 && term.block < static_cast<int>(block_sizes.size()));
      CHECK(term.index >= 0 && term.index < block_sizes[term.block]);
    }
  }
  mutable_parameter_block_sizes()->assign(block_sizes.begin(), block_sizes.end());
  set_num_residuals(static_cast<int>(rows_.size()));
}

bool LinearCost::Evaluate(double const* const* parameters, double* residuals,
                          double** jacobians) const {
  const auto& sizes = parameter_block_sizes();
  if (jacobians != nullptr) {
    for (size_t b = 0; b < sizes.size(); ++b) {
      if (jacobians[b] != nullptr) std::fill_n(jacobians[b], rows_.size() * sizes[b], 0.0);
    }
  }
  for (size_t r = 0; r < rows_.size(); ++r) {
    residuals[r] = -rows_[r].constant;
    for (const LinearRow::Term& term : rows_[r].terms) {
      residuals[r] += term.coefficient * parameters[term.block][term.index];
      if (jacobians != nullptr && jacobians[term.block] != nullptr) {
        jacobians[term.block][r * sizes[term.block] + term.index] += term.coefficient;
      }
    }
  }
  return true;
}

}  // namespace gable
