#include <gable/engine/drawing/canvas.h>
#include <gable/engine/reconstruct/report/building_surface.h>
#include <gable/engine/reconstruct/report/house_picture.h>
#include <gable/engine/reconstruct/report/parts_panel.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <opencv2/imgcodecs.hpp>

#include "engine/reconstruct/report/report_sample.h"

namespace gable {
namespace {

enum Panel { kMeasured, kModel, kResidual, kParts };

// The colour at the middle of a cell on one of the picture's panels.
cv::Vec3b color_at(const HousePicture& picture, Panel panel, const HeightImage& image, int row,
                   int col) {
  const cv::Rect& rect = picture.panels[panel];
  const int x = rect.x + static_cast<int>((col + 0.5) * rect.width / image.cols);
  const int y = rect.y + static_cast<int>((row + 0.5) * rect.height / image.rows);
  return picture.image.at<cv::Vec3b>(y, x);
}

TEST(HousePicture, ResidualColoursAreMeasuredLessModel) {
  const Building building = courtyard_building("a");
  HeightImage image = image_of(building, 40, 0.5, 0.0, 1);
  image.height[image.index(3, 4)] += 5.0f;
  image.height[image.index(3, 6)] -= 5.0f;
  image.height[image.index(20, 10)] += 0.5f;
  image.weight[image.index(7, 7)] = 0.0f;
  const HousePicture picture = draw_house_picture(building, image, {});
  EXPECT_EQ(color_at(picture, kResidual, image, 3, 4), bgr(residual_color(1.0)));
  EXPECT_EQ(color_at(picture, kResidual, image, 3, 5), bgr(residual_color(0.0)));
  EXPECT_EQ(color_at(picture, kResidual, image, 3, 6), bgr(residual_color(-1.0)));
  EXPECT_EQ(color_at(picture, kResidual, image, 20, 10), bgr(residual_color(0.5)));
  EXPECT_EQ(color_at(picture, kResidual, image, 7, 7), bgr(kNoDataColor));
  EXPECT_EQ(color_at(picture, kMeasured, image, 7, 7), bgr(kNoDataColor));
}

TEST(HousePicture, EveryCellIsOneSquareOfEqualPixels) {
  const Building building = house_with_all_parts("a");
  const HeightImage image = image_of(building, 64, 0.5, 0.3, 1);
  const HousePicture picture = draw_house_picture(building, image, {});
  const cv::Rect& panel = picture.panels[kMeasured];
  ASSERT_EQ(panel.size(), cv::Size(320, 320));
  for (int y = 0; y < panel.height; ++y) {
    for (int x = 0; x < panel.width; ++x) {
      ASSERT_EQ(picture.image.at<cv::Vec3b>(panel.y + y, panel.x + x),
                color_at(picture, kMeasured, image, y / 5, x / 5));
    }
  }
}

TEST(HousePicture, PartsHaveTheirColours) {
  const Building building = house_with_all_parts("a");
  const HeightImage image = image_of(building, 160, 0.25, 0.0, 1);
  const HousePicture picture = draw_house_picture(building, image, {});
  const HeightField field(*building.house);
  const auto color = [&](const Eigen::Vector2d& house_point) {
    const Eigen::Vector2d local = field.local_from_house(house_point);
    const Eigen::Vector2d cell = (local - image.first_center) / image.gsd;
    return color_at(picture, kParts, image, static_cast<int>(std::lround(-cell.y())),
                    static_cast<int>(std::lround(cell.x())));
  };
  EXPECT_EQ(color({4.0, 1.0}), bgr(part_color(BlockRole::kComponent, 0)));
  EXPECT_EQ(color({-3.0, 6.0}), bgr(part_color(BlockRole::kComponent, 1)));
  EXPECT_EQ(color({9.0, -4.0}), bgr(kGarageColor));
  EXPECT_EQ(color({2.0, -3.9}), bgr(kDormerColor));
  EXPECT_EQ(color({-5.5, -1.0}), bgr(kChimneyColor));
}

TEST(HousePicture, SizeFollowsFromTheOptionsAlone) {
  const Building building = house_with_all_parts("a");
  const cv::Size expected =
      draw_house_picture(building, image_of(building, 64, 0.5, 0.0, 1), {}).image.size();
  for (const int cells : {1, 2, 33, 321, 700}) {
    const HeightImage image = image_of(building, cells, 0.5, 0.0, 1);
    EXPECT_EQ(draw_house_picture(building, image, {}).image.size(), expected) << cells;
  }
}

TEST(HousePicture, ImagesWithoutAnyMeasurementAreDrawn) {
  const Building building = house_with_all_parts("\xc3\xa9t\xc3\xa9");
  HeightImage image = image_of(building, 30, 0.5, 0.0, 1);
  image.weight.assign(image.size(), 0.0f);
  image.height.assign(image.size(), NAN);
  const HousePicture picture = draw_house_picture(building, image, {});
  EXPECT_EQ(color_at(picture, kMeasured, image, 15, 15), bgr(kNoDataColor));
}

TEST(BuildingSurface, HouseIsPlacedByItsOwnOrigin) {
  const Building building = house_with_all_parts("a");
  const BuildingSurface here(building, building.house->origin);
  const Eigen::Vector3d shift(3.0, -4.0, 1.5);
  const BuildingSurface there(building, building.house->origin - shift);
  const Eigen::Vector2d point(1.0, -2.0);
  EXPECT_NEAR(there.height(point + shift.head<2>(), 0.5, 0.7 + shift.z()),
              here.height(point, 0.5, 0.7) + shift.z(), 1e-9);
  EXPECT_EQ(there.part(point + shift.head<2>()).block, here.part(point).block);
}

TEST(BuildingSurface, CourtyardOfAnExtrusionIsGround) {
  const Building building = courtyard_building("a");
  const BuildingSurface surface(building, building.origin);
  EXPECT_EQ(surface.height({5.0, 0.0}, 0.5, -1.0), 6.0);
  EXPECT_EQ(surface.height({1.0, 0.0}, 0.5, -1.0), -1.0);
  EXPECT_EQ(surface.height({7.0, 0.0}, 0.5, -1.0), -1.0);
  EXPECT_EQ(surface.part({0.0, 0.0}).block, -1);
}

TEST(RoundLength, IsOneTwoOrFiveTimesAPowerOfTen) {
  EXPECT_DOUBLE_EQ(round_length(10.7), 10.0);
  EXPECT_DOUBLE_EQ(round_length(9.9), 5.0);
  EXPECT_DOUBLE_EQ(round_length(0.49), 0.2);
}

}  // namespace
}  // namespace gable
