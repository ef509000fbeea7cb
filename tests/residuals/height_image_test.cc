#include <gable/residuals/height_image.h>
#include <gtest/gtest.h>

#include <limits>

namespace gable {
namespace {

TEST(HeightImage, RastersBecomeHeightsOverTheOrigin) {
  const float nothing = std::numeric_limits<float>::quiet_NaN();
  const Grid grid{{1000.0, 2000.0}, 2.0, 2, 3};
  HeightRaster dsm(grid, 101.0f), dtm(grid, 100.0f);
  dsm.at(0, 1) = 106.5f;
  dsm.at(1, 0) = nothing;
  dtm.at(1, 2) = nothing;
  const HeightImage image = height_image(dsm, dtm, {1003.0, 1999.0, 99.0});
  EXPECT_EQ(image.rows, 2);
  EXPECT_EQ(image.cols, 3);
  EXPECT_EQ(image.gsd, 2.0);
  EXPECT_EQ(image.center_of(0, 1), Eigen::Vector2d(0.0, 0.0));
  EXPECT_EQ(image.center_of(1, 0), Eigen::Vector2d(-2.0, -2.0));
  EXPECT_EQ(image.height[1], 7.5f);
  EXPECT_EQ(image.ground[1], 1.0f);
  EXPECT_EQ(image.weight, (std::vector<float>{1, 1, 1, 0, 1, 0}));
  EXPECT_EQ(image.inside, (std::vector<unsigned char>{0, 1, 0, 0, 0, 0}));
}

}  // namespace
}  // namespace gable
