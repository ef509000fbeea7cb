#include <gable/grammar/synthesis/survey/survey_sampling.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gable {
namespace {

/// Rows and columns, the last ones included.
struct Cells {
  int row0 = 0, row1 = -1, col0 = 0, col1 = -1;
};

/// The cells that a shape may reach.
Cells cells_around(const BuiltShape& shape, double reach, const Grid& grid) {
  Eigen::Vector2d low = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector2d high = -low;
  for (const BuiltPart& part : shape.parts) {
    const double radius = part.radius() + reach;
    low = low.cwiseMin(part.center - Eigen::Vector2d::Constant(radius));
    high = high.cwiseMax(part.center + Eigen::Vector2d::Constant(radius));
  }
  const Eigen::Vector2d first = grid.cell_of({low.x(), high.y()});
  const Eigen::Vector2d last = grid.cell_of({high.x(), low.y()});
  Cells cells;
  cells.row0 = static_cast<int>(std::clamp(std::floor(first.x()), 0.0, grid.rows - 1.0));
  cells.col0 = static_cast<int>(std::clamp(std::floor(first.y()), 0.0, grid.cols - 1.0));
  cells.row1 = static_cast<int>(std::clamp(std::ceil(last.x()), 0.0, grid.rows - 1.0));
  cells.col1 = static_cast<int>(std::clamp(std::ceil(last.y()), 0.0, grid.cols - 1.0));
  return cells;
}

}  // namespace

SurveySampling random_sampling(bool smooth, double gsd, Random* random) {
  SurveySampling sampling;
  // Fine cells hold fewer points of a survey.
  const int most = gsd < 0.4 ? 3 : (gsd < 0.75 ? 5 : 7);
  if (smooth) {
    sampling.height = CellHeight::kMean;
    sampling.points = random->integer(2, most);
    sampling.footprint = random->uniform(0.8, 1.8);
  } else if (random->chance(0.4)) {
    sampling.height = CellHeight::kHighest;
    sampling.points = random->integer(2, most);
    sampling.footprint = 1.0;
  } else {
    sampling.footprint = random->chance(0.3) ? 0.0 : random->uniform(0.2, 1.0);
  }
  return sampling;
}

void sample_built(const std::vector<const BuiltShape*>& shapes, const SiteGround& ground,
                  const SurveySampling& sampling, Random* random, HeightRaster* surface) {
  const Grid& grid = surface->grid;
  const double span = sampling.footprint * grid.gsd;
  std::vector<char> near(grid.size(), 0);
  for (const BuiltShape* shape : shapes) {
    if (shape->parts.empty()) continue;
    const Cells cells = cells_around(*shape, 0.5 * span + grid.gsd, grid);
    for (int row = cells.row0; row <= cells.row1; ++row) {
      for (int col = cells.col0; col <= cells.col1; ++col) {
        near[static_cast<size_t>(row) * grid.cols + col] = 1;
      }
    }
  }
  for (int row = 0; row < grid.rows; ++row) {
    for (int col = 0; col < grid.cols; ++col) {
      if (!near[static_cast<size_t>(row) * grid.cols + col]) continue;
      const Eigen::Vector2d center = grid.center_of(row, col);
      double sum = 0.0;
      double highest = -std::numeric_limits<double>::infinity();
      for (int i = 0; i < sampling.points; ++i) {
        const double east = random->uniform(-0.5, 0.5), north = random->uniform(-0.5, 0.5);
        const Eigen::Vector2d point = center + span * Eigen::Vector2d(east, north);
        double height = ground.at(point);
        for (const BuiltShape* shape : shapes) height = std::max(height, shape->at(point));
        sum += height;
        highest = std::max(highest, height);
      }
      surface->at(row, col) = static_cast<float>(
          sampling.height == CellHeight::kHighest ? highest : sum / sampling.points);
    }
  }
}

}  // namespace gable
