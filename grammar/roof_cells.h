#pragma once

#include <gable/grammar/polygon_cells.h>
#include <gable/grammar/raster.h>
#include <gable/grammar/solid/roof_partition.h>

#include <Eigen/Core>

namespace gable {

/// Calls visit(row, col, height) for every cell of a world grid whose centre lies under a roof:
/// height in the roof's own frame. `origin`: the world point that its coordinates are relative to.
template <typename Visit>
void for_cells_of_roof(const RoofPartition& roof, const Eigen::Vector2d& origin, const Grid& grid,
                       Visit visit) {
  for (const RoofRegion& region : roof.regions) {
    const Plane& plane = roof.planes[region.plane];
    for_cells_in_polygon(region.polygon, origin, grid, [&](int row, int col) {
      visit(row, col, plane.at(grid.center_of(row, col) - origin));
    });
  }
}

}  // namespace gable
