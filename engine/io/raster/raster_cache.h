#pragma once

#include <cstddef>

namespace gable {

/// Limits what the process keeps in memory of raster files that it has read, in bytes; GDAL keeps
/// 5 % of the machine's memory unless told. The environment variable GDAL_CACHEMAX goes before it.
void limit_raster_cache(size_t bytes);

}  // namespace gable
