#include <gable/grammar/synthesis/survey/mean_cells.h>
#include <gtest/gtest.h>

namespace gable {
namespace {

// A plane, and a step of 8 m from column `wall` on.
HeightRaster sloping(int wall) {
  HeightRaster fine({{1000.0, 2000.0}, 0.25, 42, 48}, 0.0f);
  for (int row = 0; row < fine.grid.rows; ++row) {
    for (int col = 0; col < fine.grid.cols; ++col) {
      fine.at(row, col) = 0.5f * static_cast<float>(row) + (col >= wall ? 8.0f : 0.0f);
    }
  }
  return fine;
}

TEST(MeanCells, APlaneStaysOneOnAGridOfTheSameCorner) {
  for (const CellMeans means : {CellMeans::kOver, CellMeans::kResampled}) {
    const HeightRaster coarse = mean_cells(sloping(1000), 4, means);
    EXPECT_EQ(coarse.grid.north_west, Eigen::Vector2d(1000.0, 2000.0));
    EXPECT_EQ(coarse.grid.gsd, 1.0);
    EXPECT_EQ(coarse.grid.rows, 10);
    EXPECT_EQ(coarse.grid.cols, 12);
    for (int row = 1; row < 9; ++row) EXPECT_NEAR(coarse.at(row, 5), 0.75 + 2.0 * row, 1e-5);
  }
}

TEST(MeanCells, AWallIsARampOfOneCellOrOfTwo) {
  // A quarter of column 5 lies behind the wall.
  const HeightRaster over = mean_cells(sloping(23), 4, CellMeans::kOver);
  const float ground = over.at(4, 0);
  EXPECT_NEAR(over.at(4, 4) - ground, 0.0, 1e-5);
  EXPECT_NEAR(over.at(4, 5) - ground, 2.0, 1e-5);
  EXPECT_NEAR(over.at(4, 6) - ground, 8.0, 1e-5);
  // Its middle is a quarter of a cell from the wall: half of (1 - 1/4)^2 of the triangle.
  const HeightRaster resampled = mean_cells(sloping(23), 4, CellMeans::kResampled);
  EXPECT_NEAR(resampled.at(4, 5) - ground, 8.0 * 0.5 * 0.75 * 0.75, 1e-5);
  EXPECT_NEAR(resampled.at(4, 6) - ground, 8.0 * (1.0 - 0.5 * 0.25 * 0.25), 1e-5);
  EXPECT_NEAR(resampled.at(4, 7) - ground, 8.0, 1e-5);
}

}  // namespace
}  // namespace gable
