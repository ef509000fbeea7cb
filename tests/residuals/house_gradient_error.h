#pragma once

#include <gable/residuals/house_height_cost.h>
#include <gable/residuals/testing/gradient_check.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "residuals/kinks.h"
#include "residuals/random_houses.h"

namespace gable {

// First step of the differences, times max(1, |parameter|).
inline constexpr double kHouseGradientStep = 1e-3;

// Sets the weights of all pixels to zero that have a kink within the differencing interval of any
// parameter (see kinks.h); returns the share that is left.
inline double keep_smooth_pixels(const House& house, double support, HeightImage* image) {
  const RoofSampling sampling = image->spread > 0.0 ? RoofSampling::kMean : RoofSampling::kCentroid;
  const HeightField center(house);
  const std::vector<HeightField> fields = moved_fields(house, kHouseGradientStep);
  int kept = 0;
  for (int row = 0; row < image->rows; ++row) {
    for (int col = 0; col < image->cols; ++col) {
      const bool smooth = is_smooth_around(center, fields, house, image->center_of(row, col),
                                           std::max(support, image->spread), sampling);
      image->weight[image->index(row, col)] = smooth ? 1.0f : 0.0f;
      kept += smooth ? 1 : 0;
    }
  }
  return static_cast<double>(kept) / static_cast<double>(image->size());
}

// Worst relative error of the gradient of squared_residuals over all parameters. Entries below a
// thousandth of the largest are compared with that.
inline double house_gradient_error(const House& house, const HeightImage& image,
                                   const HeightCostOptions& options) {
  const HouseHeightEvaluator evaluator(house, &image, options);
  NormalEquations normal;
  evaluator.normal_equations(pointers(house).data(), &normal);
  const Eigen::VectorXd gradient = 2.0 * normal.jtr;
  const double largest = gradient.cwiseAbs().maxCoeff();
  const std::vector<double> values = all_values(house);
  double worst = 0.0;
  for (size_t k = 0; k < values.size(); ++k) {
    const auto squared = [&](double delta) {
      const House at = moved(house, static_cast<int>(k), delta);
      return std::vector<double>{evaluator.squared_residuals(pointers(at).data())};
    };
    const double numeric =
        ridders_derivative(squared, kHouseGradientStep * std::max(1.0, std::abs(values[k])))[0];
    worst = std::max(worst, relative_error(gradient[k], numeric, largest, 1e-3));
  }
  return worst;
}

}  // namespace gable
