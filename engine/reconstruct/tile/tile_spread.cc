#include <gable/engine/reconstruct/heights/raster_spread.h>
#include <gable/engine/reconstruct/tile/tile_spread.h>
#include <gable/engine/reconstruct/tile/tile_windows.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

namespace gable {
namespace {

constexpr int kPartCells = 1024;
constexpr size_t kEnoughWalls = 3000;

// Steps through `count` parts so that each comes once and every few are spread over all: near the
// golden section, without a common divisor.
size_t scattering_step(size_t count) {
  size_t step = static_cast<size_t>(std::llround(0.618 * static_cast<double>(count)));
  while (step > 1 && std::gcd(step, count) != 1) --step;
  return std::max<size_t>(step, 1);
}

}  // namespace

double tile_spread(const HeightSource& dsm) {
  const std::vector<CellBox> parts = window_cores(dsm.grid(), kPartCells);
  const size_t step = scattering_step(parts.size());
  std::vector<double> widths;
  for (size_t i = 0; i < parts.size() && widths.size() < kEnoughWalls; ++i) {
    const CellBox& box = parts[i * step % parts.size()];
    const std::vector<double> seen =
        wall_widths(dsm.read(box.row0, box.col0, box.row1 - box.row0, box.col1 - box.col0));
    widths.insert(widths.end(), seen.begin(), seen.end());
  }
  return raster_spread(std::move(widths), dsm.grid().gsd);
}

}  // namespace gable
