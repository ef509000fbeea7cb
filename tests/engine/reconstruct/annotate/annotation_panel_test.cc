#include <gable/engine/reconstruct/annotate/annotation_panel.h>
#include <gable/engine/reconstruct/annotate/annotation_sheets.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <opencv2/core.hpp>

namespace gable {
namespace {

// Where the two panels lie in the picture.
constexpr int kFirst = 26, kSecond = 2 * 26 + 384 + 10, kTop = 38;

CropFrame frame() { return {0.0, {100.0, 300.0}, 0.5}; }

/// A plane that rises to the east by one in two, from height 10 at x = 100.
HeightRaster slope() {
  HeightRaster raster({{90.0, 310.0}, 1.0, 60, 60}, 0.0f);
  for (int row = 0; row < 60; ++row) {
    for (int col = 0; col < 60; ++col) {
      raster.at(row, col) =
          static_cast<float>(10.0 + 0.5 * (raster.grid.center_of(row, col).x() - 100.0));
    }
  }
  return raster;
}

HouseAnswer block() {
  HouseAnswer answer;
  answer.frame = frame();
  answer.foundation = Foundation::kI;
  answer.rectangles = {{16.0, 40.0, 20.0, 44.0}};
  return answer;
}

cv::Vec3b at(const cv::Mat& panel, int left, double x, double y) {
  return panel.at<cv::Vec3b>(kTop + static_cast<int>(6.0 * y), left + static_cast<int>(6.0 * x));
}

TEST(AnnotationPanel, ShowsTheAnswersOutlineAtItsCropPixels) {
  const HouseAnswer answer = block();
  const HeightRaster dsm = slope();
  const cv::Mat with = draw_annotation_panel({&answer, &dsm, 10.0, nullptr, ""});
  HouseAnswer bare = answer;
  bare.rectangles.clear();
  const cv::Mat without = draw_annotation_panel({&bare, &dsm, 10.0, nullptr, ""});
  EXPECT_EQ(with.size(), annotation_panel_size());
  const auto is_white = [](const cv::Vec3b& color) {
    return std::min({color[0], color[1], color[2]}) > 225;
  };
  for (const int left : {kFirst, kSecond}) {
    EXPECT_TRUE(is_white(at(with, left, 16.0, 30.5)));
    EXPECT_TRUE(is_white(at(with, left, 40.0, 30.5)));
    EXPECT_TRUE(is_white(at(with, left, 20.5, 44.0)));
    EXPECT_FALSE(is_white(at(without, left, 16.0, 30.5)));
    EXPECT_EQ(at(with, left, 20.5, 30.5), at(without, left, 20.5, 30.5));
  }
}

TEST(AnnotationPanel, NormalsAreThoseOfTheSurfaceInTheCropsFrame) {
  HouseAnswer answer = block();
  answer.rectangles.clear();
  const HeightRaster dsm = slope();
  const cv::Mat panel = draw_annotation_panel({&answer, &dsm, 10.0, nullptr, ""});
  // Normal (-0.5, 0, 1) / sqrt(1.25), as (n_z, n_y, n_x) in BGR.
  const cv::Vec3b color = at(panel, kSecond, 30.5, 30.5);
  EXPECT_NEAR(color[0], 255.0 / std::sqrt(1.25), 1.0);
  EXPECT_NEAR(color[1], 127.5, 1.0);
  EXPECT_NEAR(color[2], 127.5 * (1.0 - 0.5 / std::sqrt(1.25)), 1.0);
  // Seen from the north, the same slope falls to the viewer's right.
  answer.frame.azimuth = M_PI;
  answer.frame.north_west = {132.0, 268.0};
  const cv::Vec3b turned =
      at(draw_annotation_panel({&answer, &dsm, 10.0, nullptr, ""}), kSecond, 30.5, 30.5);
  EXPECT_NEAR(turned[2], 127.5 * (1.0 + 0.5 / std::sqrt(1.25)), 1.0);
}

TEST(AnnotationPanel, TheGridAroundAFrameHoldsIt) {
  const Grid raster = slope().grid;
  CropFrame turned = frame();
  turned.azimuth = 0.5;
  const Grid grid = grid_around(turned, raster);
  for (const double x : {0.0, 64.0}) {
    for (const double y : {0.0, 64.0}) {
      const Eigen::Vector2d p = turned.world_from_crop({x, y});
      const Eigen::Vector2d whole = raster.cell_of(p), cell = grid.cell_of(p);
      if (whole.minCoeff() < 1.0 || whole.maxCoeff() > 57.0) continue;  // the raster's edge
      EXPECT_GE(cell.minCoeff(), 0.0);
      EXPECT_LE(cell.x(), grid.rows - 1.0);
      EXPECT_LE(cell.y(), grid.cols - 1.0);
    }
  }
  const Eigen::Vector2d offset = (grid.north_west - raster.north_west) / raster.gsd;
  EXPECT_LT((offset - offset.array().round().matrix()).norm(), 1e-9);
  CropFrame away = frame();
  away.north_west = {10000.0, 300.0};
  EXPECT_EQ(grid_around(away, raster).size(), 0u);
}

TEST(AnnotationPanel, ABuildingAtTheRastersEdgeIsDrawn) {
  HouseAnswer answer = block();
  answer.frame.north_west = {140.0, 300.0};
  const HeightRaster dsm = slope();
  const cv::Mat panel = draw_annotation_panel({&answer, &dsm, 10.0, nullptr, ""});
  EXPECT_NE(at(panel, kFirst, 10.5, 30.5), at(panel, kFirst, 60.5, 30.5));
}

TEST(AnnotationPanel, TheLowHeightIsThatOfTheGroundAroundAHouse) {
  HeightRaster dsm({{90.0, 310.0}, 1.0, 60, 60}, 7.0f);
  for (int row = 15; row < 35; ++row) {
    for (int col = 15; col < 35; ++col) dsm.at(row, col) = 15.0f;
  }
  EXPECT_NEAR(low_height(dsm, frame()), 7.0, 1e-6);
}

TEST(AnnotationSheets, HoldPanelsInOrderAndTheLastOneTheRest) {
  std::vector<std::string> names;
  std::vector<cv::Mat> sheets;
  AnnotationSheets into({2, 1}, [&](const std::string& name, const cv::Mat& sheet) {
    names.push_back(name);
    sheets.push_back(sheet);
  });
  const cv::Size size = annotation_panel_size();
  for (int i = 0; i < 5; ++i) into.add(cv::Mat(size, CV_8UC3, cv::Scalar(i, i, i)));
  into.finish();
  EXPECT_EQ(names, (std::vector<std::string>{"sheet_001.png", "sheet_002.png", "sheet_003.png"}));
  EXPECT_EQ(annotation_sheet_name(4, {2, 1}), names[2]);
  EXPECT_EQ(sheets[1].size(), cv::Size(2 * size.width, size.height));
  EXPECT_EQ(sheets[1].at<cv::Vec3b>(0, 0)[0], 2);
  EXPECT_EQ(sheets[1].at<cv::Vec3b>(0, size.width)[0], 3);
  EXPECT_EQ(sheets[2].size(), size);
  EXPECT_NE(check(AnnotationSheetOptions{0, 3}), "");
  EXPECT_NE(check(AnnotationSheetOptions{2, 17}), "");
}

}  // namespace
}  // namespace gable
