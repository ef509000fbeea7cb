#include <gable/training/scans/random_sampling.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace gable {
namespace {

TEST(RandomSampling, DrawsNoiseAndOutliersAlikeOftenAndPointsByTheirLogarithm) {
  Random random(3);
  std::map<double, int> noise, outliers;
  int below = 0;
  constexpr int kDraws = 12000;
  const double middle = std::sqrt(double{kLeastTrainingPoints} * kMostTrainingPoints);
  for (int i = 0; i < kDraws; ++i) {
    const SampleOptions options = random_sampling(&random);
    EXPECT_EQ(check(options), "");
    EXPECT_GE(options.num_points, kLeastTrainingPoints);
    EXPECT_LE(options.num_points, kMostTrainingPoints);
    ++noise[options.noise];
    ++outliers[options.outlier_share];
    below += options.num_points < middle;
  }
  // Five standard deviations of the numbers expected.
  ASSERT_EQ(noise.size(), 4u);
  for (const double share : {0.0, 0.002, 0.005, 0.01}) EXPECT_NEAR(noise[share], 3000, 240);
  ASSERT_EQ(outliers.size(), 3u);
  for (const double share : {0.0, 0.02, 0.05}) EXPECT_NEAR(outliers[share], 4000, 260);
  EXPECT_NEAR(below, kDraws / 2, 275);
}

}  // namespace
}  // namespace gable
