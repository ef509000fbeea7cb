#include <gtest/gtest.h>

#include "residuals/house_gradient_error.h"

namespace gable {
namespace {

// Checks the gradient at random houses in first returns or in means; returns the share of pixels
// that it was checked over.
double check_random_houses(int count, bool means) {
  double kept = 0.0;
  for (int i = 0; i < count; ++i) {
    Random random(static_cast<uint64_t>(i));
    const House house = rich_house(kAllFoundations[i % 6], &random);
    HeightImage image = noisy_image(static_cast<uint64_t>(i));
    image.rows = 12;
    image.cols = 13;
    image.gsd = 1.6;
    const double support = random.uniform(0.3, 2.5);
    if (means) image.spread = random.uniform(0.3, 2.5);
    const LossKind loss = i % 2 ? LossKind::kSoftL1 : LossKind::kGemanMcClure;
    kept += keep_smooth_pixels(house, support, &image) / count;
    EXPECT_LT(house_gradient_error(house, image, {support, loss, 0.3, 1}), 1e-6) << "house " << i;
  }
  return kept;
}

TEST(Gradient, HouseHeightCostAtRandomHouses) {
  // Kinks are rare: leaving them out does not empty the test.
  EXPECT_GT(check_random_houses(1000, false), 0.9);
}

TEST(Gradient, HouseHeightCostOfHeightsThatAreMeans) {
  EXPECT_GT(check_random_houses(500, true), 0.85);
}

}  // namespace
}  // namespace gable
