#include <gable/grammar/height_field.h>
#include <gable/grammar/solid/house_frame.h>
#include <gtest/gtest.h>

#include "grammar/sample_houses.h"

namespace gable {
namespace {

constexpr double kAzimuth = 0.7;

TEST(HouseFrame, OfPolygonsIsThatOfTheHeightField) {
  const HeightField field(box_house(8.0, 6.0, flat_roof(3.0), kAzimuth));
  const PlanPolygon local{{{1.0, 2.0}, {5.0, -1.0}, {4.0, 4.0}}, {{{3.0, 2.0}, {3.5, 1.0}}}};
  const PlanPolygon house = house_from_local(local, kAzimuth);
  for (size_t i = 0; i < local.outer.size(); ++i) {
    EXPECT_LT((house.outer[i] - field.house_from_local(local.outer[i])).norm(), 1e-12);
  }
  ASSERT_EQ(house.holes.size(), 1u);
  for (size_t i = 0; i < local.holes[0].size(); ++i) {
    EXPECT_LT((house.holes[0][i] - field.house_from_local(local.holes[0][i])).norm(), 1e-12);
  }
}

TEST(HouseFrame, SolidsTurnBackIntoTheLocalFrameAndKeepTheirHeights) {
  const PlanPolygon local{{{1.0, 2.0}, {5.0, -1.0}, {4.0, 4.0}}, {}};
  const PlanPolygon house = house_from_local(local, kAzimuth);
  Solid solid;
  for (const Eigen::Vector2d& p : house.outer) solid.vertices.emplace_back(p.x(), p.y(), 2.5);
  turn_to_local(kAzimuth, &solid);
  for (size_t i = 0; i < local.outer.size(); ++i) {
    EXPECT_LT((solid.vertices[i].head<2>() - local.outer[i]).norm(), 1e-12);
    EXPECT_EQ(solid.vertices[i].z(), 2.5);
  }
}

}  // namespace
}  // namespace gable
