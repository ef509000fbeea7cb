#include <gable/engine/closing/roof_defects.h>
#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace gable {
namespace {

// Two flat roofs beside each other, 3 and 5 m high; the step between them has a corner at (4, 2).
RoofPartition stepped(double x, double higher = 5.0) {
  RoofPartition roof;
  roof.planes = {{0, 0, 3}, {0, 0, higher}};
  roof.regions = {{0, {{{0, 0}, {4, 0}, {x, 2}, {4, 4}, {0, 4}}, {}}},
                  {1, {{{4, 0}, {8, 0}, {8, 4}, {4, 4}, {x, 2}}, {}}}};
  return roof;
}

std::vector<CrowdedCorner> crowded(const RoofPartition& roof, double least) {
  return find_roof_defects(roof, least).crowded;
}

// Four squares around (2, 2), anticlockwise from the lower left.
RoofPartition quarters(const std::array<double, 4>& heights) {
  RoofPartition roof;
  const std::array<Eigen::Vector2d, 4> corners = {Eigen::Vector2d(0, 0), {2, 0}, {2, 2}, {0, 2}};
  for (int i = 0; i < 4; ++i) {
    roof.planes.push_back({0, 0, heights[i]});
    const Eigen::Vector2d c = corners[i];
    roof.regions.push_back(
        {i, {{c, {c.x() + 2, c.y()}, {c.x() + 2, c.y() + 2}, {c.x(), c.y() + 2}}, {}}});
  }
  return roof;
}

TEST(RoofDefects, HighAndLowInTurnMakeASaddle) {
  EXPECT_TRUE(find_roof_defects(quarters({3, 4, 5, 4}), 0.004).saddles.empty());
  EXPECT_TRUE(find_roof_defects(quarters({3, 4, 4, 4}), 0.004).saddles.empty());
  const auto saddles = find_roof_defects(quarters({5, 3, 4, 3.5}), 0.004).saddles;
  ASSERT_EQ(saddles.size(), 1u);
  EXPECT_EQ(saddles[0].place, Eigen::Vector2d(2, 2));
  ASSERT_EQ(saddles[0].sectors.size(), 4u);
  for (const RoofSector& sector : saddles[0].sectors) {
    const Eigen::Vector2d p = saddles[0].place + sector.into;
    EXPECT_EQ(sector.plane, p.y() < 2 ? (p.x() < 2 ? 0 : 1) : (p.x() < 2 ? 3 : 2));
  }
  EXPECT_FALSE(solids_of_partition(quarters({5, 3, 4, 3.5}), 0.0));
  EXPECT_TRUE(solids_of_partition(quarters({3, 4, 5, 4}), 0.0));
}

TEST(RoofDefects, RegionsThatTouchInACornerMakeASaddle) {
  RoofPartition roof = quarters({3, 3, 3, 3});
  roof.regions.erase(roof.regions.begin() + 3);
  roof.regions.erase(roof.regions.begin() + 1);
  EXPECT_EQ(find_roof_defects(roof, 0.004).saddles.size(), 1u);
  // One notched corner is none.
  RoofPartition notched = quarters({3, 3, 3, 3});
  notched.regions.pop_back();
  EXPECT_TRUE(find_roof_defects(notched, 0.004).saddles.empty());
}

TEST(RoofDefects, RegionsThatTouchThemselvesMakeASaddle) {
  // A square with two courtyards that share a corner, of which one is higher and one is lower.
  RoofPartition roof;
  roof.planes = {{0, 0, 4}, {0, 0, 3}, {0, 0, 5}};
  roof.regions = {{0,
                   {{{0, 0}, {9, 0}, {9, 9}, {0, 9}},
                    {{{2, 2}, {2, 4}, {4, 4}, {4, 2}}, {{4, 4}, {4, 6}, {6, 6}, {6, 4}}}}},
                  {1, {{{2, 2}, {4, 2}, {4, 4}, {2, 4}}, {}}},
                  {2, {{{4, 4}, {6, 4}, {6, 6}, {4, 6}}, {}}}};
  const auto saddles = find_roof_defects(roof, 0.004).saddles;
  ASSERT_EQ(saddles.size(), 1u);
  EXPECT_EQ(saddles[0].place, Eigen::Vector2d(4, 4));
}

TEST(RoofDefects, CornersFarFromEachOtherAreNone) {
  EXPECT_TRUE(crowded(stepped(4.5), 0.004).empty());
}

TEST(RoofDefects, CornerBesideAnEdgeOfAnotherRegionIsOne) {
  RoofPartition roof = stepped(4.5);
  roof.planes.push_back({0, 0, 7});
  // A corner 3 mm from the edge from (4.5, 2) to (4, 4).
  roof.regions.push_back({2, {{{4.253, 3.0}, {6, 2.8}, {6, 3.2}}, {}}});
  const auto corners = crowded(roof, 0.004);
  ASSERT_EQ(corners.size(), 1u);
  EXPECT_TRUE(corners[0].nearly_level.empty());
  EXPECT_EQ(corners[0].place, Eigen::Vector2d(4.253, 3.0));
  EXPECT_TRUE(crowded(roof, 0.002).empty());
}

TEST(RoofDefects, CornersNearEachOtherAreTwo) {
  RoofPartition roof = stepped(4.5);
  roof.planes.push_back({0, 0, 7});
  roof.regions.push_back({2, {{{8.002, 4.0}, {9, 5}, {9, 6}}, {}}});
  EXPECT_EQ(crowded(roof, 0.004).size(), 2u);
}

TEST(RoofDefects, StepsOfMillimetresAreCrowded) {
  const auto corners = crowded(stepped(4.5, 3.002), 0.004);
  EXPECT_EQ(corners.size(), 3u);
  for (const CrowdedCorner& corner : corners) {
    EXPECT_EQ(corner.nearly_level, (std::vector<int>{0, 1}));
  }
  EXPECT_TRUE(crowded(stepped(4.5, 3.0), 0.004).empty());
}

}  // namespace
}  // namespace gable
