#include <gable/engine/evaluate/model_surface.h>
#include <gable/grammar/rasterise.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gable {
namespace {

/// Calls visit(row, col, height) for the cells whose centres lie in the outline. Even-odd rule over
/// all rings, row by row; heights above building.origin.
template <typename Visit>
void for_cells_in_outline(const Building& building, const Grid& grid, Visit visit) {
  std::vector<const std::vector<Eigen::Vector2d>*> rings = {&building.outline.outer};
  for (const auto& hole : building.outline.holes) rings.push_back(&hole);
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Eigen::Vector2d& p : building.outline.outer) {
    low = std::min(low, p.y());
    high = std::max(high, p.y());
  }
  const Eigen::Vector2d origin = building.origin.head<2>();
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
      for (int col = static_cast<int>(from); col < static_cast<int>(to); ++col) {
        visit(row, col, building.height);
      }
    }
  }
}

}  // namespace

ModelSurface rasterise_buildings(const std::vector<Building>& buildings, const Grid& grid) {
  ModelSurface surface;
  surface.height = HeightRaster(grid, std::numeric_limits<float>::quiet_NaN());
  surface.owner = Raster<int>(grid, -1);
  for (size_t i = 0; i < buildings.size(); ++i) {
    const Building& building = buildings[i];
    const double origin_z = building.house ? building.house->origin.z() : building.origin.z();
    const auto raise = [&](int row, int col, double above_origin) {
      const float height = static_cast<float>(origin_z + above_origin);
      float& seen = surface.height.at(row, col);
      if (height <= seen) return;  // false where nothing is seen yet (NaN)
      seen = height;
      surface.owner.at(row, col) = static_cast<int>(i);
    };
    if (building.house) {
      for_covered_cells(*building.house, grid, raise);
    } else {
      for_cells_in_outline(building, grid, raise);
    }
  }
  return surface;
}

}  // namespace gable
