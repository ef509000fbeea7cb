#include <gable/engine/evaluate/detectors/detector_scores.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace gable {
namespace {

using ::testing::HasSubstr;

TEST(DetectorScores, AccuracyIsTheShareOnTheDiagonal) {
  DetectorScores scores;
  EXPECT_EQ(scores.foundation_accuracy(), 0.0);
  scores.confusion[0][0] = 6;
  scores.confusion[1][0] = 1;
  scores.confusion[5][5] = 3;
  EXPECT_EQ(scores.houses(), 10);
  EXPECT_DOUBLE_EQ(scores.foundation_accuracy(), 0.9);
}

TEST(DetectorScores, SumsCountEveryBuildingOnce) {
  DetectorScores a, b;
  a.confusion[0][1] = 2;
  b.confusion[0][1] = 3;
  a.roofs[1] = {1, 2};
  b.roofs[1] = {3, 4};
  a.foundation_iou[2].add(0.5);
  b.foundation_iou[2].add(1.0);
  a.dormers = {4, 5, 3};
  b.dormers = {1, 1, 1};
  a.azimuth_errors = {0.1};
  b.azimuth_errors = {0.2, 0.3};
  a += b;
  EXPECT_EQ(a.confusion[0][1], 5);
  EXPECT_EQ(a.roofs[1].right, 4);
  EXPECT_EQ(a.roofs[1].all, 6);
  EXPECT_DOUBLE_EQ(a.foundation_iou[2].mean(), 0.75);
  EXPECT_EQ(a.dormers.truth, 5);
  EXPECT_EQ(a.dormers.correct, 4);
  EXPECT_DOUBLE_EQ(a.median_azimuth_error(), 0.2);
}

TEST(ScoreTable, ShowsThePapersFiguresBesideThoseOfEveryColumn) {
  DetectorScores scores;
  scores.confusion[3][3] = 3;
  scores.confusion[3][0] = 1;
  scores.roofs[1] = {9, 10};
  scores.dormers = {4, 5, 3};
  const ScoreColumn columns[] = {{"here", &scores}, {"there", &scores}};
  const std::string text = score_table(columns);
  EXPECT_THAT(
      text, HasSubstr("foundation type                   89.2 %          75.0 %          75.0 %"));
  EXPECT_THAT(text, HasSubstr("roof type, L                      89.7 %          90.0 %"));
  EXPECT_THAT(text, HasSubstr("77 %, 84 %      60.0 %, 75.0 %"));
  EXPECT_THAT(text, HasSubstr("roof type, U                      66.0 %          -"));
  EXPECT_THAT(text, HasSubstr("L     0.250  0.000  0.000  0.750"));
}

}  // namespace
}  // namespace gable
