#pragma once

#include <Eigen/Core>
#include <vector>

namespace gable {

/// A north-up grid of square cells in a world frame of metres. Row 0 is the northernmost.
struct Grid {
  Eigen::Vector2d north_west = Eigen::Vector2d::Zero();  ///< outer corner of cell (0, 0), world
  double gsd = 1.0;                                      ///< cell size, metres
  int rows = 0;
  int cols = 0;

  Eigen::Vector2d center_of(int row, int col) const {
    return {north_west.x() + (col + 0.5) * gsd, north_west.y() - (row + 0.5) * gsd};
  }
  /// Fractional (row, col): integer values at cell centres.
  Eigen::Vector2d cell_of(const Eigen::Vector2d& world) const {
    return {(north_west.y() - world.y()) / gsd - 0.5, (world.x() - north_west.x()) / gsd - 0.5};
  }
  bool contains(int row, int col) const { return row >= 0 && row < rows && col >= 0 && col < cols; }
  size_t size() const { return static_cast<size_t>(rows) * static_cast<size_t>(cols); }
  bool operator==(const Grid&) const = default;
};

/// Values on a grid, row by row.
template <typename T>
struct Raster {
  Grid grid;
  std::vector<T> values;

  Raster() = default;
  Raster(const Grid& g, T fill) : grid(g), values(g.size(), fill) {}

  T& at(int row, int col) { return values[static_cast<size_t>(row) * grid.cols + col]; }
  const T& at(int row, int col) const { return values[static_cast<size_t>(row) * grid.cols + col]; }
};

/// Heights in metres; NaN where there is no measurement.
using HeightRaster = Raster<float>;

}  // namespace gable
