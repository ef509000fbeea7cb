#include <gable/engine/detectors/house_crop.h>
#include <gtest/gtest.h>

#include <cmath>

namespace gable {
namespace {

/// A building whose heights are a plane over a rectangle of the house frame, on flat ground.
struct Slab {
  double azimuth = 0.0;
  double half_x = 6.0, half_y = 3.0;  ///< metres
  double height = 5.0;                ///< at the centre, metres
  double slope_x = 0.0, slope_y = 0.0;
};

HeightImage image_of(const Slab& slab, double gsd = 0.25, int size = 96) {
  HeightImage image;
  image.gsd = gsd;
  image.rows = image.cols = size;
  image.first_center = {-0.5 * (size - 1) * gsd, 0.5 * (size - 1) * gsd};
  const double c = std::cos(slab.azimuth), s = std::sin(slab.azimuth);
  for (int row = 0; row < size; ++row) {
    for (int col = 0; col < size; ++col) {
      const Eigen::Vector2d p = image.center_of(row, col);
      const double x = c * p.x() + s * p.y(), y = -s * p.x() + c * p.y();
      const bool on = std::abs(x) < slab.half_x && std::abs(y) < slab.half_y;
      image.ground.push_back(1.0f);
      image.height.push_back(
          static_cast<float>(1.0 + (on ? slab.height + slab.slope_x * x + slab.slope_y * y : 0.0)));
      image.weight.push_back(1.0f);
      image.inside.push_back(on);
    }
  }
  return image;
}

TEST(HouseCrop, IsTheSquareAroundTheRectifiedBoxWithAFifthAround) {
  Slab slab;
  slab.azimuth = 0.4;
  const HouseCrop crop = make_house_crop(image_of(slab), slab.azimuth);
  // Pixels at the border of a turned raster stick out by up to a pixel.
  EXPECT_NEAR(crop.pixel * kCropSize, 12.0 * 1.4, 0.5);
  const Eigen::Vector2d center = crop.house_from_crop({32.0, 32.0});
  EXPECT_NEAR(center.x(), 0.0, 0.13);
  EXPECT_NEAR(center.y(), 0.0, 0.13);
}

TEST(HouseCrop, PixelsShowThePlaceThatTheFrameSays) {
  Slab slab;
  slab.azimuth = 1.1;
  const HouseCrop crop = make_house_crop(image_of(slab), slab.azimuth);
  for (int row = 0; row < kCropSize; ++row) {
    for (int col = 0; col < kCropSize; ++col) {
      const Eigen::Vector2d house = crop.house_from_crop({col + 0.5, row + 0.5});
      const double to_edge =
          std::min(slab.half_x - std::abs(house.x()), slab.half_y - std::abs(house.y()));
      if (std::abs(to_edge) < 0.4) continue;
      const uint8_t mask = crop.mask[static_cast<size_t>(row) * kCropSize + col];
      EXPECT_EQ(mask, to_edge > 0.0 ? 1 : 0) << row << " " << col;
      EXPECT_EQ(crop.at(CropChannel::kDepth, row, col), to_edge > 0.0 ? 255 : 0);
    }
  }
}

TEST(HouseCrop, CropAndHouseFramesAreInverse) {
  const HouseCrop crop = make_house_crop(image_of(Slab()), 0.2);
  const Eigen::Vector2d point(13.25, 50.5);
  EXPECT_LT((crop.crop_from_house(crop.house_from_crop(point)) - point).norm(), 1e-12);
  EXPECT_GT(crop.house_from_crop({1.0, 0.0}).x(), crop.house_from_crop({0.0, 0.0}).x());
  EXPECT_LT(crop.house_from_crop({0.0, 1.0}).y(), crop.house_from_crop({0.0, 0.0}).y());
}

TEST(HouseCrop, NormalsAreThoseOfThePlaneInTheHouseFrame) {
  Slab slab;
  slab.azimuth = 0.7;
  slab.slope_x = 0.3;
  slab.slope_y = -0.5;
  const HouseCrop crop = make_house_crop(image_of(slab), slab.azimuth);
  const double nz = 1.0 / std::sqrt(1.0 + 0.3 * 0.3 + 0.5 * 0.5);
  EXPECT_NEAR(crop.at(CropChannel::kNormalX, 32, 32), 255.0 * (0.5 - 0.5 * 0.3 * nz), 1.0);
  EXPECT_NEAR(crop.at(CropChannel::kNormalY, 32, 32), 255.0 * (0.5 + 0.5 * 0.5 * nz), 1.0);
  EXPECT_NEAR(crop.at(CropChannel::kNormalZ, 32, 32), 255.0 * nz, 1.0);
}

TEST(HouseCrop, DepthIsTheHeightOverTheTerrainByTheHighestPixel) {
  Slab slab;
  slab.slope_x = 0.25;
  const HouseCrop crop = make_house_crop(image_of(slab), 0.0);
  EXPECT_NEAR(crop.top, 5.0 + 0.25 * 6.0, 0.05);
  EXPECT_NEAR(crop.at(CropChannel::kDepth, 32, 32), 255.0 * 5.0 / crop.top, 2.0);
}

TEST(HouseCrop, OneBirdDoesNotChangeTheDepthOfTheRoof) {
  HeightImage image = image_of(Slab());
  image.height[image.index(50, 50)] = 30.0f;
  EXPECT_DOUBLE_EQ(make_house_crop(image, 0.0).top, 5.0);
}

TEST(HouseCrop, HolesOfTheBuildingTakeTheNearestHeight) {
  HeightImage image = image_of(Slab());
  const HouseCrop whole = make_house_crop(image, 0.0);
  for (int row = 46; row < 50; ++row) {
    for (int col = 44; col < 50; ++col) {
      const size_t i = image.index(row, col);
      image.height[i] = image.ground[i];
      image.weight[i] = 0.0f;
    }
  }
  const HouseCrop holed = make_house_crop(image, 0.0);
  EXPECT_EQ(holed.channels, whole.channels);
  EXPECT_EQ(holed.mask, whole.mask);
}

TEST(HouseCrop, LowPixelsOfTheBuildingDoNotWidenTheBox) {
  HeightImage image = image_of(Slab());
  const HouseCrop tight = make_house_crop(image, 0.0);
  const size_t corner = image.index(2, 2);
  image.inside[corner] = 1;
  image.height[corner] = image.ground[corner] + 1.0f;
  EXPECT_EQ(make_house_crop(image, 0.0).pixel, tight.pixel);
}

TEST(HouseCrop, AnImageWithoutBuildingIsCutWhole) {
  HeightImage image = image_of(Slab());
  std::fill(image.inside.begin(), image.inside.end(), 0);
  const HouseCrop crop = make_house_crop(image, 0.0);
  EXPECT_NEAR(crop.pixel * kCropSize, 1.4 * 24.0, 1e-9);
}

}  // namespace
}  // namespace gable
