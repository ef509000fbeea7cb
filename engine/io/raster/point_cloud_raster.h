#pragma once

#include <gable/engine/io/raster/scratch_heights.h>

#include <memory>
#include <string>
#include <vector>

namespace gable {

struct PointCloudRasterOptions {
  double gsd = 0.5;  ///< cell size, metres, [0.05, 10]
  /// CRS of files that name none, e.g. "EPSG:28992". Empty: such files are refused.
  std::string crs;
  /// Gaps of the surface up to twice this wide are filled, metres, [0, 10]; up to four cells are
  /// always filled.
  double gap = 1.0;
  std::string scratch;  ///< folder of temporary files; empty: the system's
};

/// Empty if the options are in range; otherwise names the violated bound.
std::string check(const PointCloudRasterOptions& options);

/// Rasters of point clouds.
struct PointCloudRaster {
  std::unique_ptr<ScratchHeights> dsm;
  std::unique_ptr<ScratchHeights> dtm;  ///< with gaps; null where not every file has ground points
  size_t num_points = 0;                ///< in the files
  size_t num_used = 0;                  ///< of the surface
  std::string used;                     ///< for people: which points made what
};

/// Turns LAS and LAZ files into one raster: its cells at whole multiples of the cell size from the
/// origin of the CRS.
///
/// The surface is the highest point of a cell. Where any file has buildings (class 6), classes 6, 2
/// and 8 (ground) and 9 (water) are used, so that trees, cars and wires are no part of it;
/// otherwise all but noise (7 and 18). Points that are withheld never count. Narrow gaps are filled
/// between the nearest cells on both sides, linearly, or with the nearer one where these are 1 m
/// and more apart, as across eaves. The terrain is the lowest ground point of a cell.
///
/// The files are read piece by piece, several times, and the rasters kept on disk: memory depends
/// on neither. Throws Error: as `visit_las_points`; kBadInput, naming the file, where a file has no
/// usable point, no CRS, one that is not in projected metres, or another than the first file.
PointCloudRaster rasterise_point_clouds(const std::vector<std::string>& paths,
                                        const PointCloudRasterOptions& options);

/// Whether a file's name ends with .las or .laz, of any case.
bool is_point_cloud(const std::string& path);

}  // namespace gable
