#include <gable/engine/reconstruct/heights/trend.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <vector>

namespace gable {
namespace {

constexpr double kBlock = 10.0;
/// Residual from which on a block counts less, metres.
constexpr double kScale = 0.5;
constexpr int kIterations = 30;
/// Pull of each coefficient but the constant towards zero, in blocks: decides where there are too
/// few blocks to tell.
constexpr double kPrior = 1e-3;

}  // namespace

Trend::Vector6 Trend::basis(int row, int col) const {
  const double x = (col - middle_col_) * scale_, y = (row - middle_row_) * scale_;
  Vector6 b;
  b << 1.0, x, y, x * x, x * y, y * y;
  return b;
}

Trend::Trend(const HeightRaster& heights)
    : middle_row_(0.5 * (heights.grid.rows - 1)),
      middle_col_(0.5 * (heights.grid.cols - 1)),
      scale_(2.0 / std::max({heights.grid.rows, heights.grid.cols, 2})) {
  const Grid& grid = heights.grid;
  const int step = std::max(1, static_cast<int>(std::lround(kBlock / grid.gsd)));
  std::vector<Vector6> rows;
  std::vector<double> lowest;
  for (int r0 = 0; r0 < grid.rows; r0 += step) {
    for (int c0 = 0; c0 < grid.cols; c0 += step) {
      int row = -1, col = -1;
      for (int r = r0; r < std::min(r0 + step, grid.rows); ++r) {
        for (int c = c0; c < std::min(c0 + step, grid.cols); ++c) {
          if (std::isnan(heights.at(r, c))) continue;
          if (row < 0 || heights.at(r, c) < heights.at(row, col)) row = r, col = c;
        }
      }
      if (row < 0) continue;
      rows.push_back(basis(row, col));
      lowest.push_back(heights.at(row, col));
    }
  }
  if (rows.empty()) return;
  // Start from the median height: the plain mean of a town is above its ground.
  std::vector<double> sorted = lowest;
  std::nth_element(sorted.begin(), sorted.begin() + sorted.size() / 2, sorted.end());
  coefficients_[0] = sorted[sorted.size() / 2];
  double scale = 10.0;  // annealed, so that a slope is found before anything is left out
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    Eigen::Matrix<double, 6, 6> normal = Eigen::Matrix<double, 6, 6>::Zero();
    normal.diagonal().tail<5>().setConstant(kPrior);
    normal(0, 0) = 1e-9;
    Vector6 right = Vector6::Zero();
    for (size_t i = 0; i < rows.size(); ++i) {
      const double residual = (lowest[i] - rows[i].dot(coefficients_)) / scale;
      const double weight = 1.0 / (1.0 + residual * residual);
      normal += weight * rows[i] * rows[i].transpose();
      right += weight * lowest[i] * rows[i];
    }
    coefficients_ = normal.ldlt().solve(right);
    scale = std::max(kScale, 0.8 * scale);
  }
}

}  // namespace gable
