#include <gable/engine/dataset/synthetic_samples.h>
#include <gable/engine/evaluate/detectors/detector_truth.h>
#include <gtest/gtest.h>

#include <cmath>

namespace gable {
namespace {

TEST(DetectorTruth, PolygonPixelsAreThoseWhoseCentresLieInside) {
  const CropBits square = bits_of_polygon({{10.0, 20.0}, {30.0, 20.0}, {30.0, 25.0}, {10.0, 25.0}});
  EXPECT_EQ(square.count(), 100);
  EXPECT_TRUE(square.at(20, 10));
  EXPECT_FALSE(square.at(25, 10));
  const CropBits triangle = bits_of_polygon({{0.0, 0.0}, {64.0, 0.0}, {0.0, 64.0}});
  EXPECT_NEAR(triangle.count(), 2048, 40);
}

TEST(DetectorTruth, OfASampleCoversItsMaskButTheGarages) {
  const DatasetOptions options;
  double sum = 0.0;
  int count = 0;
  for (size_t i = 0; i < 60; ++i) {
    const TrainingSample sample = synthetic_sample(i, options);
    if (sample.foundation == Foundation::kC) continue;
    const DetectorTruth truth = truth_of(sample);
    EXPECT_EQ(truth.components.size(), truth.roofs.size());
    const CropBits all = truth.outline | truth.garages;
    sum += intersection_over_union(all, mask_bits(sample.crop));
    ++count;
  }
  EXPECT_GT(sum / count, 0.75);
}

/// An image of 40 x 40 m around (1000, 2000), high everywhere within 6 x 4 m of its centre, turned.
HeightImage block_image(double azimuth) {
  HeightImage image;
  image.origin = {1000.0, 2000.0, 5.0};
  image.gsd = 0.25;
  image.rows = image.cols = 160;
  image.first_center = {-19.875, 19.875};
  const double c = std::cos(azimuth), s = std::sin(azimuth);
  for (int row = 0; row < image.rows; ++row) {
    for (int col = 0; col < image.cols; ++col) {
      const Eigen::Vector2d p = image.center_of(row, col);
      const bool on =
          std::abs(c * p.x() + s * p.y()) < 6.0 && std::abs(-s * p.x() + c * p.y()) < 4.0;
      image.height.push_back(on ? 4.0f : 0.0f);
      image.ground.push_back(0.0f);
      image.weight.push_back(1.0f);
      image.inside.push_back(on);
    }
  }
  return image;
}

TEST(DetectorTruth, OfAnAnnotationLiesWhereTheHeightsAre) {
  const double azimuth = 0.6;
  const HeightImage image = block_image(azimuth);
  const double c = std::cos(azimuth), s = std::sin(azimuth);
  const auto world = [&](double x, double y) {
    return Eigen::Vector2d(1000.0 + c * x - s * y, 2000.0 + s * x + c * y);
  };
  AnnotatedHouse house;
  house.azimuth = azimuth;
  house.foundation = Foundation::kI;
  house.components = {{world(-6, 4), world(6, 4), world(-6, -4), world(6, -4)}};
  house.roofs = {RoofType::kFlat};
  house.chimneys = {world(5.0, 3.0)};
  for (const double turn : {0.0, 0.5 * M_PI}) {
    const DetectorTruth truth = truth_of(house, image, azimuth + turn);
    EXPECT_GT(intersection_over_union(truth.outline, mask_bits(truth.crop)), 0.97);
    ASSERT_EQ(truth.chimneys.size(), 1u);
    const Eigen::Vector2d p = truth.crop.house_from_crop(truth.chimneys[0]);
    const Eigen::Vector2d expected =
        turn == 0.0 ? Eigen::Vector2d(5.0, 3.0) : Eigen::Vector2d(3.0, -5.0);
    EXPECT_LT((p - expected).norm(), 1e-9);
  }
}

}  // namespace
}  // namespace gable
