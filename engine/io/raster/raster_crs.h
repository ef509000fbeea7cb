#pragma once

#include <gable/engine/io/crs.h>
#include <gable/grammar/raster.h>

#include <string>

class GDALDataset;

namespace gable {

/// A raster's reference system after the checks, and what turns its heights into metres.
struct RasterCrs {
  Crs crs;
  double metres_per_height_unit = 1.0;
};

/// Reads and checks a dataset's CRS: projected, in metres. `fallback` (e.g. "EPSG:27700", may be
/// empty) stands in where it has none. Where heights are declared in feet, the factor says so and
/// `crs` is the horizontal part alone, because the vertical part no longer holds. Throws Error
/// (kBadInput) with the remedy.
RasterCrs raster_crs(GDALDataset& dataset, const std::string& path, const std::string& fallback);

/// Reads and checks a dataset's grid: north-up, square cells, at least 2 x 2. Throws Error.
Grid raster_grid(GDALDataset& dataset, const std::string& path);

}  // namespace gable
