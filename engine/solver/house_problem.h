#pragma once

#include <ceres/problem.h>
#include <gable/grammar/house.h>
#include <gable/residuals/height_image.h>

#include <vector>

namespace gable {

// What every problem over the parameters of houses shares, whether one house is refined or many.

/// The parameter blocks of a house, in derivation order.
std::vector<double*> parameter_blocks(House* house);

/// Bounds all parameters of a house by their tables, and its eaves and heights by 2 m over the
/// highest measurement of the image as well: over pixels that a saturating loss has given up a
/// block would rise without end. Values outside are moved to their bounds, since Ceres refuses
/// infeasible starts. The blocks must be in the problem.
void set_house_bounds(const HeightImage& image, House* house, ceres::Problem* problem);

/// How a house differs from the measured pixels that it covers, metres: from point samples, or from
/// means over the image's spread.
struct HouseErrors {
  double mad = 0.0;   ///< mean |h - height|
  double rmse = 0.0;  ///< root mean square
  /// Robust standard deviation, 1.4826 times the median of |h - height|, of heights that are wrong
  /// independently of each other (`shared_error`).
  double noise = 0.0;
};

HouseErrors house_errors(const HeightImage& image, const House& house);

/// Standard deviations of a house's parameters, one vector per rule in derivation order, from the
/// problem that holds its blocks, at the current values. `noise` is the standard deviation of a
/// height.
std::vector<std::vector<double>> house_deviations(double noise, House* house,
                                                  ceres::Problem* problem);

}  // namespace gable
