#include <gable/engine/reconstruct/first_values/edge_lines.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/house_image.h"

namespace gable {
namespace {

// A high block from x = -8 to 0 and a lower one from 0 to 6, both from y = -4 to 4.
House two_blocks() {
  House house = make_house(Foundation::kII);
  house.footprints = {rectangle_rule(-8.0, 0.0, -4.0, 4.0), rectangle_rule(0.0, 6.0, -4.0, 4.0)};
  house.roofs = {flat_roof(8.0), flat_roof(5.0)};
  return house;
}

std::vector<double> columns_at(const RectifiedView& view, const EdgeLines& lines) {
  std::vector<double> out;
  for (int c : lines.columns) out.push_back(view.x_edge(c));
  return out;
}

std::vector<double> rows_at(const RectifiedView& view, const EdgeLines& lines) {
  std::vector<double> out;
  for (int r : lines.rows) out.push_back(view.y_edge(r));
  return out;
}

double distance_to(const std::vector<double>& lines, double at) {
  double least = 1e9;
  for (double line : lines) least = std::min(least, std::abs(line - at));
  return least;
}

TEST(EdgeLines, LieAtWallsAndAtTheStepBetweenBlocks) {
  const RectifiedView view = rectify(image_of(two_blocks()), 0.0, 0.5, 1.5);
  const EdgeLines lines = find_edge_lines(view, {});
  const std::vector<double> columns = columns_at(view, lines), rows = rows_at(view, lines);
  for (const double x : {-8.0, 0.0, 6.0}) EXPECT_LE(distance_to(columns, x), 0.5) << x;
  for (const double y : {-4.0, 4.0}) EXPECT_LE(distance_to(rows, y), 0.5) << y;
}

TEST(EdgeLines, LieAtWallsAndStepsOfNoisyHeightsSeenAtAnAngle) {
  House house = two_blocks();
  house.azimuth[0] = 0.5;
  const RectifiedView view = rectify(image_of(house, {.noise = 0.15}), 0.5, 0.5, 1.5);
  const EdgeLines lines = find_edge_lines(view, {});
  const std::vector<double> columns = columns_at(view, lines), rows = rows_at(view, lines);
  for (const double x : {-8.0, 0.0, 6.0}) EXPECT_LE(distance_to(columns, x), 1.0) << x;
  for (const double y : {-4.0, 4.0}) EXPECT_LE(distance_to(rows, y), 1.0) << y;
}

TEST(EdgeLines, NeedAStepARoofsSlopeIsNone) {
  const House house = box_house(12.0, 8.0, gable_roof(5.0, 3.0, Axis::kX));
  const RectifiedView view = rectify(image_of(house), 0.0, 0.5, 1.5);
  EdgeLineOptions options;
  options.widest_gap = 100.0;
  const EdgeLines lines = find_edge_lines(view, options);
  ASSERT_EQ(lines.columns.size(), 2u);
  ASSERT_EQ(lines.rows.size(), 2u);
  EXPECT_NEAR(view.x_edge(lines.columns[0]), -6.0, 0.5);
  EXPECT_NEAR(view.x_edge(lines.columns[1]), 6.0, 0.5);
  EXPECT_NEAR(view.y_edge(lines.rows[0]), -4.0, 0.5);
  EXPECT_NEAR(view.y_edge(lines.rows[1]), 4.0, 0.5);
}

TEST(EdgeLines, AreAscendingApartAndLeaveNoWideGap) {
  const RectifiedView view = rectify(image_of(two_blocks(), {.noise = 0.2}), 0.0, 0.5, 1.5);
  const EdgeLineOptions options;
  const EdgeLines lines = find_edge_lines(view, options);
  for (const std::vector<int>& l : {lines.columns, lines.rows}) {
    ASSERT_LE(static_cast<int>(l.size()), options.max_lines);
    for (size_t i = 1; i < l.size(); ++i) {
      EXPECT_GE((l[i] - l[i - 1]) * view.cell, options.separation);
      EXPECT_LE((l[i] - l[i - 1]) * view.cell, options.widest_gap);
    }
  }
}

TEST(EdgeLines, KeepTheWallsWhereOnlyAFewAreAllowed) {
  const RectifiedView view = rectify(image_of(two_blocks()), 0.0, 0.5, 1.5);
  EdgeLineOptions options;
  options.max_lines = 4;
  const EdgeLines lines = find_edge_lines(view, options);
  EXPECT_LE(lines.columns.size(), 4u);
  const std::vector<double> columns = columns_at(view, lines);
  for (const double x : {-8.0, 6.0}) EXPECT_LE(distance_to(columns, x), 0.5) << x;
}

}  // namespace
}  // namespace gable
