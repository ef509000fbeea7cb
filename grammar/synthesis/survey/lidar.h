#pragma once

#include <gable/grammar/house.h>
#include <gable/grammar/random.h>
#include <gable/grammar/raster.h>

#include <string>

namespace gable {

/// What a survey does to heights. The default is the paper's noise (NPR section 5.4).
struct LidarOptions {
  double noise_share = 0.7;    ///< samples that carry noise, [0, 1]
  double noise_range = 0.3;    ///< the noise is uniform in [-range, range], metres, >= 0
  double outlier_share = 0.0;  ///< samples replaced by a random height, [0, 1]
  double outlier_low = -3.0;   ///< outliers are uniform over the ground in [low, high], metres
  double outlier_high = 15.0;  ///< metres, >= outlier_low

  /// Empty, or one line that names the bound that does not hold.
  std::string check() const;
};

/// Raises `surface` (world heights) to a house wherever a block covers a cell's centre: a point
/// sample of the height field, support 0. Covered cells are set, not only raised. Where `truth` is
/// given, the same heights go there. The rasters share one grid.
void rasterise_house(const House& house, HeightRaster* surface, HeightRaster* truth = nullptr);

/// Adds noise and outliers to every finite cell. `ground` (same grid) is what outliers are over.
/// The numbers drawn depend on the cells' order only, never on the heights.
void add_survey_noise(const LidarOptions& options, const HeightRaster& ground, Random* random,
                      HeightRaster* surface);

}  // namespace gable
