#pragma once

#include <gable/engine/io/crs.h>
#include <gable/engine/io/scans/las_header.h>

#include <Eigen/Core>
#include <functional>
#include <string>

namespace gable {

/// A point of a LAS or LAZ file.
struct LasPoint {
  Eigen::Vector3d position;  ///< in the file's reference system
  int classification = 0;    ///< ASPRS LAS specification 1.4 R15, tables 9 and 17
  bool withheld = false;     ///< marked as deleted
};

/// Calls `visit` with every point of a LAS or LAZ file, in the order of the file, which may be of
/// any size: a LAS file is read piece by piece (of a LAZ file the compressed bytes are held).
/// Points whose coordinates are not finite are left out. Throws Error: kNoInput where the file does
/// not exist or cannot be read, kBadInput where it is none, is truncated, or is a LAZ file and
/// gable is built without LASzip.
void visit_las_points(const std::string& path, const std::function<void(const LasPoint&)>& visit);

/// The reference system that a LAS or LAZ file names, as WKT or as the EPSG code among its GeoTIFF
/// keys; empty where it names none. Throws Error as `visit_las_points`, kBadInput where what it
/// names is no reference system.
Crs read_las_crs(const std::string& path);

}  // namespace gable
