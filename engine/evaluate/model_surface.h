#pragma once

#include <gable/engine/io/models/building.h>
#include <gable/grammar/raster.h>

#include <vector>

namespace gable {

/// Buildings seen from above at the cell centres of a grid.
struct ModelSurface {
  HeightRaster height;  ///< world heights of the highest building, NaN where there is none
  Raster<int> owner;    ///< its index, -1 where there is none
};

/// Rasterises the upper envelope of all buildings: houses by their height field, extrusions by
/// their outline.
ModelSurface rasterise_buildings(const std::vector<Building>& buildings, const Grid& grid);

}  // namespace gable
