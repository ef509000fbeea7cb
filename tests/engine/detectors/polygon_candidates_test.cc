#include <gable/engine/detectors/polygon_candidates.h>
#include <gable/grammar/wing_polygons.h>
#include <gtest/gtest.h>

#include "engine/detectors/drawn_maps.h"

namespace gable {
namespace {

constexpr int kHouses = 40;
constexpr Foundation kTypes[] = {Foundation::kL, Foundation::kU};

std::vector<CropFoundation> best_polygons(const DrawnHouse& drawn,
                                          const std::vector<CropCorner>& corners) {
  const CropBits mask = mask_bits(drawn.crop);
  const CornerPeaks peaks = drawn_peaks(drawn, corners);
  return drawn.house.foundation == Foundation::kL ? l_candidates(peaks, mask)
                                                  : u_candidates(peaks, mask);
}

TEST(PolygonCandidates, IdealCornersGiveTheTruePolygon) {
  for (const Foundation type : kTypes) {
    for (uint64_t seed = 0; seed < kHouses; ++seed) {
      const DrawnHouse drawn(type, seed, DrawnHouse::bare());
      const std::vector<CropFoundation> best = best_polygons(drawn, drawn.corners);
      ASSERT_FALSE(best.empty());
      EXPECT_EQ(best[0].foundation, type);
      EXPECT_GE(iou_with_truth(best[0].rectangles, drawn), 0.97)
          << foundation_name(type) << " " << seed << " " << best[0].iou << " " << best[0].corners;
      EXPECT_GT(best[0].corners, 0.85);
    }
  }
}

TEST(PolygonCandidates, AnyCornerMayBeMissing) {
  for (const Foundation type : kTypes) {
    const int corners = type == Foundation::kL ? 6 : 8;
    for (int missing = 0; missing < corners; ++missing) {
      for (uint64_t seed = 0; seed < 8; ++seed) {
        const DrawnHouse drawn(type, seed, DrawnHouse::bare());
        const auto best = best_polygons(drawn, without(drawn.corners, {missing}));
        ASSERT_FALSE(best.empty());
        EXPECT_GE(iou_with_truth(best[0].rectangles, drawn), 0.97)
            << foundation_name(type) << " " << seed << " without " << missing;
      }
    }
  }
}

TEST(PolygonCandidates, TwoCornersApartMayBeMissing) {
  for (const Foundation type : kTypes) {
    const int corners = type == Foundation::kL ? 6 : 8;
    for (uint64_t seed = 0; seed < kHouses; ++seed) {
      const DrawnHouse drawn(type, seed, DrawnHouse::bare());
      const int first = static_cast<int>(seed) % (corners - 2);
      const auto best = best_polygons(drawn, without(drawn.corners, {first, first + 2}));
      ASSERT_FALSE(best.empty());
      EXPECT_GE(iou_with_truth(best[0].rectangles, drawn), 0.97)
          << foundation_name(type) << " " << seed;
    }
  }
}

TEST(PolygonCandidates, CornersOffByAPixelAreAveraged) {
  for (const Foundation type : kTypes) {
    double sum = 0.0;
    for (uint64_t seed = 0; seed < kHouses; ++seed) {
      const DrawnHouse drawn(type, seed, DrawnHouse::bare());
      Random random(seed);
      std::vector<CropCorner> corners = drawn.corners;
      for (CropCorner& corner : corners) {
        corner.crop += Eigen::Vector2d(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0));
      }
      const auto best = best_polygons(drawn, corners);
      ASSERT_FALSE(best.empty());
      const double iou = iou_with_truth(best[0].rectangles, drawn);
      EXPECT_GE(iou, 0.85) << foundation_name(type) << " " << seed;
      sum += iou / kHouses;
    }
    EXPECT_GE(sum, 0.93) << foundation_name(type);
  }
}

TEST(PolygonCandidates, CornersOfOtherThingsAreOutdoneByTheMask) {
  for (const Foundation type : kTypes) {
    for (uint64_t seed = 0; seed < 20; ++seed) {
      const DrawnHouse drawn(type, seed, DrawnHouse::bare());
      CornerPeaks peaks = drawn_peaks(drawn, drawn.corners);
      Random random(seed);
      for (int i = 0; i < 12; ++i) {
        Peak peak;
        peak.crop = {random.uniform(2.0, 62.0), random.uniform(2.0, 62.0)};
        peak.value = random.uniform(0.5, 1.0);
        peaks[i % 4].push_back(peak);
      }
      const CropBits mask = mask_bits(drawn.crop);
      const auto best =
          type == Foundation::kL ? l_candidates(peaks, mask) : u_candidates(peaks, mask);
      ASSERT_FALSE(best.empty());
      EXPECT_GE(iou_with_truth(best[0].rectangles, drawn), 0.97)
          << foundation_name(type) << " " << seed;
    }
  }
}

// The rectangles and the side are what grammar/wing_polygons.h takes.
TEST(PolygonCandidates, RectanglesShareTheOuterCornersAndTheSideNamesThem) {
  for (const Foundation type : kTypes) {
    for (uint64_t seed = 0; seed < kHouses; ++seed) {
      const DrawnHouse drawn(type, seed, DrawnHouse::bare());
      for (const CropFoundation& found : best_polygons(drawn, drawn.corners)) {
        CropRectangle box = found.rectangles[0];
        for (const CropRectangle& r : found.rectangles) {
          box = {std::min(box.x0, r.x0), std::max(box.x1, r.x1), std::min(box.y0, r.y0),
                 std::max(box.y1, r.y1)};
        }
        const auto same_side = [&](const CropRectangle& r, const Eigen::Vector2d& side) {
          return (side.x() == 0.0 || (side.x() < 0.0 ? r.x0 == box.x0 : r.x1 == box.x1)) &&
                 (side.y() == 0.0 || (side.y() < 0.0 ? r.y1 == box.y1 : r.y0 == box.y0));
        };
        if (type == Foundation::kL) {
          ASSERT_EQ(found.rectangles.size(), 2u);
          for (const CropRectangle& r : found.rectangles) EXPECT_TRUE(same_side(r, found.side));
          EXPECT_EQ(found.rectangles[0].width(), box.width());
          EXPECT_EQ(found.rectangles[1].height(), box.height());
        } else {
          ASSERT_EQ(found.rectangles.size(), 3u);
          EXPECT_EQ(found.side.lpNorm<1>(), 1.0);
          for (const CropRectangle& r : found.rectangles) EXPECT_TRUE(same_side(r, -found.side));
          const bool along_x = found.side.x() == 0.0;
          const CropRectangle& base = found.rectangles[0];
          EXPECT_EQ(along_x ? base.width() : base.height(), along_x ? box.width() : box.height());
        }
      }
    }
  }
}

TEST(PolygonCandidates, WithoutCornersTheMasksBestNotchIsTaken) {
  for (const bool right : {false, true}) {
    for (const bool bottom : {false, true}) {
      CropBits l;
      for (int row = 10; row < 50; ++row) {
        const bool narrow = bottom == (row >= 30);
        l.set_row(row, right || !narrow ? 8 : 20, !right || !narrow ? 44 : 31);
      }
      const auto best = l_candidates({}, l);
      ASSERT_EQ(best.size(), 1u);
      EXPECT_EQ(best[0].bits(), l);
      EXPECT_EQ(best[0].side, Eigen::Vector2d(right ? -1.0 : 1.0, bottom ? 1.0 : -1.0));
    }
  }
  for (const bool along_x : {false, true}) {
    CropBits u;
    for (int row = 10; row < 50; ++row) {
      for (int col = 8; col < 44; ++col) {
        const bool notch =
            along_x ? row < 30 && col >= 15 && col < 30 : col >= 20 && row >= 20 && row < 35;
        if (!notch) u.set(row, col);
      }
    }
    const auto best = u_candidates({}, u);
    ASSERT_EQ(best.size(), 1u);
    EXPECT_EQ(best[0].bits(), u);
    EXPECT_EQ(best[0].side, along_x ? Eigen::Vector2d(0.0, 1.0) : Eigen::Vector2d(1.0, 0.0));
  }
  EXPECT_TRUE(l_candidates({}, CropBits()).empty());
  EXPECT_TRUE(u_candidates({}, CropBits()).empty());
}

}  // namespace
}  // namespace gable
