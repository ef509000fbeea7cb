#include <gable/engine/detectors/garage_candidates.h>
#include <gable/grammar/random.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace gable {
namespace {

using Map = std::vector<float>;

void fill(int x0, int x1, int y0, int y1, float value, Map* map) {
  for (int row = y0; row < y1; ++row) {
    for (int col = x0; col < x1; ++col) (*map)[static_cast<size_t>(row) * kCropSize + col] = value;
  }
}

CropBits bits_of_garage(const CropGarage& garage) {
  CropBits all;
  for (const CropRectangle& r : garage.rectangles) all |= bits_of(r);
  return all;
}

TEST(GarageCandidates, ARectangleIsFoundAsItIs) {
  Map map(kCropPixels, 0.4f);
  fill(10, 17, 40, 52, 0.6f, &map);
  const auto garages = garage_candidates(map, CropBits());
  ASSERT_EQ(garages.size(), 1u);
  ASSERT_EQ(garages[0].rectangles.size(), 1u);
  EXPECT_EQ(largest_step(garages[0].rectangles[0], {10.0, 17.0, 40.0, 52.0}), 0.0);
  EXPECT_EQ(garages[0].iou, 1.0);
}

TEST(GarageCandidates, AnLIsFoundAtEachOfItsFourTurns) {
  for (const bool right : {false, true}) {
    for (const bool bottom : {false, true}) {
      Map map(kCropPixels, 0.0f);
      fill(20, 34, 30, 42, 1.0f, &map);
      fill(right ? 26 : 20, right ? 34 : 26, bottom ? 37 : 30, bottom ? 42 : 37, 0.0f, &map);
      const auto garages = garage_candidates(map, CropBits());
      ASSERT_EQ(garages.size(), 1u);
      EXPECT_EQ(garages[0].iou, 1.0);
      EXPECT_EQ(bits_of_garage(garages[0]), pixels_above(map, 0.5));
      ASSERT_EQ(garages[0].rectangles.size(), 2u);
      EXPECT_EQ(garages[0].rectangles[0].width(), 14.0);
      EXPECT_EQ(garages[0].rectangles[1].height(), 12.0);
      EXPECT_EQ(garages[0].side, Eigen::Vector2d(right ? -1.0 : 1.0, bottom ? 1.0 : -1.0));
    }
  }
}

TEST(GarageCandidates, ANotchNearTheBoundaryMakesNoL) {
  Map map(kCropPixels, 0.0f);
  fill(20, 34, 30, 42, 1.0f, &map);
  fill(31, 34, 39, 42, 0.0f, &map);  // 3 pixels deep
  const auto garages = garage_candidates(map, CropBits());
  ASSERT_EQ(garages.size(), 1u);
  EXPECT_EQ(garages[0].rectangles.size(), 1u);
}

TEST(GarageCandidates, SmallPiecesAreLeftOutAndCornersConnect) {
  Map map(kCropPixels, 0.0f);
  fill(2, 4, 2, 4, 1.0f, &map);    // 2 pixels across
  fill(10, 13, 2, 3, 1.0f, &map);  // 3 pixels long
  fill(30, 34, 30, 34, 1.0f, &map);
  fill(34, 38, 34, 38, 1.0f, &map);  // touches the last at a corner
  const auto garages = garage_candidates(map, CropBits());
  ASSERT_EQ(garages.size(), 2u);
  EXPECT_EQ(garages[0].rectangles[0].x0, 10.0);
  EXPECT_EQ(bits_of_garage(garages[1]).row(30) & (uint64_t{1} << 30), uint64_t{1} << 30);
}

TEST(GarageCandidates, OnlyWhatStandsInTheMaskCountsWhereMostOfAPieceDoes) {
  Map map(kCropPixels, 0.0f);
  fill(10, 22, 10, 20, 1.0f, &map);
  CropBits mask;
  for (int row = 0; row < kCropSize; ++row) mask.set_row(row, 0, 18);
  EXPECT_EQ(garage_candidates(map, mask)[0].rectangles[0].x1, 18.0);
  CropBits little;
  for (int row = 0; row < kCropSize; ++row) little.set_row(row, 0, 13);
  EXPECT_EQ(garage_candidates(map, little)[0].rectangles[0].x1, 22.0);
}

// Pieces by a plain flood over pixels.
TEST(GarageCandidates, PiecesAreThoseOfAPlainFlood) {
  Random random(8);
  CropBits bits;
  for (int row = 0; row < kCropSize; ++row) {
    for (int col = 0; col < kCropSize; ++col) {
      if (random.chance(0.3)) bits.set(row, col);
    }
  }
  std::vector<int> label(kCropPixels, -1);
  int labels = 0;
  std::vector<int> sizes;
  for (int start = 0; start < static_cast<int>(kCropPixels); ++start) {
    if (label[start] >= 0 || !bits.at(start / kCropSize, start % kCropSize)) continue;
    std::vector<int> stack = {start};
    label[start] = labels;
    sizes.push_back(0);
    while (!stack.empty()) {
      const int pixel = stack.back();
      stack.pop_back();
      ++sizes.back();
      for (int dr = -1; dr <= 1; ++dr) {
        for (int dc = -1; dc <= 1; ++dc) {
          const int r = pixel / kCropSize + dr, c = pixel % kCropSize + dc;
          if (r < 0 || r >= kCropSize || c < 0 || c >= kCropSize || !bits.at(r, c)) continue;
          if (label[r * kCropSize + c] >= 0) continue;
          label[r * kCropSize + c] = labels;
          stack.push_back(r * kCropSize + c);
        }
      }
    }
    ++labels;
  }
  const std::vector<CropBits> pieces = connected_pieces(bits);
  ASSERT_EQ(static_cast<int>(pieces.size()), labels);
  for (int i = 0; i < labels; ++i) {
    EXPECT_EQ(pieces[i].count(), sizes[i]);
    for (int pixel = 0; pixel < static_cast<int>(kCropPixels); ++pixel) {
      EXPECT_EQ(pieces[i].at(pixel / kCropSize, pixel % kCropSize), label[pixel] == i);
    }
  }
  EXPECT_GT(labels, 20);
}

TEST(GarageCandidates, OptionsOutOfRangeAreNamed) {
  GarageOptions options;
  EXPECT_EQ(check(options), "");
  options.least_inset = 0;
  EXPECT_EQ(check(options), "least_inset must be in [1, 32]");
}

}  // namespace
}  // namespace gable
