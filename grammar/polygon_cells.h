#pragma once

#include <gable/grammar/raster.h>
#include <gable/grammar/solid/extrusion.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace gable {

/// Calls visit(row, col) for every cell of a world grid whose centre lies in a polygon, row by row.
/// Even-odd over all rings, so holes are left out; `origin` is the world point that the polygon's
/// coordinates are relative to. Of two polygons with a common edge one gets each centre on it.
template <typename Visit>
void for_cells_in_polygon(const PlanPolygon& polygon, const Eigen::Vector2d& origin,
                          const Grid& grid, Visit visit) {
  std::vector<const std::vector<Eigen::Vector2d>*> rings = {&polygon.outer};
  for (const auto& hole : polygon.holes) rings.push_back(&hole);
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Eigen::Vector2d& p : polygon.outer) {
    low = std::min(low, p.y());
    high = std::max(high, p.y());
  }
  // Clamped as numbers first: a polygon may lie far outside the grid.
  const double first = grid.cell_of({origin.x(), origin.y() + high}).x();
  const double last = grid.cell_of({origin.x(), origin.y() + low}).x();
  const int row_begin = static_cast<int>(std::clamp(std::ceil(first), 0.0, 1.0 * grid.rows));
  const int row_end = static_cast<int>(std::clamp(std::floor(last) + 1.0, 0.0, 1.0 * grid.rows));
  std::vector<double> crossings;  // columns where the row of centres crosses an edge
  for (int row = row_begin; row < row_end; ++row) {
    const double y = grid.center_of(row, 0).y() - origin.y();
    crossings.clear();
    for (const auto* ring : rings) {
      for (size_t k = 0; k < ring->size(); ++k) {
        const Eigen::Vector2d& a = (*ring)[k];
        const Eigen::Vector2d& b = (*ring)[(k + 1) % ring->size()];
        if ((a.y() > y) == (b.y() > y)) continue;
        const double x = a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
        crossings.push_back(grid.cell_of({origin.x() + x, 0.0}).y());
      }
    }
    std::sort(crossings.begin(), crossings.end());
    for (size_t k = 0; k + 1 < crossings.size(); k += 2) {
      const double from = std::clamp(std::ceil(crossings[k]), 0.0, 1.0 * grid.cols);
      const double to = std::clamp(std::ceil(crossings[k + 1]), 0.0, 1.0 * grid.cols);
      for (int col = static_cast<int>(from); col < static_cast<int>(to); ++col) visit(row, col);
    }
  }
}

}  // namespace gable
