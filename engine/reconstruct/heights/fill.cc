#include <gable/engine/reconstruct/heights/fill.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gable {
namespace {

/// Relaxation sweeps per level; with over-relaxation enough to carry a hole's border two cells of
/// the next coarser level inwards, which is all that is left to do there.
constexpr int kSweeps = 12;
constexpr float kOverRelaxation = 1.6f;

bool has_gaps(const HeightRaster& heights) {
  return std::any_of(heights.values.begin(), heights.values.end(),
                     [](float z) { return std::isnan(z); });
}

/// Means of 2 x 2 cells, over those that have a height.
HeightRaster halved(const HeightRaster& heights) {
  const Grid& fine = heights.grid;
  HeightRaster out({fine.north_west, 2.0 * fine.gsd, (fine.rows + 1) / 2, (fine.cols + 1) / 2},
                   std::numeric_limits<float>::quiet_NaN());
  for (int r = 0; r < out.grid.rows; ++r) {
    for (int c = 0; c < out.grid.cols; ++c) {
      double sum = 0.0;
      int count = 0;
      for (int k = 0; k < 4; ++k) {
        const int row = 2 * r + k / 2, col = 2 * c + k % 2;
        if (!fine.contains(row, col) || std::isnan(heights.at(row, col))) continue;
        sum += heights.at(row, col);
        ++count;
      }
      if (count > 0) out.at(r, c) = static_cast<float>(sum / count);
    }
  }
  return out;
}

/// Bilinear value of a coarse raster without gaps at a cell of the grid twice as fine.
float interpolated(const HeightRaster& coarse, int row, int col) {
  const auto neighbours = [](int i, int count) {
    const int near = i / 2;
    return std::pair(near, std::clamp(i % 2 ? near + 1 : near - 1, 0, count - 1));
  };
  const auto [r0, r1] = neighbours(row, coarse.grid.rows);
  const auto [c0, c1] = neighbours(col, coarse.grid.cols);
  return (9.0f * coarse.at(r0, c0) + 3.0f * coarse.at(r0, c1) + 3.0f * coarse.at(r1, c0) +
          coarse.at(r1, c1)) /
         16.0f;
}

/// Gauss-Seidel sweeps with over-relaxation over the cells listed.
void relax(const std::vector<size_t>& cells, HeightRaster* heights) {
  const int rows = heights->grid.rows, cols = heights->grid.cols;
  std::vector<float>& z = heights->values;
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    // The last sweep without it: over-relaxation leaves a ripple behind.
    const float step = sweep + 1 < kSweeps ? kOverRelaxation : 1.0f;
    for (const size_t i : cells) {
      const int r = static_cast<int>(i / cols), c = static_cast<int>(i % cols);
      const float north = z[r > 0 ? i - cols : i], south = z[r + 1 < rows ? i + cols : i];
      const float west = z[c > 0 ? i - 1 : i], east = z[c + 1 < cols ? i + 1 : i];
      z[i] += step * (0.25f * (north + south + west + east) - z[i]);
    }
  }
}

}  // namespace

HeightRaster fill_smoothly(const HeightRaster& heights) {
  if (!has_gaps(heights)) return heights;
  if (heights.grid.rows <= 1 && heights.grid.cols <= 1) return heights;
  const HeightRaster coarse = fill_smoothly(halved(heights));
  HeightRaster out = heights;
  std::vector<size_t> gaps;
  for (int r = 0; r < out.grid.rows; ++r) {
    for (int c = 0; c < out.grid.cols; ++c) {
      if (!std::isnan(out.at(r, c))) continue;
      out.at(r, c) = interpolated(coarse, r, c);
      gaps.push_back(static_cast<size_t>(r) * out.grid.cols + c);
    }
  }
  relax(gaps, &out);
  return out;
}

}  // namespace gable
