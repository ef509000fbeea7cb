#include <gable/grammar/height_field.h>
#include <gable/residuals/house_height_cost.h>
#include <gable/residuals/testing/gradient_check.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "residuals/kinks.h"
#include "residuals/random_houses.h"

namespace gable {
namespace {

constexpr double kStep = 1e-3;

// Sets the weights of all pixels to zero that have a kink within the differencing interval of any
// parameter; returns the share that is left.
double keep_smooth_pixels(const House& house, double support, HeightImage* image) {
  const HeightField center(house);
  const std::vector<HeightField> fields = moved_fields(house, kStep);
  int kept = 0;
  for (int row = 0; row < image->rows; ++row) {
    for (int col = 0; col < image->cols; ++col) {
      const size_t i = image->index(row, col);
      const bool smooth =
          is_smooth_around(center, fields, house, image->center_of(row, col), support);
      image->weight[i] = smooth ? 1.0f : 0.0f;
      kept += smooth ? 1 : 0;
    }
  }
  return static_cast<double>(kept) / static_cast<double>(image->size());
}

// Worst relative error of the gradient of squared_residuals over all parameters.
double gradient_error(const House& house, const HeightImage& image,
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
        ridders_derivative(squared, kStep * std::max(1.0, std::abs(values[k])))[0];
    worst = std::max(worst, relative_error(gradient[k], numeric, largest, 1e-3));
  }
  return worst;
}

TEST(Gradient, HouseHeightCostAtRandomHouses) {
  double kept = 0.0;
  for (int i = 0; i < 1000; ++i) {
    Random random(static_cast<uint64_t>(i));
    const House house = rich_house(kAllFoundations[i % 5], &random);
    HeightImage image = noisy_image(static_cast<uint64_t>(i));
    image.rows = 12;
    image.cols = 13;
    image.gsd = 1.6;
    const double support = random.uniform(0.3, 2.5);
    const LossKind loss = i % 2 ? LossKind::kSoftL1 : LossKind::kGemanMcClure;
    kept += keep_smooth_pixels(house, support, &image);
    ASSERT_LT(gradient_error(house, image, {support, loss, 0.3, 1}), 1e-6) << "house " << i;
  }
  EXPECT_GT(kept / 1000, 0.9);  // kinks are rare: leaving them out does not empty the test
}

}  // namespace
}  // namespace gable
