#pragma once

#include <gable/engine/reconstruct/finding/find_houses.h>
#include <gable/engine/reconstruct/finding/height_crop.h>
#include <gable/grammar/raster.h>
#include <gable/grammar/solid/extrusion.h>
#include <gable/residuals/height_image.h>

#include <Eigen/Core>

namespace gable {

/// The height image of house `index` of those found on the grid of the two rasters.
HeightImage crop_found_house(const HeightRaster& dsm, const HeightRaster& dtm,
                             const FoundHouses& found, size_t index,
                             const HeightCropOptions& options);

/// The height image of the building over a known outline (world coordinates). `outlined` holds, on
/// the grid of the two rasters, 1 where any outline covers a cell. Its heights are believed
/// even where they are rough: within a known outline that is clutter on a roof more often than a
/// crown over it.
HeightImage crop_footprint(const HeightRaster& dsm, const HeightRaster& dtm,
                           const Raster<unsigned char>& outlined, const PlanPolygon& polygon,
                           const HeightCropOptions& options);

}  // namespace gable
