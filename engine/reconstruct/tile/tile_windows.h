#pragma once

#include <gable/engine/io/raster/height_source.h>
#include <gable/engine/reconstruct/finding/find_houses.h>
#include <gable/grammar/raster.h>

#include <Eigen/Core>
#include <vector>

namespace gable {

/// The cores of the windows that a raster is worked on in: at most `cells` x `cells` each, row by
/// row, of nearly equal size, without gap or overlap.
std::vector<CellBox> window_cores(const Grid& grid, int cells);

/// One of the windows that a raster is worked on in.
struct TileWindow {
  int index = 0;         ///< among the windows that are worked on, row by row
  int row = 0, col = 0;  ///< in the pattern of windows, from the north-west
  CellBox core;          ///< buildings with their centre here are its own
};

/// The windows with cores of at most `cells` x `cells`, row by row; all of them or, where not
/// `everywhere`, those that may hold heights.
std::vector<TileWindow> tile_windows(const HeightSource& dsm, int cells, bool everywhere);

/// The cells of `grid` that lie in `part`, a grid of the same cells; may be empty.
CellBox cells_of_part(const Grid& part, const Grid& grid);

/// The cells that both boxes hold; may be empty.
CellBox intersection_of(const CellBox& a, const CellBox& b);

/// The part of `grid` that a box covers.
Grid sub_grid(const Grid& grid, const CellBox& box);

/// The smallest box around both; an empty one does not count.
CellBox union_of(const CellBox& a, const CellBox& b);

/// The cells of `grid` that the extent [low, high] touches (world), at least the one nearest to it.
CellBox cells_around(const Eigen::Vector2d& low, const Eigen::Vector2d& high, const Grid& grid);

/// Whether the cell under a box's centre lies in `core`. Of adjacent cores one holds it.
bool holds_center(const CellBox& core, const CellBox& box);

}  // namespace gable
