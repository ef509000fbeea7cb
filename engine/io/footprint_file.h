#pragma once

#include <gable/engine/io/crs.h>
#include <gable/engine/io/footprint_writer.h>
#include <gable/grammar/raster.h>

#include <string>
#include <vector>

namespace gable {

/// What a file of footprints holds over a raster.
struct FootprintFile {
  std::vector<Footprint> footprints;  ///< valid polygons with distinct ids, in the file's order
  std::vector<std::string> skipped;   ///< "<id>: <reason>" of features that cannot be used
  std::vector<std::string> repaired;  ///< "<id>: <what was wrong>" of polygons made valid
  int num_outside = 0;                ///< valid polygons that do not touch the raster's extent
};

/// Reads the polygons of a vector file (GeoPackage, shapefile, GeoJSON and whatever else OGR reads)
/// that touch the extent of `grid`, in coordinates of `crs`. Every polygon is one building; a
/// multi-polygon is several. Ids come from the first of the fields identificatie, lokaalid, gml_id,
/// building_id, id, osm_id, uuid, toid, fid that exists, else from the feature number; parts and
/// repeated ids get "-2", "-3", ... A file without a CRS is taken to be in `crs`. Invalid polygons
/// are repaired (of several pieces the largest is kept). Throws Error: kNoInput where the file
/// cannot be opened; kBadInput where it is no vector file, has no polygon, or none touches the
/// grid.
FootprintFile read_footprints(const std::string& path, const Crs& crs, const Grid& grid);

}  // namespace gable
