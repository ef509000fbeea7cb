#pragma once

#include <gable/engine/io/crs.h>
#include <gable/grammar/raster.h>

#include <string>

namespace gable {

/// Writes a GeoTIFF: float32, tiled, deflated, nodata -9999 where the raster has NaN. Atomic.
/// Throws Error (kCannotWrite).
void write_raster(const std::string& path, const HeightRaster& heights, const Crs& crs);

}  // namespace gable
