#pragma once

#include <gable/grammar/height_field.h>
#include <gable/grammar/raster.h>

#include <algorithm>
#include <cmath>

namespace gable {

/// Calls visit(row, col, height) for every cell of a world grid whose centre a block of the house
/// covers: point samples of the height field (support 0), metres above House::origin, row by row.
template <typename Visit>
void for_covered_cells(const House& house, const Grid& grid, Visit visit) {
  using namespace block_value;
  const HeightField field(house);
  Eigen::Vector2d low(INFINITY, INFINITY), high(-INFINITY, -INFINITY);
  for (const Block<double>& block : field.blocks()) {
    for (double x : {block[kX0], block[kX1]}) {
      for (double y : {block[kY0], block[kY1]}) {
        const Eigen::Vector2d local = field.local_from_house({x, y});
        low = low.cwiseMin(local);
        high = high.cwiseMax(local);
      }
    }
  }
  const Eigen::Vector2d center = house.origin.template head<2>();
  const Eigen::Vector2d first = grid.cell_of(center + Eigen::Vector2d(low.x(), high.y()));
  const Eigen::Vector2d last = grid.cell_of(center + Eigen::Vector2d(high.x(), low.y()));
  // Clamped as numbers first: a house may lie far outside the grid.
  const int row_begin = static_cast<int>(std::clamp(std::floor(first.x()), 0.0, 1.0 * grid.rows));
  const int row_end = static_cast<int>(std::clamp(std::ceil(last.x()) + 1.0, 0.0, 1.0 * grid.rows));
  const int col_begin = static_cast<int>(std::clamp(std::floor(first.y()), 0.0, 1.0 * grid.cols));
  const int col_end = static_cast<int>(std::clamp(std::ceil(last.y()) + 1.0, 0.0, 1.0 * grid.cols));
  for (int row = row_begin; row < row_end; ++row) {
    for (int col = col_begin; col < col_end; ++col) {
      const Eigen::Vector2d point = field.house_from_local(grid.center_of(row, col) - center);
      // The ground is not read where a block covers the point.
      if (field.block_at_house(point) >= 0) visit(row, col, field.at_house(point, 0.0, 0.0));
    }
  }
}

}  // namespace gable
