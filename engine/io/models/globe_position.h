#pragma once

#include <gable/engine/io/crs.h>

#include <Eigen/Core>
#include <memory>

class OGRCoordinateTransformation;

namespace gable {

/// From a map's reference system to longitude and latitude on WGS 84, as globe viewers want them.
/// The transformation is PROJ's best one whose grids are installed: metres off at worst where a
/// country's grid is not.
class GlobePosition {
 public:
  /// Throws Error (kBadInput) where there is no way from this system to WGS 84.
  explicit GlobePosition(const Crs& crs);
  ~GlobePosition();

  /// Longitude and latitude, degrees, of an easting and northing in metres. Throws Error
  /// (kBadInput) where the point lies outside what the system is defined for.
  Eigen::Vector2d lon_lat(const Eigen::Vector2d& map) const;

 private:
  std::unique_ptr<OGRCoordinateTransformation> transformation_;
};

}  // namespace gable
