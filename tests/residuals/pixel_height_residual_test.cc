#include <gable/residuals/house_height_cost.h>
#include <gable/residuals/pixel_height_residual.h>
#include <gable/residuals/testing/gradient_check.h>
#include <gtest/gtest.h>

#include <memory>

#include "residuals/kinks.h"
#include "residuals/random_houses.h"

namespace gable {
namespace {

House two_hips(Random* random) {
  House house = make_house(Foundation::kII);
  house.azimuth[0] = random->uniform(-3.0, 3.0);
  for (int i = 0; i < 2; ++i) {
    for (double& v : house.footprints[i].parameters()) v += random->uniform(-2.0, 2.0);
    house.roofs[i] = make_rule(RuleKind::kRoofHip);
    house.roofs[i].ridge = random->chance(0.5) ? Axis::kX : Axis::kY;
    house.roofs[i].values = {random->uniform(3.0, 5.0), random->uniform(1.0, 4.0),
                             random->uniform(0.05, 0.45), random->uniform(0.05, 0.45)};
  }
  return house;
}

TEST(PixelHeightResidual, SumOfSquaresEqualsTheEvaluators) {
  for (uint64_t seed = 0; seed < 10; ++seed) {
    Random random(seed);
    const House house = two_hips(&random);
    const HeightImage image = noisy_image(seed);
    const HeightCostOptions options{0.5, seed % 2 ? LossKind::kSoftL1 : LossKind::kGemanMcClure,
                                    0.3, 1};
    double sum = 0.0;
    for (int row = 0; row < image.rows; ++row) {
      for (int col = 0; col < image.cols; ++col) {
        const size_t i = image.index(row, col);
        if (image.weight[i] == 0.0f) continue;
        const std::unique_ptr<ceres::CostFunction> cost(PixelHeightResidual::create(
            house, image.center_of(row, col), image.height[i], image.ground[i], options));
        double residual;
        ASSERT_TRUE(cost->Evaluate(pointers(house).data(), &residual, nullptr));
        sum += residual * residual;
      }
    }
    const HouseHeightEvaluator evaluator(house, &image, options);
    EXPECT_NEAR(evaluator.squared_residuals(pointers(house).data()), sum, 1e-10 * sum);
  }
}

TEST(Gradient, PixelHeightResidual) {
  Random random(1);
  GradientCheckOptions check;
  check.step = 1e-4;
  int seen = 0;
  while (seen < 1000) {
    const House house = two_hips(&random);
    const Eigen::Vector2d local(random.uniform(-8.0, 8.0), random.uniform(-8.0, 8.0));
    const double support = random.chance(0.5) ? 2.0 : 0.5;
    // Only where no kink lies within the steps of the differences, see kinks.h.
    if (!is_smooth_around(house, local, support, check.step)) continue;
    const std::unique_ptr<ceres::CostFunction> cost(
        PixelHeightResidual::create(house, local, 5.0, 0.1, {support, LossKind::kSoftL1, 0.3, 1}));
    std::vector<std::vector<double>> at;
    for (const Rule* rule : static_cast<const House&>(house).derivation()) {
      at.emplace_back(rule->parameters().begin(), rule->parameters().end());
    }
    const GradientCheckResult result = check_gradient(*cost, at, check);
    ASSERT_TRUE(result.evaluated);
    ASSERT_LT(result.relative_error, 1e-6) << result.report();
    ++seen;
  }
}

}  // namespace
}  // namespace gable
