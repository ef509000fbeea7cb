#include <gable/engine/drawing/canvas.h>
#include <gable/engine/scales/report/shape_colors.h>
#include <gable/engine/scales/report/trajectory_strip.h>
#include <gtest/gtest.h>

#include <vector>

#include "engine/scales/report/sample_trajectory.h"

namespace gable {
namespace {

TEST(ShapeNumberAxis, GoesFromTheFirstConfigurationToTheLast) {
  const SampleTrajectory sample(200);
  const ShapeNumberAxis axis(sample.trajectory, 1000);
  EXPECT_NEAR(axis.position(0), 0.0, 1e-9);
  EXPECT_NEAR(axis.position(200), 1000.0, 1e-9);
  EXPECT_EQ(axis.configuration(0), 0);
  EXPECT_EQ(axis.configuration(999), 199);
  for (int i = 0; i < 200; ++i) EXPECT_LT(axis.position(i), axis.position(i + 1));
}

TEST(ShapeNumberAxis, ShowsAConfigurationBetweenItsBeginningAndTheNext) {
  const SampleTrajectory sample(200);
  const ShapeNumberAxis axis(sample.trajectory, 1000);
  for (int column = 0; column < 1000; ++column) {
    const int configuration = axis.configuration(column);
    EXPECT_LE(axis.position(configuration), column + 0.5 + 1e-9);
    EXPECT_GE(axis.position(configuration + 1), column + 0.5 - 1e-9);
  }
}

TEST(TrajectoryStrip, ChangesColourAtItsMarks) {
  const SampleTrajectory sample(200);
  const TrajectoryStrip drawn = draw_trajectory_strip(sample.trajectory, sample.labels, 900);
  EXPECT_EQ(drawn.image.cols, 900);
  ASSERT_EQ(drawn.marks.size(), 3u);
  const int row = drawn.strip.y + drawn.strip.height / 2;
  const auto color_at = [&](int column) { return drawn.image.at<cv::Vec3b>(row, column); };
  for (int scale = 1; scale <= 3; ++scale) {
    const int mark = drawn.marks[scale - 1];
    EXPECT_EQ(color_at(mark - 2), bgr(label_color(scale - 1))) << scale;
    EXPECT_EQ(color_at(mark), bgr(kInkColor)) << scale;
    EXPECT_EQ(color_at(mark + 2), bgr(label_color(scale))) << scale;
  }
  const ShapeNumberAxis axis(sample.trajectory, drawn.strip.width);
  for (int scale = 1; scale <= 3; ++scale) {
    EXPECT_NEAR(drawn.marks[scale - 1] - drawn.strip.x,
                axis.position(sample.labels.first[scale - 1]), 0.51);
  }
}

TEST(TrajectoryStrip, IsTheSameTwice) {
  const SampleTrajectory sample(100);
  const cv::Mat image = draw_trajectory_strip(sample.trajectory, sample.labels).image;
  const cv::Mat again = draw_trajectory_strip(sample.trajectory, sample.labels).image;
  EXPECT_EQ(cv::norm(image, again, cv::NORM_INF), 0.0);
}

/// The lowest dark pixel of a column above the strip; 0 if there is none.
int curve_row(const TrajectoryStrip& drawn, int column) {
  for (int row = drawn.strip.y - 1; row > 0; --row) {
    const cv::Vec3b p = drawn.image.at<cv::Vec3b>(row, column);
    if (p[0] < 160 && p[1] < 160 && p[2] < 160) return row;
  }
  return 0;
}

TEST(TrajectoryStrip, ItsCurveRisesWithTheWeights) {
  SampleTrajectory sample(100);
  sample.labels.first.clear();
  const auto drawn = draw_trajectory_strip(sample.trajectory, sample.labels, 900);
  const int middle = drawn.strip.x + drawn.strip.width / 2;
  const int early = curve_row(drawn, middle - 150), late = curve_row(drawn, middle + 150);
  EXPECT_GT(late, 0);
  EXPECT_GT(early, late + 5);
  for (Merge& merge : sample.trajectory.merges) merge.weight = 0.02;
  const auto flat = draw_trajectory_strip(sample.trajectory, sample.labels, 900);
  EXPECT_EQ(curve_row(flat, middle - 150), curve_row(flat, middle + 150));
}

TEST(TrajectoryStrip, TakesTrajectoriesWithoutMergesWeightsOrScales) {
  Trajectory one;
  one.num_first = 1;
  ScaleLabels labels{.first = {0, 0, 1}, .num_configurations = 1};
  const TrajectoryStrip drawn = draw_trajectory_strip(one, labels, 400);
  ASSERT_EQ(drawn.marks.size(), 3u);
  EXPECT_EQ(drawn.marks[0], drawn.strip.x);
  EXPECT_EQ(drawn.marks[1], drawn.strip.x);
  EXPECT_EQ(drawn.marks[2], drawn.strip.x + drawn.strip.width);

  SampleTrajectory exact(20);
  for (Merge& merge : exact.trajectory.merges) merge.weight = 0.0;
  exact.labels.first.clear();
  EXPECT_TRUE(draw_trajectory_strip(exact.trajectory, exact.labels).marks.empty());
}

}  // namespace
}  // namespace gable
