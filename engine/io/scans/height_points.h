#pragma once

#include <gable/engine/io/scans/scan_file.h>

#include <string>

namespace gable {

/// The cells of a height raster as points: every cell with data a point at its centre, row by row
/// from the north. Errors as `RasterFile`.
ScanFile read_height_points(const std::string& path, const ReadScanOptions& options);

}  // namespace gable
