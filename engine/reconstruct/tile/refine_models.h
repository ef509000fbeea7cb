#pragma once

#include <gable/engine/io/models/building.h>
#include <gable/engine/io/raster/raster_file.h>
#include <gable/engine/reconstruct/finding/height_crop.h>
#include <gable/engine/reconstruct/finding/vegetation.h>
#include <gable/engine/reconstruct/tile/reconstruct_tile.h>
#include <gable/engine/solver/house_refinement.h>

#include <stop_token>
#include <string>
#include <vector>

namespace gable {

struct RefineModelsOptions {
  RefinementOptions refinement;
  HeightCropOptions crop;
  VegetationOptions vegetation;
  int threads = 1;  ///< [1, 1024]
};

/// Empty if the options are in range; otherwise names the violated bound.
std::string check(const RefineModelsOptions& options);

/// Refines the houses among given buildings against heights, each on its own crop in which the
/// other buildings and tree crowns are left out; see `refine_building`. Extrusions pass through.
/// Order and results depend on neither the number of threads nor their timing. Returns false where
/// it was stopped. Throws Error where a file is damaged.
bool refine_models(const RasterFile& dsm, const RasterFile& dtm,
                   const std::vector<Building>& buildings, const RefineModelsOptions& options,
                   const std::stop_token& stop, const TileCallbacks& callbacks);

}  // namespace gable
