#include <gable/grammar/synthesis/survey/survey_defects.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace gable {
namespace {

constexpr float kMissing = std::numeric_limits<float>::quiet_NaN();

void drop_single_cells(Random* random, HeightRaster* surface) {
  const double share = std::pow(10.0, random->uniform(-2.7, -1.4));
  for (float& height : surface->values) {
    if (random->chance(share)) height = kMissing;
  }
}

void drop_blobs(Random* random, HeightRaster* surface) {
  const Grid& grid = surface->grid;
  const int count = random->integer(1, 5);
  for (int i = 0; i < count; ++i) {
    const double row = random->uniform(0.1, 0.9) * grid.rows;
    const double col = random->uniform(0.1, 0.9) * grid.cols;
    const double radius = random->uniform(0.3, 1.6) / grid.gsd;  // cells
    const int reach = static_cast<int>(std::ceil(radius));
    const bool square = random->chance(0.35);  // coarse cells of an earlier raster
    for (int dr = -reach; dr <= reach; ++dr) {
      for (int dc = -reach; dc <= reach; ++dc) {
        const int r = static_cast<int>(row) + dr, c = static_cast<int>(col) + dc;
        const double off = square ? std::max(std::abs(dr), std::abs(dc)) : std::hypot(dr, dc);
        if (!grid.contains(r, c) || off > radius * (square ? 1.0 : random->uniform(0.7, 1.1))) {
          continue;
        }
        surface->at(r, c) = kMissing;
      }
    }
  }
}

/// Cells that something higher hides from a sensor that looks down from one side.
void drop_shadows(Random* random, HeightRaster* surface) {
  const Grid& grid = surface->grid;
  const double from = random->uniform(0.0, 2.0 * M_PI);
  const double run = std::tan(random->uniform(8.0, 22.0) * M_PI / 180.0);  // off the vertical
  const double share = random->uniform(0.5, 1.0);
  const HeightRaster seen = *surface;
  constexpr double kFarthest = 4.0;
  const int steps = std::max(1, static_cast<int>(kFarthest / grid.gsd));
  std::vector<int> rows, cols;  // of each step
  for (int step = 1; step <= steps; ++step) {
    rows.push_back(-static_cast<int>(std::lround(step * std::sin(from))));
    cols.push_back(static_cast<int>(std::lround(step * std::cos(from))));
  }
  for (int row = 0; row < grid.rows; ++row) {
    for (int col = 0; col < grid.cols; ++col) {
      const float height = seen.at(row, col);
      for (int step = 1; step <= steps; ++step) {
        const int r = row + rows[static_cast<size_t>(step - 1)];
        const int c = col + cols[static_cast<size_t>(step - 1)];
        if (!grid.contains(r, c)) break;
        // Nothing is hidden behind a cell that is missing itself.
        if (!((seen.at(r, c) - height) * run >= step * grid.gsd)) continue;
        if (random->chance(share)) surface->at(row, col) = kMissing;
        break;
      }
    }
  }
}

}  // namespace

void blend_cells(double share, HeightRaster* surface) {
  const Grid& grid = surface->grid;
  const HeightRaster sharp = *surface;
  for (int row = 0; row < grid.rows; ++row) {
    for (int col = 0; col < grid.cols; ++col) {
      const float height = sharp.at(row, col);
      if (!std::isfinite(height)) continue;
      double sum = 0.0, weights = 0.0;
      for (int r = std::max(0, row - 1); r <= std::min(grid.rows - 1, row + 1); ++r) {
        for (int c = std::max(0, col - 1); c <= std::min(grid.cols - 1, col + 1); ++c) {
          const float other = sharp.at(r, c);
          if (!std::isfinite(other)) continue;
          const double weight = (r == row ? 2.0 : 1.0) * (c == col ? 2.0 : 1.0);
          // Relative to the cell, so that level ground stays what it is.
          sum += weight * (other - height);
          weights += weight;
        }
      }
      surface->at(row, col) = static_cast<float>(height + share * sum / weights);
    }
  }
}

void random_holes(Random* random, HeightRaster* surface) {
  const double kind = random->uniform(0.0, 1.0);
  if (kind < 0.6) drop_single_cells(random, surface);
  if (kind > 0.4) drop_shadows(random, surface);
  if (random->chance(0.45)) drop_blobs(random, surface);
}

}  // namespace gable
