#include <cpl_conv.h>
#include <gable/engine/io/raster/raster_cache.h>
#include <gdal.h>

namespace gable {

void limit_raster_cache(size_t bytes) {
  if (CPLGetConfigOption("GDAL_CACHEMAX", nullptr)) return;
  GDALSetCacheMax64(static_cast<GIntBig>(bytes));
}

}  // namespace gable
