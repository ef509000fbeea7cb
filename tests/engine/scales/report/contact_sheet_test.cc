#include <gable/engine/drawing/canvas.h>
#include <gable/engine/scales/report/contact_sheet.h>
#include <gable/engine/scales/report/shape_colors.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "engine/scales/report/sample_trajectory.h"

namespace gable {
namespace {

TEST(SheetConfigurations, FillTheSheetFromFirstToLastAndHoldEveryBeginning) {
  const SampleTrajectory sample(2000);
  const std::vector<int> shown = sheet_configurations(sample.trajectory, sample.labels, {});
  EXPECT_GE(shown.size(), 22u);
  EXPECT_LE(shown.size(), 24u);
  EXPECT_EQ(shown.front(), 0);
  EXPECT_EQ(shown.back(), 1999);
  EXPECT_TRUE(std::is_sorted(shown.begin(), shown.end()));
  for (const int first : sample.labels.first) EXPECT_THAT(shown, testing::Contains(first));
}

TEST(SheetConfigurations, AreDenserAtTheCoarseEnd) {
  const SampleTrajectory sample(2000);
  ScaleLabels none;
  const std::vector<int> shown = sheet_configurations(sample.trajectory, none, {});
  for (size_t i = 2; i < shown.size(); ++i) {
    EXPECT_LE(shown[i] - shown[i - 1], shown[i - 1] - shown[i - 2]);
    const double ratio = static_cast<double>(sample.trajectory.num_shapes(shown[i])) /
                         sample.trajectory.num_shapes(shown[i - 1]);
    if (sample.trajectory.num_shapes(shown[i]) > 20) {
      EXPECT_GT(ratio, 0.4);
    }
  }
}

TEST(SheetConfigurations, StayWithinThePartAskedFor) {
  const SampleTrajectory sample(500);
  const ContactSheetOptions part{.first_configuration = 440, .last_configuration = 452};
  const std::vector<int> shown = sheet_configurations(sample.trajectory, sample.labels, part);
  EXPECT_EQ(shown.size(), 13u);
  EXPECT_EQ(shown.front(), 440);
  EXPECT_EQ(shown.back(), 452);
  const SampleTrajectory tiny(4);
  EXPECT_EQ(sheet_configurations(tiny.trajectory, ScaleLabels{}, {}).size(), 4u);
}

TEST(ContactSheet, HasAThumbnailPerConfigurationUnderlinedByItsLabel) {
  const SampleTrajectory sample(64);
  const ContactSheetOptions options{
      .columns = 4, .rows = 3, .thumbnail_width = 120, .thumbnail_height = 80};
  const std::vector<int> shown = sheet_configurations(sample.trajectory, sample.labels, options);
  const cv::Mat sheet = draw_contact_sheet(sample.scan, sample.first_shapes, sample.trajectory,
                                           sample.labels, "sample", options);
  const std::vector<int> labels = sample.labels.labels();
  // Underlines: long runs of a label's colour, one a thumbnail.
  std::vector<int> runs(5, 0), expected(5, 0);
  for (const int configuration : shown) ++expected[labels[configuration]];
  for (int label = 0; label <= 3; ++label) {
    const cv::Vec3b color = bgr(label_color(label));
    for (int row = 3; row < sheet.rows; ++row) {
      int length = 0;
      for (int col = 0; col < sheet.cols; ++col) {
        length = sheet.at<cv::Vec3b>(row, col) == color ? length + 1 : 0;
        const bool begins = length == 120 && sheet.at<cv::Vec3b>(row - 1, col - 60) != color;
        if (begins) ++runs[label];
      }
    }
  }
  EXPECT_EQ(runs[0], expected[0]);
  for (int label = 1; label <= 3; ++label) {
    EXPECT_EQ(runs[label], expected[label] + 1) << "one frame has a top edge as well " << label;
  }
}

TEST(ContactSheet, IsTheSameTwiceAndMarksNothingWithoutScales) {
  const SampleTrajectory sample(40);
  const auto draw = [&](const ScaleLabels& labels) {
    return draw_contact_sheet(
        sample.scan, sample.first_shapes, sample.trajectory, labels, "a",
        {.columns = 3, .rows = 2, .thumbnail_width = 96, .thumbnail_height = 64});
  };
  EXPECT_EQ(cv::norm(draw(sample.labels), draw(sample.labels), cv::NORM_INF), 0.0);
  const cv::Mat unmarked = draw({});
  for (int label = 1; label <= 3; ++label) {
    cv::Mat at;
    cv::inRange(unmarked, scalar(label_color(label)), scalar(label_color(label)), at);
    EXPECT_LT(cv::countNonZero(at), 20) << label;
  }
}

TEST(ContactSheetOptions, CheckNamesTheViolatedBound) {
  using testing::HasSubstr;
  EXPECT_EQ(check(ContactSheetOptions{}), "");
  EXPECT_THAT(check(ContactSheetOptions{.columns = 0}), HasSubstr("columns"));
  EXPECT_THAT(check(ContactSheetOptions{.rows = 65}), HasSubstr("rows"));
  EXPECT_THAT(check(ContactSheetOptions{.thumbnail_width = 63}), HasSubstr("thumbnail_width"));
  EXPECT_THAT(check(ContactSheetOptions{.thumbnail_height = 0}), HasSubstr("thumbnail_height"));
  EXPECT_THAT(check(ContactSheetOptions{.first_configuration = -1}),
              HasSubstr("first_configuration"));
  EXPECT_THAT(check(ContactSheetOptions{.first_configuration = 5, .last_configuration = 4}),
              HasSubstr("last_configuration"));
}

}  // namespace
}  // namespace gable
