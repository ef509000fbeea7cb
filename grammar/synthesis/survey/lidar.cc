#include <gable/grammar/rasterise.h>
#include <gable/grammar/synthesis/survey/lidar.h>

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
  for_covered_cells(house, surface->grid, [&](int row, int col, double above_origin) {
    const float height = static_cast<float>(house.origin.z() + above_origin);
    surface->at(row, col) = height;
    if (truth != nullptr) truth->at(row, col) = height;
  });
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
