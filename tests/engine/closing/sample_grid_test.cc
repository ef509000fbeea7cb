#include <gable/engine/closing/sample_grid.h>
#include <gtest/gtest.h>

#include <vector>

#include "engine/closing/sampled_roof.h"

namespace gable {
namespace {

TEST(SampleGrid, RasterGetsOnePixelPerCell) {
  const auto samples = sample_roof(
      rectangle(0, 0, 9, 6), [](const auto&) { return 1.0; }, 0.5, 0.0, 1);
  const SampleGrid grid = make_sample_grid(samples, 4000);
  EXPECT_EQ(grid.rows, 12);
  EXPECT_EQ(grid.cols, 18);
  for (const auto& cell : grid.samples) EXPECT_EQ(cell.size(), 1u);
}

TEST(SampleGrid, ManySamplesShareCells) {
  const auto samples = sample_roof(
      rectangle(0, 0, 9, 6), [](const auto&) { return 1.0; }, 0.05, 0.0, 1);
  const SampleGrid grid = make_sample_grid(samples, 400);
  EXPECT_LE(grid.rows * grid.cols, 800);
  size_t count = 0;
  for (const auto& cell : grid.samples) count += cell.size();
  EXPECT_EQ(count, samples.size());
}

TEST(SampleGrid, LabelsOfOutliersAreThoseOfTheirSurroundings) {
  auto samples = sample_roof(
      rectangle(0, 0, 9, 6), [](const auto& p) { return p.x() < 4 ? 3.0 : 5.0; }, 0.5, 0.0, 1);
  samples[3].point.z() = 5.0;
  const SampleGrid grid = make_sample_grid(samples, 4000);
  ClosingOptions options;
  options.boundary_cost = 2.0;
  const auto labels = label_grid(grid, samples, {{0, 0, 3}, {0, 0, 5}}, {}, options, {});
  for (int row = 0; row < grid.rows; ++row) {
    for (int col = 0; col < grid.cols; ++col) {
      EXPECT_EQ(labels[grid.index(row, col)], col < 8 ? 0 : 1);
    }
  }
}

}  // namespace
}  // namespace gable
