#include <gable/engine/dataset/synthetic_samples.h>
#include <gable/engine/evaluate/detectors/detector_scores.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace gable {
namespace {

/// The shipped networks on crops of a seed that nothing was trained on.
const DetectorScores& shipped_scores() {
  static const DetectorScores scores = [] {
    DatasetOptions options;
    options.seed = 424242;
    DetectorNets nets(std::string(GABLE_SOURCE_DIR) + "/models/detectors");
    DetectorScores sum;
    for (size_t i = 0; i < 180; ++i) {
      add_score(truth_of(synthetic_sample(i, options)), &nets, &sum);
    }
    return sum;
  }();
  return scores;
}

// Bounds lie three standard deviations of 180 crops below what docs/results.md holds.

TEST(ShippedDetectors, NameTheFoundation) {
  EXPECT_GE(shipped_scores().foundation_accuracy(), 0.93);
}

TEST(ShippedDetectors, NameTheRoof) {
  ClassScore all;
  for (const ClassScore& roof : shipped_scores().roofs) {
    all.right += roof.right;
    all.all += roof.all;
  }
  EXPECT_GE(all.share(), 0.93);
}

TEST(ShippedDetectors, OutlineEveryFoundation) {
  for (const MeanScore& iou : shipped_scores().foundation_iou) EXPECT_GE(iou.mean(), 0.87);
}

TEST(ShippedDetectors, FindDormersAndChimneysAndGarages) {
  EXPECT_GE(shipped_scores().dormers.recall(), 0.6);
  EXPECT_GE(shipped_scores().dormers.precision(), 0.6);
  EXPECT_GE(shipped_scores().chimneys.recall(), 0.65);
  EXPECT_GE(shipped_scores().chimneys.precision(), 0.65);
  EXPECT_GE(shipped_scores().garage_iou.mean(), 0.7);
}

TEST(ShippedDetectors, TellTheAzimuthToADegree) {
  EXPECT_LT(shipped_scores().median_azimuth_error(), M_PI / 180.0);
}

}  // namespace
}  // namespace gable
