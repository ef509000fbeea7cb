#include <gable/engine/evaluate/detections.h>
#include <gtest/gtest.h>

namespace gable {
namespace {

TEST(ScoreDetections, FaintOnesMayBeFoundButNeedNot) {
  const std::vector<Eigen::Vector2d> truth = {{0.0, 0.0}}, faint = {{10.0, 0.0}, {20.0, 0.0}};
  const DetectionScore score =
      score_detections({{0.5, 0.0}, {10.5, 0.0}, {30.0, 0.0}}, truth, 2.0, faint);
  EXPECT_EQ(score.truth, 1);
  EXPECT_EQ(score.correct, 1);
  EXPECT_EQ(score.found, 2);  // the right one and the one that is nowhere near
}

TEST(ScoreDetections, AFaintOneForgivesOneDetection) {
  const DetectionScore score = score_detections({{9.0, 0.0}, {11.0, 0.0}}, {}, 2.0, {{10.0, 0.0}});
  EXPECT_EQ(score.found, 1);
}

}  // namespace
}  // namespace gable
