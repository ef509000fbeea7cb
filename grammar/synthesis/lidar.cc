#include <gable/grammar/height_field.h>
#include <gable/grammar/synthesis/lidar.h>
#include <gable/grammar/synthesis/rectangle.h>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace gable {

std::string LidarOptions::check() const {
  if (!(noise_share >= 0.0 && noise_share <= 1.0)) return "noise_share must be in [0, 1]";
  if (!(noise_range >= 0.0)) return "noise_range must be >= 0";
  if (!(outlier_share >= 0.0 && outlier_share <= 1.0)) return "outlier_share must be in [0, 1]";
  if (!(outlier_low <= outlier_high)) return "outlier_low must be <= outlier_high";
  return "";
}

void rasterise_house(const House& house, HeightRaster* surface, HeightRaster* truth) {
  const HeightField field(house);
  Rectangle box = rectangle_of(field.blocks()[0]);
  for (const auto& block : field.blocks()) box = bounds(box, rectangle_of(block));
  const double radius = std::max(std::hypot(box.x0, box.y0), std::hypot(box.x1, box.y1)) +
                        std::max(box.size_x(), box.size_y());
  const Grid& grid = surface->grid;
  const Eigen::Vector2d center = house.origin.head<2>();
  const Eigen::Vector2d first = grid.cell_of(center + Eigen::Vector2d(-radius, radius));
  const Eigen::Vector2d last = grid.cell_of(center + Eigen::Vector2d(radius, -radius));
  const int row_end = std::min(grid.rows - 1, static_cast<int>(std::ceil(last.x())));
  const int col_end = std::min(grid.cols - 1, static_cast<int>(std::ceil(last.y())));
  for (int row = std::max(0, static_cast<int>(std::floor(first.x()))); row <= row_end; ++row) {
    for (int col = std::max(0, static_cast<int>(std::floor(first.y()))); col <= col_end; ++col) {
      const Eigen::Vector2d point = field.house_from_local(grid.center_of(row, col) - center);
      if (field.block_at_house(point) < 0) continue;
      // The ground is not read where a block covers the point.
      const double height = house.origin.z() + field.at_house(point, 0.0, 0.0);
      surface->at(row, col) = static_cast<float>(height);
      if (truth != nullptr) truth->at(row, col) = static_cast<float>(height);
    }
  }
}

void add_survey_noise(const LidarOptions& options, const HeightRaster& ground, Random* random,
                      HeightRaster* surface) {
  assert(options.check().empty());
  assert(ground.grid == surface->grid);
  for (size_t i = 0; i < surface->values.size(); ++i) {
    float& height = surface->values[i];
    const bool noisy = random->chance(options.noise_share);
    const double noise = random->uniform(-options.noise_range, options.noise_range);
    const bool outlier = random->chance(options.outlier_share);
    const double other = random->uniform(options.outlier_low, options.outlier_high);
    if (!std::isfinite(height)) continue;
    if (outlier) {
      height = static_cast<float>(ground.values[i] + other);
    } else if (noisy) {
      height = static_cast<float>(height + noise);
    }
  }
}

}  // namespace gable
