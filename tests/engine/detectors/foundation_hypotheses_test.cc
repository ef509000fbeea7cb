#include <gable/engine/detectors/foundation_hypotheses.h>
#include <gtest/gtest.h>

#include <cmath>

#include "engine/detectors/drawn_maps.h"

namespace gable {
namespace {

constexpr Foundation kTypes[] = {Foundation::kI, Foundation::kII, Foundation::kIII, Foundation::kL,
                                 Foundation::kU};

double worth(const CropFoundation& f) { return f.log_probability + 5.0 * (f.iou + f.corners); }

// Fills the garage map with the blocks of garages.
void draw_garages(const DrawnHouse& drawn, CropAnswer* answer) {
  const HeightField field(drawn.house);
  const double c = std::cos(drawn.crop.azimuth), s = std::sin(drawn.crop.azimuth);
  for (int row = 0; row < kCropSize; ++row) {
    for (int col = 0; col < kCropSize; ++col) {
      const Eigen::Vector2d p = drawn.crop.house_from_crop({col + 0.5, row + 0.5});
      const Eigen::Vector2d local(c * p.x() - s * p.y(), s * p.x() + c * p.y());
      const int block = field.block_at_house(field.house_from_local(local));
      if (block < 0 || field.sources()[block].role != BlockRole::kGarage) continue;
      answer->maps[(crop_map::kGarages * kCropSize + row) * kCropSize + col] = 0.9f;
    }
  }
}

TEST(FoundationHypotheses, TheBestIsTheTruthEvenBesideGarages) {
  PriorOptions prior = DrawnHouse::bare();
  prior.garage_share = 1.0;
  for (const Foundation type : kTypes) {
    double sum = 0.0;
    for (uint64_t seed = 0; seed < 30; ++seed) {
      const DrawnHouse drawn(type, seed, prior);
      CropAnswer answer = ideal_answer(drawn, drawn.corners);
      draw_garages(drawn, &answer);
      const auto hypotheses = foundation_hypotheses(drawn.crop, answer);
      ASSERT_FALSE(hypotheses.empty());
      EXPECT_EQ(hypotheses[0].foundation, type);
      const double iou = iou_with_truth(hypotheses[0].rectangles, drawn);
      EXPECT_GE(iou, 0.97) << foundation_name(type) << " " << seed;
      EXPECT_NEAR(hypotheses[0].log_probability, std::log(0.95), 1e-6);
      sum += iou / 30;
    }
    EXPECT_GE(sum, 0.99) << foundation_name(type);
  }
}

TEST(FoundationHypotheses, AreSortedByProbabilityAndScoreAndNoMoreThanAskedFor) {
  FoundationOptions options;
  options.per_foundation = 2;
  options.at_most = 5;
  for (uint64_t seed = 0; seed < 10; ++seed) {
    const DrawnHouse drawn(Foundation::kII, seed, DrawnHouse::bare());
    CropAnswer answer = ideal_answer(drawn, drawn.corners);
    answer.foundation = {0.2f, 0.3f, 0.2f, 0.15f, 0.1f, 0.05f};
    const auto hypotheses = foundation_hypotheses(drawn.crop, answer, options);
    EXPECT_GE(hypotheses.size(), 3u);
    EXPECT_LE(hypotheses.size(), 5u);
    std::array<int, kNumFoundations> of_type{};
    for (size_t i = 0; i < hypotheses.size(); ++i) {
      ++of_type[static_cast<size_t>(hypotheses[i].foundation)];
      if (i > 0) {
        EXPECT_GE(worth(hypotheses[i - 1]), worth(hypotheses[i]));
      }
    }
    for (const int count : of_type) EXPECT_LE(count, 2);
  }
}

TEST(FoundationHypotheses, ImprobableTypesAreLeftOutAndCAlways) {
  const DrawnHouse drawn(Foundation::kL, 3, DrawnHouse::bare());
  CropAnswer answer = ideal_answer(drawn, drawn.corners);
  answer.foundation = {0.002f, 0.002f, 0.002f, 0.004f, 0.0f, 0.99f};
  for (const CropFoundation& f : foundation_hypotheses(drawn.crop, answer)) {
    EXPECT_EQ(f.foundation, Foundation::kL);
    EXPECT_NEAR(f.log_probability, std::log(0.004), 1e-5);
  }
}

TEST(FoundationHypotheses, WithoutAnyCornersThereIsAnAnswerOfEveryMask) {
  for (const Foundation type : kTypes) {
    const DrawnHouse drawn(type, 4, DrawnHouse::bare());
    const auto hypotheses = foundation_hypotheses(drawn.crop, ideal_answer(drawn, {}));
    ASSERT_FALSE(hypotheses.empty()) << foundation_name(type);
    EXPECT_GT(iou_with_truth(hypotheses[0].rectangles, drawn), 0.5) << foundation_name(type);
  }
  HouseCrop empty;
  DrawnHouse drawn(Foundation::kI, 4, DrawnHouse::bare());
  EXPECT_TRUE(foundation_hypotheses(empty, ideal_answer(drawn, drawn.corners)).empty());
}

TEST(FoundationHypotheses, AGarageMapThatCoversTheHouseIsNotBelieved) {
  const DrawnHouse drawn(Foundation::kI, 5, DrawnHouse::bare());
  CropAnswer answer = ideal_answer(drawn, drawn.corners);
  std::fill(answer.maps.end() - kCropPixels, answer.maps.end(), 1.0f);
  const auto hypotheses = foundation_hypotheses(drawn.crop, answer);
  ASSERT_FALSE(hypotheses.empty());
  EXPECT_GE(iou_with_truth(hypotheses[0].rectangles, drawn), 0.97);
}

TEST(FoundationHypotheses, OptionsOutOfRangeAreNamed) {
  FoundationOptions options;
  EXPECT_EQ(check(options), "");
  options.least_probability = 2.0;
  EXPECT_EQ(check(options), "least_probability must be in [0, 1]");
  options = {};
  options.sets.singles = 1;
  EXPECT_EQ(check(options), "singles must be in [3, 200]");
}

}  // namespace
}  // namespace gable
