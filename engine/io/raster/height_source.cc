#include <gable/engine/error.h>
#include <gable/engine/io/raster/height_source.h>
#include <gable/engine/io/raster/resample.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gable {

HeightRaster HeightSource::read_onto(const Grid& target) const {
  if (!overlap(target, grid())) {
    return HeightRaster(target, std::numeric_limits<float>::quiet_NaN());
  }
  const Eigen::Vector2d first = grid().cell_of(target.center_of(0, 0));
  const Eigen::Vector2d last = grid().cell_of(target.center_of(target.rows - 1, target.cols - 1));
  const auto clamp = [](double position, int count) {
    return static_cast<int>(std::clamp(position, 0.0, static_cast<double>(count)));
  };
  const int row0 = clamp(std::floor(first.x()) - 1, grid().rows);
  const int col0 = clamp(std::floor(first.y()) - 1, grid().cols);
  const int row1 = clamp(std::ceil(last.x()) + 2, grid().rows);
  const int col1 = clamp(std::ceil(last.y()) + 2, grid().cols);
  return resample_bilinear(read(row0, col0, row1 - row0, col1 - col0), target);
}

bool holds_height(const HeightSource& source, int strip_rows) {
  const Grid& grid = source.grid();
  for (int row = 0; row < grid.rows; row += strip_rows) {
    const HeightRaster strip =
        source.read(row, 0, std::min(strip_rows, grid.rows - row), grid.cols);
    if (std::any_of(strip.values.begin(), strip.values.end(),
                    [](float z) { return !std::isnan(z); })) {
      return true;
    }
  }
  return false;
}

void require_matching(const HeightSource& dsm, const HeightSource& dtm) {
  if (!same_horizontal_crs(dsm.crs(), dtm.crs())) {
    const std::string code =
        dsm.crs().epsg ? "EPSG:" + std::to_string(dsm.crs().epsg) : std::string("EPSG:NNNN");
    throw Error(ExitCode::kBadInput, dtm.path() + ": is in " + dtm.crs().name + ", but " +
                                         dsm.path() + " is in " + dsm.crs().name +
                                         "; warp it first: gdalwarp -t_srs " + code +
                                         " -r bilinear " + dtm.path() + " warped.tif");
  }
  if (!overlap(dsm.grid(), dtm.grid())) {
    throw Error(ExitCode::kBadInput, dtm.path() + ": does not overlap " + dsm.path() +
                                         "; give the terrain of the same area");
  }
}

}  // namespace gable
