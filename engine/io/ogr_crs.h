#pragma once

#include <gable/engine/io/crs.h>
#include <ogr_spatialref.h>

namespace gable {

/// Between Crs and GDAL's own class; for the .cc files of this room. Axes are always x = easting,
/// y = northing.
Crs crs_from_ogr(const OGRSpatialReference& srs);
OGRSpatialReference ogr_from_crs(const Crs& crs);

}  // namespace gable
