#pragma once

#include <gable/engine/io/models/building.h>
#include <gable/residuals/height_image.h>

namespace gable {

/// How a building fits its height image. Pixels that are left out (weight 0) do not count.
struct BuildingFit {
  int pixels = 0;     ///< inside pixels compared
  double mad = 0.0;   ///< mean |model - height| over them, a miss counting as terrain, metres
  double rmse = 0.0;  ///< root mean square over the same pixels, metres
  double good = 0.0;  ///< share of them with |model - height| < 0.5 m, in [0, 1]
  /// `mad` with what the model covers beyond the inside pixels added: the sum of all differences,
  /// weighted, over the number of inside pixels, metres.
  double charge = 0.0;
  /// What the model covers of pixels that are taken (`is_taken`): the sum of its heights over their
  /// terrain over the number of inside pixels, metres.
  double intrusion = 0.0;
  double base = 0.0;  ///< lowest terrain under model and inside pixels, metres, <= 0
};

/// Compares point samples of the model at the pixel centres or, where heights are means, its mean
/// over the image's spread, terrain included. The building's origin must be the image's.
BuildingFit fit_of_building(const HeightImage& image, const Building& building);

/// Writes base, MAD and RMSE into a building.
void set_fit(const BuildingFit& fit, Building* building);

/// Makes the pixels that the model covers the inside ones, and no others.
void mark_covered(const Building& building, HeightImage* image);

}  // namespace gable
