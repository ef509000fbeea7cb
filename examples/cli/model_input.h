#pragma once

#include <gable/engine/io/models/building.h>
#include <gable/engine/io/raster/raster_file.h>

#include <string>
#include <vector>

namespace gable {

/// The models of a file, checked to lie in the surface's reference system. Throws Error: as
/// `read_buildings`, and kBadInput where the systems differ.
std::vector<Building> read_models(const std::string& path, const RasterFile& dsm);

}  // namespace gable
