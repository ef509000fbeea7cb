#include <gable/engine/detectors/crop_foundation.h>
#include <gable/grammar/random.h>
#include <gtest/gtest.h>

namespace gable {
namespace {

CropFoundation with_iou(const CropRectangle& rectangle, double iou) {
  CropFoundation out;
  out.rectangles = {rectangle};
  out.iou = iou;
  return out;
}

TEST(CropFoundation, RectanglesHoldThePixelsWhoseCentresLieInThem) {
  Random random(4);
  for (int i = 0; i < 200; ++i) {
    const double x = random.uniform(-10.0, 60.0), y = random.uniform(-10.0, 60.0);
    const CropRectangle r{x, x + random.uniform(0.0, 80.0), y, y + random.uniform(0.0, 80.0)};
    const CropBits bits = bits_of(r);
    for (int row = 0; row < kCropSize; ++row) {
      for (int col = 0; col < kCropSize; ++col) {
        const bool inside =
            col + 0.5 >= r.x0 && col + 0.5 < r.x1 && row + 0.5 >= r.y0 && row + 0.5 < r.y1;
        ASSERT_EQ(bits.at(row, col), inside) << row << " " << col;
      }
    }
  }
}

TEST(CropFoundation, BoundsAreTightAroundAllPixels) {
  CropBits bits;
  EXPECT_EQ(bounds_of(bits).width(), 0.0);
  bits.set(63, 63);
  bits.set(5, 0);
  EXPECT_EQ(largest_step(bounds_of(bits), {0.0, 64.0, 5.0, 64.0}), 0.0);
  EXPECT_EQ(bits.count(), 2);
}

TEST(CropFoundation, SetsAreComparedPixelByPixel) {
  const CropBits a = bits_of({0.0, 64.0, 0.0, 10.0}), b = bits_of({0.0, 64.0, 5.0, 20.0});
  EXPECT_EQ(common_pixels(a, b), 5 * 64);
  EXPECT_EQ((a | b).count(), 20 * 64);
  EXPECT_EQ((a & b), bits_of({0.0, 64.0, 5.0, 10.0}));
  EXPECT_DOUBLE_EQ(intersection_over_union(a, b), 0.25);
  EXPECT_EQ(intersection_over_union(CropBits(), CropBits()), 0.0);
}

TEST(CropFoundation, TheBestDistinctCandidatesAreKept) {
  std::vector<CropFoundation> candidates = {
      with_iou({0, 10, 0, 10}, 0.5), with_iou({1, 11, 0, 10}, 0.7), with_iou({0, 20, 0, 10}, 0.6),
      with_iou({0, 40, 0, 10}, 0.4)};
  candidates[3].corners = 0.15;
  CandidateOptions options;
  options.at_most = 2;
  keep_best(options, &candidates);
  ASSERT_EQ(candidates.size(), 2u);
  EXPECT_EQ(candidates[0].iou, 0.7);  // and not the one at a pixel from it
  EXPECT_EQ(candidates[1].iou, 0.6);
}

TEST(CropFoundation, OptionsOutOfRangeAreNamed) {
  CandidateOptions options;
  EXPECT_EQ(check(options), "");
  options.corner_weight = -1.0;
  EXPECT_EQ(check(options), "corner_weight must be in [0, 10]");
  options = {};
  options.at_most = 0;
  EXPECT_EQ(check(options), "at_most must be >= 1");
}

}  // namespace
}  // namespace gable
