#include <gable/grammar/synthesis/ground/site_ground.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace gable {

SiteGround::SiteGround(const Eigen::Vector2d& center, Random* random) : center_(center) {
  height_ = random->uniform(0.0, 150.0);
  const double downhill = random->uniform(0.0, 2.0 * M_PI);
  const double steepness = random->uniform(0.0, 1.0) * random->uniform(0.0, 0.1);
  gradient_ = steepness * Eigen::Vector2d(std::cos(downhill), std::sin(downhill));
  const double bend = random->uniform(0.0, 2.0 * M_PI);
  bend_ = Eigen::Vector2d(std::cos(bend), std::sin(bend));
  curvature_ = random->uniform(-0.0008, 0.0008);
}

HeightRaster SiteGround::on(const Grid& grid) const {
  HeightRaster raster(grid, 0.0f);
  for (int row = 0; row < grid.rows; ++row) {
    for (int col = 0; col < grid.cols; ++col) {
      raster.at(row, col) = static_cast<float>(at(grid.center_of(row, col)));
    }
  }
  return raster;
}

void add_terrain_error(double most, Random* random, HeightRaster* terrain) {
  const Grid& grid = terrain->grid;
  // Waves along rows times waves along columns, so that a cell costs a product each.
  constexpr int kWaves = 2;
  std::vector<double> by_row(static_cast<size_t>(grid.rows)),
      by_col(static_cast<size_t>(grid.cols));
  for (int wave = 0; wave < kWaves; ++wave) {
    const double amplitude = most / kWaves * random->uniform(-1.0, 1.0);
    const auto fill = [&](std::vector<double>* values) {
      const double frequency = 2.0 * M_PI / random->uniform(10.0, 40.0);
      const double phase = random->uniform(0.0, 2.0 * M_PI);
      for (size_t i = 0; i < values->size(); ++i) {
        (*values)[i] = std::sin(phase + frequency * grid.gsd * static_cast<double>(i));
      }
    };
    fill(&by_row);
    fill(&by_col);
    for (int row = 0; row < grid.rows; ++row) {
      for (int col = 0; col < grid.cols; ++col) {
        const double error =
            amplitude * by_row[static_cast<size_t>(row)] * by_col[static_cast<size_t>(col)];
        terrain->at(row, col) = static_cast<float>(terrain->at(row, col) + error);
      }
    }
  }
}

}  // namespace gable
