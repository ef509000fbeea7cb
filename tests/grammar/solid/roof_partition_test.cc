#include <gable/grammar/solid/roof_partition.h>
#include <gable/grammar/solid/validity.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace gable {
namespace {

// A gable of 12 x 8 with its ridge along y = 4 at 6 m.
RoofPartition gable_roof() {
  const std::vector<PlanSegment> segments = {{{0, 0}, {12, 0}},
                                             {{12, 0}, {12, 8}},
                                             {{12, 8}, {0, 8}},
                                             {{0, 8}, {0, 0}},
                                             {{-1, 4}, {13, 4}}};
  const std::vector<Plane> planes = {{0, 0, 1}, {0, 0.75, 3}, {0, -0.75, 9}};
  const auto roof = partition_plan(segments, planes, [](const Eigen::Vector2d& p) {
    if (p.x() < 0 || p.x() > 12 || p.y() < 0 || p.y() > 8) return -1;
    return p.y() < 4 ? 1 : 2;
  });
  EXPECT_TRUE(roof);
  return *roof;
}

TEST(RoofPartition, PlanesWithoutRegionsAreLeftOut) {
  const RoofPartition roof = gable_roof();
  EXPECT_EQ(roof.planes.size(), 2u);
  ASSERT_EQ(roof.regions.size(), 2u);
  EXPECT_EQ(roof.regions[0].plane + roof.regions[1].plane, 1);
}

TEST(RoofPartition, HeightsAreThoseOfThePlaneAbove) {
  const RoofPartition roof = gable_roof();
  EXPECT_DOUBLE_EQ(roof_height(roof, {3, 1}), 3.75);
  EXPECT_DOUBLE_EQ(roof_height(roof, {3, 7}), 3.75);
  EXPECT_TRUE(std::isnan(roof_height(roof, {-3, 7})));
}

TEST(RoofPartition, SolidIsValidAndHasTheVolumeBelowTheRoof) {
  const auto solids = solids_of_partition(gable_roof(), -1.0);
  ASSERT_TRUE(solids);
  ASSERT_EQ(solids->size(), 1u);
  const SolidValidity validity = check_solid(solids->front());
  EXPECT_EQ(validity.describe(), "valid");
  EXPECT_NEAR(validity.volume, 12 * 8 * 5.5, 1e-9);
  EXPECT_EQ(solids->front().faces.size(), 7u);
}

TEST(RoofPartition, RegionsApartAreBodiesApart) {
  RoofPartition roof;
  roof.planes = {{0, 0, 2}};
  roof.regions = {{0, {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {}}},
                  {0, {{{5, 0}, {6, 0}, {6, 1}, {5, 1}}, {}}}};
  const auto solids = solids_of_partition(roof, 0.0);
  ASSERT_TRUE(solids);
  EXPECT_EQ(solids->size(), 2u);
}

TEST(RoofPartition, RoofAtItsBaseIsNone) {
  EXPECT_FALSE(solids_of_partition(gable_roof(), 3.0));
  EXPECT_FALSE(solids_of_partition({}, 0.0));
}

}  // namespace
}  // namespace gable
