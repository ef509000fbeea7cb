#include <gable/residuals/testing/gradient_check.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>

namespace gable {
namespace {

// Rows of the tableau: the last step is the first over 1.4^9, about 1 / 20.
constexpr int kRows = 10;
constexpr double kShrink = 1.4;

// Extrapolates differences taken at kRows shrinking steps to step zero.
double extrapolate(const std::array<double, kRows>& differences) {
  std::array<std::array<double, kRows>, kRows> table;
  double best = differences[0], best_error = std::numeric_limits<double>::max();
  for (int row = 0; row < kRows; ++row) {
    table[row][0] = differences[row];
    double factor = kShrink * kShrink;
    for (int k = 1; k <= row; ++k) {
      table[row][k] = (table[row][k - 1] * factor - table[row - 1][k - 1]) / (factor - 1.0);
      factor *= kShrink * kShrink;
      const double error = std::max(std::abs(table[row][k] - table[row][k - 1]),
                                    std::abs(table[row][k] - table[row - 1][k - 1]));
      if (error < best_error) best_error = error, best = table[row][k];
    }
  }
  return best;
}

bool all_finite(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

}  // namespace

std::string GradientCheckResult::report() const {
  std::ostringstream out;
  if (!evaluated) return "the cost function could not be evaluated to finite numbers";
  out << "relative error " << relative_error << " at residual " << residual << ", block " << block
      << ", parameter " << parameter << ": analytic " << analytic << ", numeric " << numeric;
  return out.str();
}

std::vector<double> ridders_derivative(const std::function<std::vector<double>(double)>& function,
                                       double step) {
  std::vector<std::array<double, kRows>> differences;
  for (int row = 0; row < kRows; ++row, step /= kShrink) {
    const std::vector<double> ahead = function(step), behind = function(-step);
    differences.resize(ahead.size());
    for (size_t i = 0; i < ahead.size(); ++i) {
      differences[i][row] = (ahead[i] - behind[i]) / (2.0 * step);
    }
  }
  std::vector<double> derivatives;
  for (const auto& d : differences) derivatives.push_back(extrapolate(d));
  return derivatives;
}

double relative_error(double analytic, double numeric, double largest, double floor) {
  const double scale = std::max({std::abs(analytic), std::abs(numeric), floor * largest});
  return scale > 0.0 ? std::abs(analytic - numeric) / scale : 0.0;
}

GradientCheckResult check_gradient(const ceres::CostFunction& cost,
                                   const std::vector<std::vector<double>>& parameters,
                                   const GradientCheckOptions& options) {
  GradientCheckResult result;
  const int num_residuals = cost.num_residuals();
  std::vector<std::vector<double>> values = parameters, storage;
  std::vector<const double*> pointers;
  std::vector<double*> jacobians;
  for (const auto& block : values) {
    pointers.push_back(block.data());
    storage.emplace_back(num_residuals * block.size());
  }
  for (auto& s : storage) jacobians.push_back(s.data());
  std::vector<double> residuals(num_residuals);
  if (!cost.Evaluate(pointers.data(), residuals.data(), jacobians.data())) return result;
  double largest = 0.0;
  for (const auto& s : storage) {
    if (!all_finite(s)) return result;
    for (double v : s) largest = std::max(largest, std::abs(v));
  }
  result.evaluated = all_finite(residuals);
  for (size_t block = 0; block < values.size(); ++block) {
    const size_t size = values[block].size();
    for (size_t k = 0; k < size; ++k) {
      const double center = values[block][k];
      const auto moved = [&](double delta) {
        values[block][k] = center + delta;
        std::vector<double> out(num_residuals);
        if (!cost.Evaluate(pointers.data(), out.data(), nullptr)) result.evaluated = false;
        return out;
      };
      const std::vector<double> numeric =
          ridders_derivative(moved, options.step * std::max(1.0, std::abs(center)));
      values[block][k] = center;
      for (int r = 0; r < num_residuals; ++r) {
        const double analytic = storage[block][r * size + k];
        const double error = relative_error(analytic, numeric[r], largest, options.floor);
        if (!(error <= result.relative_error)) {
          result.relative_error = error;
          result.residual = r;
          result.block = static_cast<int>(block);
          result.parameter = static_cast<int>(k);
          result.analytic = analytic;
          result.numeric = numeric[r];
        }
      }
    }
  }
  return result;
}

}  // namespace gable
