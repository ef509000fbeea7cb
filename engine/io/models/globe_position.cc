#include <gable/engine/error.h>
#include <gable/engine/io/gdal_messages.h>
#include <gable/engine/io/models/globe_position.h>
#include <gable/engine/io/ogr_crs.h>

#include <cmath>
#include <cstdio>
#include <string>

namespace gable {

GlobePosition::GlobePosition(const Crs& crs) {
  const GdalMessages messages;
  OGRSpatialReference map = ogr_from_crs(crs), globe;
  map.StripVertical();
  globe.SetWellKnownGeogCS("WGS84");
  globe.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  transformation_.reset(OGRCreateCoordinateTransformation(&map, &globe));
  if (!transformation_) {
    throw Error(ExitCode::kBadInput, "no transformation leads from " + crs.name +
                                         " to WGS 84; warp the raster to another system" +
                                         messages.suffix());
  }
}

GlobePosition::~GlobePosition() = default;

Eigen::Vector2d GlobePosition::lon_lat(const Eigen::Vector2d& map) const {
  const GdalMessages messages;
  double x = map.x(), y = map.y();
  if (!transformation_->Transform(1, &x, &y) || !std::isfinite(x) || !std::isfinite(y)) {
    char point[80];
    std::snprintf(point, sizeof point, "%.1f %.1f", map.x(), map.y());
    throw Error(ExitCode::kBadInput, std::string("the point ") + point +
                                         " has no position on the globe; check the reference "
                                         "system of the raster" +
                                         messages.suffix());
  }
  return {x, y};
}

}  // namespace gable
