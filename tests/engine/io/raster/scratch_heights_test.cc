#include <gable/engine/io/raster/scratch_heights.h>

#include <cmath>
#include <limits>

#include "engine/io/scratch.h"

namespace gable {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
const Grid kGrid{{1000.0, 2000.0}, 0.5, 40, 30};

TEST(ScratchHeights, HoldWhatWasWrittenAndNothingElse) {
  const ScratchFolder folder;
  ScratchHeights heights(kGrid, {}, "derived", folder.path(""));
  HeightRaster part({kGrid.north_west, 0.5, 3, 4}, 0.0f);
  for (size_t i = 0; i < part.values.size(); ++i) part.values[i] = static_cast<float>(i) - 2.5f;
  part.at(1, 1) = kNan;
  heights.write(part, 10, 20);
  const HeightRaster all = heights.read(0, 0, 40, 30);
  int num_heights = 0;
  for (const float z : all.values) num_heights += !std::isnan(z);
  EXPECT_EQ(num_heights, 11);
  const HeightRaster back = heights.read(10, 20, 3, 4);
  EXPECT_EQ(back.grid.north_west, Eigen::Vector2d(1010.0, 1995.0));
  for (size_t i = 0; i < part.values.size(); ++i) {
    if (i == 5) continue;
    EXPECT_EQ(back.values[i], part.values[i]) << i;
  }
  EXPECT_TRUE(std::isnan(back.at(1, 1)));
}

TEST(ScratchHeights, NaNTakesAHeightAway) {
  const ScratchFolder folder;
  ScratchHeights heights(kGrid, {}, "derived", folder.path(""));
  heights.write(HeightRaster({kGrid.north_west, 0.5, 2, 2}, 7.0f), 0, 0);
  heights.write(HeightRaster({kGrid.north_west, 0.5, 1, 1}, kNan), 1, 1);
  EXPECT_EQ(heights.read(0, 0, 1, 1).values[0], 7.0f);
  EXPECT_TRUE(std::isnan(heights.read(1, 1, 1, 1).values[0]));
}

TEST(ScratchHeights, NothingOfThemIsToBeSeen) {
  const ScratchFolder folder;
  const ScratchHeights heights(kGrid, {}, "derived", folder.path(""));
  EXPECT_EQ(folder.num_files(), 0);
}

TEST(ScratchHeights, AFolderThatIsNoneIsNamed) {
  const ScratchFolder folder;
  const std::string nowhere = folder.path("nowhere");
  const Error error = error_of([&] { ScratchHeights(kGrid, {}, "derived", nowhere); }, nowhere);
  EXPECT_EQ(error.code(), ExitCode::kCannotWrite);
}

}  // namespace
}  // namespace gable
