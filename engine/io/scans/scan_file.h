#pragma once

#include <gable/engine/scan.h>

#include <cstddef>
#include <string>

namespace gable {

/// What a file of points or facets holds, and what of it could not be used.
struct ScanFile {
  Scan scan;
  size_t skipped_points = 0;  ///< a coordinate is not finite or beyond 1e12 m
  size_t skipped_facets = 0;  ///< use a skipped point or have fewer than three corners
};

struct ReadScanOptions {
  /// CRS of height rasters that carry none, e.g. "EPSG:27700"; see RasterFileOptions.
  std::string raster_crs;
};

/// Reads a scan; the extension (of any case) names the format: .ply, .xyz, .xyzn, .txt, .pwn, .off,
/// .obj, .las, .laz, .pcd, or a height raster .tif, .tiff, .asc, .vrt, whose cells with data become
/// points at their centres. The header of each format's reader says what is read of it.
///
/// Throws Error, one line with the file and the remedy: kNoInput where the file does not exist or
/// may not be read, kBadInput where the extension is unknown, the file is not what its extension
/// says, is damaged or truncated, or holds no usable point.
ScanFile read_scan_file(const std::string& path, const ReadScanOptions& options = {});

/// Whether the name of a file ends with one of these extensions.
bool has_scan_extension(const std::string& path);

/// The scan alone.
Scan read_scan(const std::string& path, const ReadScanOptions& options = {});

}  // namespace gable
