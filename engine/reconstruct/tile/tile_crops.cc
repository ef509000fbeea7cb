#include <gable/engine/reconstruct/tile/tile_crops.h>
#include <gable/engine/reconstruct/tile/tile_windows.h>
#include <gable/grammar/polygon_cells.h>

#include <Eigen/Geometry>
#include <vector>

namespace gable {
namespace {

size_t size_of(const CellBox& box) {
  return static_cast<size_t>(box.row1 - box.row0) * static_cast<size_t>(box.col1 - box.col0);
}

}  // namespace

HeightImage crop_found_house(const HeightRaster& dsm, const HeightRaster& dtm,
                             const FoundHouses& found, size_t index,
                             const HeightCropOptions& options) {
  const CellBox box = with_margin(found.houses[index].box, options.margin, dsm.grid);
  const int own = static_cast<int>(index) + 1;
  const int row_number = found.houses[index].row;
  const auto of_same_row = [&](int label) {
    return label > 0 && row_number > 0 && found.houses[label - 1].row == row_number;
  };
  std::vector<CellRole> roles;
  roles.reserve(size_of(box));
  for (int row = box.row0; row < box.row1; ++row) {
    for (int col = box.col0; col < box.col1; ++col) {
      const int label = found.label.at(row, col);
      roles.push_back(label == own               ? CellRole::kBuilding
                      : of_same_row(label)       ? CellRole::kRow
                      : found.crown.at(row, col) ? CellRole::kCrown
                      : label != 0               ? CellRole::kNeighbour
                                                 : CellRole::kOpen);
    }
  }
  return crop_heights(dsm, dtm, box, roles, false, options);
}

HeightImage crop_footprint(const HeightRaster& dsm, const HeightRaster& dtm,
                           const Raster<unsigned char>& outlined, const PlanPolygon& polygon,
                           const HeightCropOptions& options) {
  Eigen::AlignedBox2d extent;
  for (const Eigen::Vector2d& p : polygon.outer) extent.extend(p);
  const CellBox box =
      with_margin(cells_around(extent.min(), extent.max(), dsm.grid), options.margin, dsm.grid);
  const Grid grid = sub_grid(dsm.grid, box);
  std::vector<CellRole> roles;
  roles.reserve(size_of(box));
  for (int row = box.row0; row < box.row1; ++row) {
    for (int col = box.col0; col < box.col1; ++col) {
      roles.push_back(outlined.at(row, col) ? CellRole::kNeighbour : CellRole::kOpen);
    }
  }
  for_cells_in_polygon(polygon, Eigen::Vector2d::Zero(), grid, [&](int row, int col) {
    roles[static_cast<size_t>(row) * grid.cols + col] = CellRole::kBuilding;
  });
  return crop_heights(dsm, dtm, box, roles, true, options);
}

}  // namespace gable
