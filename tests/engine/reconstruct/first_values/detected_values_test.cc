#include <gable/engine/reconstruct/first_values/azimuth.h>
#include <gable/engine/reconstruct/first_values/detected_values.h>
#include <gtest/gtest.h>

#include "engine/detectors/tiny_nets.h"
#include "engine/house_image.h"

namespace gable {
namespace {

class DetectedValuesTest : public testing::Test {
 protected:
  DetectedValuesTest() {
    write_tiny_nets(folder_);
    SceneOptions options;
    options.seed = 5;
    options.trees = 0;
    image_ = image_of(make_scene(Foundation::kL, options));
  }

  void expect_what_the_detectors_say_at(double azimuth, const DetectedValues& values,
                                        DetectorNets* nets) {
    EXPECT_EQ(values.azimuth, azimuth);
    const Detection expected = detect_house(make_house_crop(image_, azimuth), image_, nets);
    EXPECT_EQ(values.foundation, expected.foundation);
    ASSERT_EQ(values.houses.size(), expected.houses.size());
    ASSERT_FALSE(expected.houses.empty());
    for (size_t i = 0; i < expected.houses.size(); ++i) {
      EXPECT_EQ(values.houses[i].house.foundation, expected.houses[i].house.foundation);
      EXPECT_EQ(values.houses[i].house.azimuth[0], expected.houses[i].house.azimuth[0]);
      EXPECT_EQ(values.houses[i].house.origin, image_.origin);
      EXPECT_EQ(values.houses[i].log_probability, expected.houses[i].log_probability);
    }
  }

  const ScratchFolder folder_;
  HeightImage image_;
};

TEST_F(DetectedValuesTest, LooksAtTheCropTurnedByTheDetectorsAzimuth) {
  DetectorNets nets(folder_.path(""));
  const AzimuthAnswer answer = detect_azimuth(image_, &nets);
  DetectedValuesOptions options;
  options.least_confidence = 0.0;
  const DetectedValues values = detect_values(image_, &nets, options);
  EXPECT_EQ(values.azimuth_confidence, answer.confidence());
  expect_what_the_detectors_say_at(answer.angle(), values, &nets);
}

TEST_F(DetectedValuesTest, AnAzimuthOfLessConfidenceIsThatOfTheHeights) {
  DetectorNets nets(folder_.path(""));
  const AzimuthAnswer answer = detect_azimuth(image_, &nets);
  const double other = azimuth_candidates(image_, 0.1).front().azimuth;
  ASSERT_GT(std::abs(other - answer.angle()), 0.01);
  DetectedValuesOptions options;
  options.least_confidence = answer.confidence() + 0.01;
  expect_what_the_detectors_say_at(other, detect_values(image_, &nets, options), &nets);
}

TEST_F(DetectedValuesTest, CheckNamesTheViolatedBound) {
  DetectedValuesOptions options;
  EXPECT_EQ(check(options), "");
  options.least_confidence = 2.5;
  EXPECT_EQ(check(options), "least_confidence must lie in [0, 2]");
  options = {};
  options.detection.details.radius = 0;
  EXPECT_NE(check(options), "");
}

}  // namespace
}  // namespace gable
