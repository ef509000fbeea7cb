#include <gable/grammar/synthesis/survey/mean_cells.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace gable {
namespace {

// Weights of the fine cells from `first` on, counted from a coarse cell's first one.
struct Weights {
  int first = 0;
  std::vector<double> values;
};

Weights weights_of(int factor, CellMeans means) {
  if (means == CellMeans::kOver) return {0, std::vector<double>(factor, 1.0 / factor)};
  Weights weights{-factor / 2, {}};
  for (int k = 0; k < 2 * factor; ++k) {
    const double from_middle = std::abs(k + 0.5 - factor) / factor;
    weights.values.push_back((1.0 - from_middle) / factor);
  }
  return weights;
}

// Along rows; the outermost cells go on beyond the border.
HeightRaster along_rows(const HeightRaster& fine, int factor, const Weights& weights) {
  Grid grid = fine.grid;
  grid.cols /= factor;
  HeightRaster out(grid, 0.0f);
  for (int row = 0; row < grid.rows; ++row) {
    for (int col = 0; col < grid.cols; ++col) {
      double sum = 0.0;
      for (size_t k = 0; k < weights.values.size(); ++k) {
        const int at = col * factor + weights.first + static_cast<int>(k);
        sum += weights.values[k] * fine.at(row, std::clamp(at, 0, fine.grid.cols - 1));
      }
      out.at(row, col) = static_cast<float>(sum);
    }
  }
  return out;
}

HeightRaster transposed(const HeightRaster& raster) {
  Grid grid = raster.grid;
  std::swap(grid.rows, grid.cols);
  HeightRaster out(grid, 0.0f);
  for (int row = 0; row < grid.rows; ++row) {
    for (int col = 0; col < grid.cols; ++col) out.at(row, col) = raster.at(col, row);
  }
  return out;
}

}  // namespace

HeightRaster mean_cells(const HeightRaster& fine, int factor, CellMeans means) {
  const Weights weights = weights_of(factor, means);
  HeightRaster out =
      transposed(along_rows(transposed(along_rows(fine, factor, weights)), factor, weights));
  out.grid.gsd = fine.grid.gsd * factor;
  return out;
}

}  // namespace gable
