#pragma once

#include <gable/engine/reconstruct/tile/tile_crops.h>
#include <gable/grammar/polygon_cells.h>
#include <gable/grammar/synthesis/terrace.h>

#include <vector>

namespace gable {

/// The height images of a terrace's houses where their footprints are known.
inline std::vector<HeightImage> terrace_images(const Terrace& terrace) {
  Raster<unsigned char> outlined(terrace.dsm.grid, 0);
  for (const PlanPolygon& footprint : terrace.footprints) {
    for_cells_in_polygon(footprint, Eigen::Vector2d::Zero(), outlined.grid,
                         [&](int row, int col) { outlined.at(row, col) = 1; });
  }
  std::vector<HeightImage> images;
  for (const PlanPolygon& footprint : terrace.footprints) {
    images.push_back(crop_footprint(terrace.dsm, terrace.dtm, outlined, footprint, {}));
  }
  return images;
}

}  // namespace gable
