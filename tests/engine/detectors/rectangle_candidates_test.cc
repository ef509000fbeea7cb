#include <gable/engine/detectors/rectangle_candidates.h>
#include <gtest/gtest.h>

#include <set>
#include <utility>

#include "engine/detectors/drawn_maps.h"

namespace gable {
namespace {

constexpr int kHouses = 40;
constexpr Foundation kTypes[] = {Foundation::kI, Foundation::kII, Foundation::kIII};

std::vector<CropFoundation> best_sets(const DrawnHouse& drawn,
                                      const std::vector<CropCorner>& corners) {
  const CropBits mask = mask_bits(drawn.crop);
  return rectangle_sets(rectangle_candidates(drawn_peaks(drawn, corners), mask),
                        drawn.house.num_components(), mask);
}

TEST(RectangleCandidates, IdealCornersGiveTheTrueRectangles) {
  for (const Foundation type : kTypes) {
    double least = 1.0;
    for (uint64_t seed = 0; seed < kHouses; ++seed) {
      const DrawnHouse drawn(type, seed, DrawnHouse::bare());
      const std::vector<CropFoundation> best = best_sets(drawn, drawn.corners);
      ASSERT_FALSE(best.empty()) << seed;
      EXPECT_EQ(best[0].foundation, type);
      least = std::min(least, iou_with_truth(best[0].rectangles, drawn));
    }
    EXPECT_GE(least, 0.97) << foundation_name(type);
  }
}

TEST(RectangleCandidates, AMissingCornerOfEveryRectangleIsInferred) {
  for (const Foundation type : kTypes) {
    double least = 1.0;
    for (uint64_t seed = 0; seed < kHouses; ++seed) {
      const DrawnHouse drawn(type, seed, DrawnHouse::bare());
      std::vector<int> missing;
      for (int i = 0; i < drawn.house.num_components(); ++i) {
        missing.push_back(4 * i + static_cast<int>(seed + i) % 4);
      }
      const std::vector<CropFoundation> best = best_sets(drawn, without(drawn.corners, missing));
      ASSERT_FALSE(best.empty()) << seed;
      least = std::min(least, iou_with_truth(best[0].rectangles, drawn));
    }
    EXPECT_GE(least, 0.97) << foundation_name(type);
  }
}

// Three corners each of four wrong rectangles beside the right one.
TEST(RectangleCandidates, CornersOfOtherThingsAreOutdoneByTheMask) {
  for (uint64_t seed = 0; seed < kHouses; ++seed) {
    const DrawnHouse drawn(Foundation::kI, seed, DrawnHouse::bare());
    CornerPeaks peaks = drawn_peaks(drawn, drawn.corners);
    Random random(seed);
    for (int i = 0; i < 16; ++i) {
      Peak peak;
      peak.crop = {random.uniform(2.0, 62.0), random.uniform(2.0, 62.0)};
      peak.value = random.uniform(0.5, 1.0);
      peaks[i % 4].push_back(peak);
    }
    const CropBits mask = mask_bits(drawn.crop);
    const auto best = rectangle_sets(rectangle_candidates(peaks, mask), 1, mask);
    ASSERT_FALSE(best.empty());
    EXPECT_GE(iou_with_truth(best[0].rectangles, drawn), 0.97) << seed;
  }
}

TEST(RectangleCandidates, TwoCornersOfOneEdgeAreEnoughWithTheMask) {
  for (uint64_t seed = 0; seed < 12; ++seed) {
    const DrawnHouse drawn(Foundation::kI, seed, DrawnHouse::bare());
    const std::vector<std::vector<int>> missing = {{0, 1}, {0, 2}, {1, 3}, {2, 3}, {0, 3}, {1, 2}};
    const auto best = best_sets(drawn, without(drawn.corners, missing[seed % 6]));
    ASSERT_FALSE(best.empty());
    EXPECT_GE(iou_with_truth(best[0].rectangles, drawn), 0.95) << seed;
    EXPECT_NEAR(best[0].corners, 0.5, 0.05);
  }
}

TEST(RectangleCandidates, WithoutCornersAnIIsTheMasksBounds) {
  CropBits mask;
  for (int row = 10; row < 31; ++row) mask.set_row(row, 7, 40);
  const auto best = rectangle_sets(rectangle_candidates({}, mask), 1, mask);
  ASSERT_EQ(best.size(), 1u);
  EXPECT_EQ(best[0].iou, 1.0);
  EXPECT_EQ(best[0].corners, 0.0);
  const CropRectangle r = best[0].rectangles[0];
  EXPECT_EQ(Eigen::Vector4d(r.x0, r.x1, r.y0, r.y1), Eigen::Vector4d(7.0, 40.0, 10.0, 31.0));
  EXPECT_TRUE(rectangle_sets(rectangle_candidates({}, CropBits()), 1, CropBits()).empty());
  EXPECT_TRUE(rectangle_sets(rectangle_candidates({}, mask), 2, mask).empty());
}

TEST(RectangleCandidates, EveryRectangleOfASetStandsForItselfAndHangsTogetherWithAnother) {
  CropBits mask;
  for (int row = 10; row < 30; ++row) mask.set_row(row, 5, 60);
  const std::vector<RectangleCandidate> candidates = {
      {{5, 30, 10, 30}}, {{32, 60, 10, 30}}, {{5, 29, 10, 30}}, {{40, 60, 10, 30}}};
  const auto near = rectangle_sets(candidates, 2, mask);
  ASSERT_EQ(near.size(), 1u);  // over a gap of 2; all others are nested or too far apart
  EXPECT_EQ(near[0].rectangles[0].x0, 32.0);
  EXPECT_EQ(near[0].rectangles[1].x1, 30.0);
}

// The best pair by a plain search over all pairs and pixels.
TEST(RectangleCandidates, TheBestPairIsThatOfAPlainSearch) {
  Random random(17);
  for (int round = 0; round < 20; ++round) {
    std::vector<RectangleCandidate> candidates;
    for (int i = 0; i < 12; ++i) {
      const double x = random.uniform(0.0, 40.0), y = random.uniform(0.0, 40.0);
      RectangleCandidate candidate;
      candidate.rectangle = {x, x + random.uniform(6.0, 24.0), y, y + random.uniform(6.0, 24.0)};
      for (int type = 0; type < 4; ++type) {
        candidate.peaks[type] = random.integer(-1, 4);
        if (candidate.peaks[type] >= 0) candidate.values[type] = 0.2 * candidate.peaks[type] + 0.1;
      }
      candidates.push_back(candidate);
    }
    CropBits mask;
    for (int row = 12; row < 50; ++row) mask.set_row(row, 8, row < 30 ? 52 : 30);
    RectangleSetOptions options;
    options.own_share = 0.0;
    options.gap = 64.0;
    options.candidates.at_most = 1;
    const auto best = rectangle_sets(candidates, 2, mask, options);
    double expected = 0.0;
    for (size_t a = 0; a < candidates.size(); ++a) {
      for (size_t b = a + 1; b < candidates.size(); ++b) {
        int both = 0, either = 0;
        for (int row = 0; row < kCropSize; ++row) {
          for (int col = 0; col < kCropSize; ++col) {
            const auto in = [&](const CropRectangle& r) {
              return col + 0.5 >= r.x0 && col + 0.5 < r.x1 && row + 0.5 >= r.y0 && row + 0.5 < r.y1;
            };
            const bool covered = in(candidates[a].rectangle) || in(candidates[b].rectangle);
            both += covered && mask.at(row, col);
            either += covered || mask.at(row, col);
          }
        }
        std::set<std::pair<int, int>> peaks;  // of either, by type and number
        for (int type = 0; type < 4; ++type) {
          peaks.insert({type, candidates[a].peaks[type]});
          peaks.insert({type, candidates[b].peaks[type]});
        }
        double corners = 0.0;
        for (const auto& [type, peak] : peaks) corners += peak >= 0 ? 0.2 * peak + 0.1 : 0.0;
        expected = std::max(expected, static_cast<double>(both) / either + corners / 8.0);
      }
    }
    ASSERT_EQ(best.size(), 1u);
    EXPECT_NEAR(candidate_score(best[0], options.candidates), expected, 1e-12);
  }
}

TEST(RectangleCandidates, OptionsOutOfRangeAreNamed) {
  RectangleSetOptions options;
  EXPECT_EQ(check(options), "");
  options.singles = 2;
  EXPECT_EQ(check(options), "singles must be in [3, 200]");
  options = {};
  options.own_share = 1.5;
  EXPECT_EQ(check(options), "own_share must be in [0, 1]");
  options = {};
  options.candidates.agreement = 0.0;
  EXPECT_EQ(check(options), "agreement must be in [0.1, 64]");
}

}  // namespace
}  // namespace gable
