#include <gable/engine/detectors/detect_house.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/detectors/drawn_maps.h"
#include "engine/detectors/tiny_nets.h"

namespace gable {
namespace {

class DetectHouse : public testing::Test {
 protected:
  DetectHouse() { write_tiny_nets(scratch_); }
  ScratchFolder scratch_;
};

// The tiny networks know nothing of houses: what they say only has to arrive.
TEST_F(DetectHouse, MakesAHouseOfEveryHypothesisWithTheMostProbableRoofs) {
  DetectorNets nets(scratch_.path(""));
  const DrawnHouse drawn(Foundation::kII, 7, DrawnHouse::bare());
  const Detection detection = detect_house(drawn.crop, drawn.image, &nets);
  const CropAnswer answer = nets.look(drawn.crop);
  EXPECT_EQ(detection.foundation, answer.foundation);
  const auto foundations = foundation_hypotheses(drawn.crop, answer);
  ASSERT_EQ(detection.houses.size(), foundations.size());
  ASSERT_GE(foundations.size(), 3u);
  for (size_t i = 0; i < foundations.size(); ++i) {
    const HouseHypothesis& hypothesis = detection.houses[i];
    EXPECT_TRUE(is_well_formed(hypothesis.house));
    EXPECT_EQ(hypothesis.house.foundation, foundations[i].foundation);
    EXPECT_EQ(hypothesis.iou, foundations[i].iou);
    double expected = foundations[i].log_probability;
    const bool polygon =
        hypothesis.house.footprints.size() == 1 && hypothesis.house.foundation != Foundation::kI;
    std::vector<CropBits> parts;
    if (polygon) parts.push_back(foundations[i].bits());
    for (const CropRectangle& r : foundations[i].rectangles) {
      if (!polygon) parts.push_back(bits_of(r));
    }
    for (size_t part = 0; part < parts.size(); ++part) {
      const auto types = nets.roof(drawn.crop, parts[part]).of(foundations[i].foundation);
      const auto best = std::max_element(types.begin(), types.end());
      expected += std::log(*best);
      const RuleKind kinds[] = {RuleKind::kRoofFlat, RuleKind::kRoofGable, RuleKind::kRoofHip};
      EXPECT_EQ(hypothesis.house.roofs[part].kind, kinds[best - types.begin()]);
    }
    EXPECT_NEAR(hypothesis.log_probability, expected, 1e-4);
  }
}

TEST_F(DetectHouse, SaysNothingWhereThereIsNoBuilding) {
  DetectorNets nets(scratch_.path(""));
  const DrawnHouse drawn(Foundation::kI, 7, DrawnHouse::bare());
  EXPECT_TRUE(detect_house(HouseCrop(), drawn.image, &nets).houses.empty());
}

TEST_F(DetectHouse, TheAzimuthIsThatOfTheCropThatIsNotTurned) {
  DetectorNets nets(scratch_.path(""));
  const DrawnHouse drawn(Foundation::kL, 7, DrawnHouse::bare());
  const AzimuthAnswer answer = detect_azimuth(drawn.image, &nets);
  EXPECT_EQ(answer.bins, nets.azimuth(make_house_crop(drawn.image, 0.0)).bins);
  EXPECT_GE(answer.angle(), 0.0);
  EXPECT_LT(answer.angle(), 0.5 * M_PI);
}

}  // namespace
}  // namespace gable
