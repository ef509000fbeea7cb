#pragma once

#include <gable/grammar/raster.h>

#include <Eigen/Core>

namespace gable {

/// A quadratic surface over a grid: the overall shape of a terrain.
class Trend {
 public:
  /// Fits the lowest cells of 10 m blocks; blocks without ground (roofs) and pits count little.
  explicit Trend(const HeightRaster& heights);

  /// Height at a cell centre, metres.
  double at(int row, int col) const { return basis(row, col).dot(coefficients_); }

 private:
  using Vector6 = Eigen::Matrix<double, 6, 1>;
  Vector6 basis(int row, int col) const;

  double middle_row_, middle_col_, scale_;  ///< positions are scaled into [-1, 1]
  Vector6 coefficients_ = Vector6::Zero();
};

}  // namespace gable
