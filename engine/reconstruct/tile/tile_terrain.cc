#include <gable/engine/reconstruct/finding/height_crop.h>
#include <gable/engine/reconstruct/heights/fill.h>
#include <gable/engine/reconstruct/tile/tile_terrain.h>
#include <gable/engine/reconstruct/tile/tile_windows.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace gable {
namespace {

bool has_gaps(const HeightRaster& heights) {
  return std::any_of(heights.values.begin(), heights.values.end(),
                     [](float z) { return std::isnan(z); });
}

/// The part of `heights` that `box` covers; both boxes are of one grid.
HeightRaster part_of(const HeightRaster& heights, const CellBox& whole, const CellBox& box) {
  if (whole.row0 == box.row0 && whole.col0 == box.col0 && whole.row1 == box.row1 &&
      whole.col1 == box.col1) {
    return heights;
  }
  const CellBox inner{box.row0 - whole.row0, box.col0 - whole.col0, box.row1 - whole.row0,
                      box.col1 - whole.col0};
  HeightRaster part(sub_grid(heights.grid, inner), 0.0f);
  for (int row = 0; row < part.grid.rows; ++row) {
    for (int col = 0; col < part.grid.cols; ++col) {
      part.at(row, col) = heights.at(inner.row0 + row, inner.col0 + col);
    }
  }
  return part;
}

}  // namespace

TileTerrain::TileTerrain(const HeightSource& dsm, const HeightSource* dtm,
                         const TileTerrainOptions& options)
    : dsm_(dsm),
      dtm_(dtm),
      options_(options),
      cores_(window_cores(dsm.grid(), options.block_cells)),
      made_(cores_.size(), 0) {}

HeightRaster TileTerrain::surface(const CellBox& box) const {
  return dsm_.read(box.row0, box.col0, box.row1 - box.row0, box.col1 - box.col0);
}

HeightRaster TileTerrain::read(const CellBox& box) {
  if (dtm_) {
    HeightRaster given = dtm_->read_onto(sub_grid(dsm_.grid(), box));
    if (!has_gaps(given)) return given;
  }
  const Grid& grid = dsm_.grid();
  if (cores_.size() == 1) return part_of(block(cores_.front()), cores_.front(), box);
  if (!kept_) kept_.emplace(grid, dsm_.crs(), dsm_.path(), options_.scratch);
  for (size_t i = 0; i < cores_.size(); ++i) {
    if (made_[i] || intersection_of(cores_[i], box).empty()) continue;
    kept_->write(block(cores_[i]), cores_[i].row0, cores_[i].col0);
    made_[i] = 1;
  }
  return kept_->read(box.row0, box.col0, box.row1 - box.row0, box.col1 - box.col0);
}

HeightRaster TileTerrain::block(const CellBox& core) const {
  const CellBox box = with_margin(core, options_.margin, dsm_.grid());
  if (!dtm_) return part_of(derive_terrain(surface(box), options_.terrain), box, core);
  HeightRaster terrain = dtm_->read_onto(sub_grid(dsm_.grid(), box));
  Raster<unsigned char> reached(terrain.grid, 0);
  for (const Grid& tile : dtm_->tiles()) {
    const Eigen::Vector2d south_east =
        tile.north_west + tile.gsd * Eigen::Vector2d(tile.cols, -tile.rows);
    const Eigen::Vector2d first = terrain.grid.cell_of(tile.north_west);
    const Eigen::Vector2d last = terrain.grid.cell_of(south_east);
    const auto cell = [](double position, int cells) {
      return static_cast<int>(std::clamp(std::ceil(position), 0.0, static_cast<double>(cells)));
    };
    const int row1 = cell(last.x(), terrain.grid.rows), col1 = cell(last.y(), terrain.grid.cols);
    for (int row = cell(first.x(), terrain.grid.rows); row < row1; ++row) {
      for (int col = cell(first.y(), terrain.grid.cols); col < col1; ++col) {
        reached.at(row, col) = 1;
      }
    }
  }
  if (std::find(reached.values.begin(), reached.values.end(), 0) != reached.values.end()) {
    const HeightRaster derived = derive_terrain(surface(box), options_.terrain);
    for (size_t i = 0; i < derived.values.size(); ++i) {
      if (!reached.values[i] && std::isnan(terrain.values[i])) {
        terrain.values[i] = derived.values[i];
      }
    }
  }
  return part_of(fill_smoothly(terrain), box, core);
}

}  // namespace gable
