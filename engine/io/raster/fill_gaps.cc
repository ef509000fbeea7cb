#include <gable/engine/io/raster/fill_gaps.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace gable {
namespace {

constexpr int kDirections[4][2] = {{0, 1}, {1, 0}, {1, 1}, {1, -1}};

/// The nearest height along a direction.
struct Hit {
  int steps = 0;  ///< 0: none within reach
  float height = 0.0f;
};

Hit look(const HeightRaster& heights, int row, int col, int down, int right, int reach) {
  for (int k = 1; k <= reach; ++k) {
    const int r = row + k * down, c = col + k * right;
    if (!heights.grid.contains(r, c)) break;
    if (!std::isnan(heights.at(r, c))) return {k, heights.at(r, c)};
  }
  return {};
}

float between(const Hit& a, const Hit& b, float step) {
  if (std::abs(a.height - b.height) < step) {
    return (static_cast<float>(b.steps) * a.height + static_cast<float>(a.steps) * b.height) /
           static_cast<float>(a.steps + b.steps);
  }
  if (a.steps == b.steps) return std::max(a.height, b.height);
  return a.steps < b.steps ? a.height : b.height;
}

}  // namespace

HeightRaster fill_narrow_gaps(const HeightRaster& heights, int reach, float step) {
  HeightRaster out = heights;
  for (int row = 0; row < heights.grid.rows; ++row) {
    for (int col = 0; col < heights.grid.cols; ++col) {
      if (!std::isnan(heights.at(row, col))) continue;
      double least = HUGE_VAL;
      for (const auto& [down, right] : kDirections) {
        const Hit a = look(heights, row, col, down, right, reach);
        if (a.steps == 0) continue;
        const Hit b = look(heights, row, col, -down, -right, reach);
        if (b.steps == 0) continue;
        const double width = (a.steps + b.steps) * std::hypot(down, right);
        if (width >= least) continue;
        least = width;
        out.at(row, col) = between(a, b, step);
      }
    }
  }
  return out;
}

}  // namespace gable
