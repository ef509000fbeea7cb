#include <gable/engine/io/raster/raster_file.h>
#include <gable/engine/io/scans/finish_scan.h>
#include <gable/engine/io/scans/height_points.h>

#include <algorithm>
#include <cmath>

namespace gable {

ScanFile read_height_points(const std::string& path, const ReadScanOptions& options) {
  constexpr int kRowsAtOnce = 256;
  const RasterFile file(path, {.crs = options.raster_crs});
  const Grid& grid = file.grid();
  Scan scan;
  for (int row0 = 0; row0 < grid.rows; row0 += kRowsAtOnce) {
    const int rows = std::min(kRowsAtOnce, grid.rows - row0);
    const HeightRaster heights = file.read(row0, 0, rows, grid.cols);
    for (int row = 0; row < rows; ++row) {
      for (int col = 0; col < grid.cols; ++col) {
        const float height = heights.at(row, col);
        if (std::isnan(height)) continue;
        const Eigen::Vector2d center = grid.center_of(row0 + row, col);
        scan.points.emplace_back(center.x(), center.y(), height);
      }
    }
  }
  return finish_scan(std::move(scan), path);
}

}  // namespace gable
