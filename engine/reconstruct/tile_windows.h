#pragma once

#include <gable/engine/reconstruct/find_houses.h>
#include <gable/grammar/raster.h>

#include <Eigen/Core>
#include <vector>

namespace gable {

/// The cores of the windows that a raster is worked on in: at most `cells` x `cells` each, row by
/// row, of nearly equal size, without gap or overlap.
std::vector<CellBox> window_cores(const Grid& grid, int cells);

/// The part of `grid` that a box covers.
Grid sub_grid(const Grid& grid, const CellBox& box);

/// The smallest box around both; an empty one does not count.
CellBox union_of(const CellBox& a, const CellBox& b);

/// The cells of `grid` that the extent [low, high] touches (world), at least the one nearest to it.
CellBox cells_around(const Eigen::Vector2d& low, const Eigen::Vector2d& high, const Grid& grid);

/// Whether the cell under a box's centre lies in `core`. Of adjacent cores one holds it.
bool holds_center(const CellBox& core, const CellBox& box);

}  // namespace gable
