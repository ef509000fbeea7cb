#include <gtest/gtest.h>

#include "residuals/house_gradient_error.h"

namespace gable {
namespace {

TEST(Gradient, HouseHeightCostAtRandomHouses) {
  double kept = 0.0;
  for (int i = 0; i < 1000; ++i) {
    Random random(static_cast<uint64_t>(i));
    const House house = rich_house(kAllFoundations[i % 6], &random);
    HeightImage image = noisy_image(static_cast<uint64_t>(i));
    image.rows = 12;
    image.cols = 13;
    image.gsd = 1.6;
    const double support = random.uniform(0.3, 2.5);
    const LossKind loss = i % 2 ? LossKind::kSoftL1 : LossKind::kGemanMcClure;
    kept += keep_smooth_pixels(house, support, &image);
    ASSERT_LT(house_gradient_error(house, image, {support, loss, 0.3, 1}), 1e-6) << "house " << i;
  }
  EXPECT_GT(kept / 1000, 0.9);  // kinks are rare: leaving them out does not empty the test
}

TEST(Gradient, HouseHeightCostOfHeightsThatAreMeans) {
  double kept = 0.0;
  for (int i = 0; i < 500; ++i) {
    Random random(static_cast<uint64_t>(i));
    const House house = rich_house(kAllFoundations[i % 6], &random);
    HeightImage image = noisy_image(static_cast<uint64_t>(i));
    image.rows = 12;
    image.cols = 13;
    image.gsd = 1.6;
    image.spread = random.uniform(0.3, 2.5);
    const double support = random.uniform(0.3, 2.5);
    const LossKind loss = i % 2 ? LossKind::kSoftL1 : LossKind::kGemanMcClure;
    kept += keep_smooth_pixels(house, support, &image);
    ASSERT_LT(house_gradient_error(house, image, {support, loss, 0.3, 1}), 1e-6) << "house " << i;
  }
  EXPECT_GT(kept / 500, 0.85);
}

}  // namespace
}  // namespace gable
