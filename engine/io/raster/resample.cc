#include <gable/engine/io/raster/resample.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gable {
namespace {

/// Cells closer to a centre than this (in cells) take its value: grids that only differ by the
/// rounding of their corners are copied, not interpolated.
constexpr double kOnCenter = 1e-6;
constexpr double kMinWeight = 0.25 - 1e-6;

struct Split {
  int low;
  double share;  ///< of the next cell
};

Split split(double position) {
  const double nearest = std::round(position);
  if (std::abs(position - nearest) < kOnCenter) return {static_cast<int>(nearest), 0.0};
  const double low = std::floor(position);
  return {static_cast<int>(low), position - low};
}

}  // namespace

HeightRaster resample_bilinear(const HeightRaster& source, const Grid& target) {
  HeightRaster out(target, std::numeric_limits<float>::quiet_NaN());
  const Grid& grid = source.grid;
  for (int row = 0; row < target.rows; ++row) {
    for (int col = 0; col < target.cols; ++col) {
      const Eigen::Vector2d cell = grid.cell_of(target.center_of(row, col));
      // Beyond one cell outside nothing contributes; also keeps the indices small.
      if (!(cell.x() > -1.0 && cell.x() < grid.rows && cell.y() > -1.0 && cell.y() < grid.cols)) {
        continue;
      }
      const Split r = split(cell.x()), c = split(cell.y());
      double sum = 0.0, weight = 0.0;
      for (int i = 0; i < 2; ++i) {
        for (int j = 0; j < 2; ++j) {
          const double w = (i ? r.share : 1.0 - r.share) * (j ? c.share : 1.0 - c.share);
          if (w == 0.0 || !grid.contains(r.low + i, c.low + j)) continue;
          const double z = source.at(r.low + i, c.low + j);
          if (std::isnan(z)) continue;
          sum += w * z;
          weight += w;
        }
      }
      if (weight >= kMinWeight) out.at(row, col) = static_cast<float>(sum / weight);
    }
  }
  return out;
}

bool overlap(const Grid& a, const Grid& b) {
  const auto shared = [](double a0, double a1, double b0, double b1) {
    return std::min(a1, b1) > std::max(a0, b0);
  };
  return shared(a.north_west.x(), a.north_west.x() + a.cols * a.gsd, b.north_west.x(),
                b.north_west.x() + b.cols * b.gsd) &&
         shared(a.north_west.y() - a.rows * a.gsd, a.north_west.y(),
                b.north_west.y() - b.rows * b.gsd, b.north_west.y());
}

}  // namespace gable
