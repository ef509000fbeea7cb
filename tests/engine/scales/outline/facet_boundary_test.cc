#include <gable/engine/scales/outline/facet_boundary.h>
#include <gtest/gtest.h>

#include <vector>

namespace gable {
namespace {

Ring square(double x, double y, double size) {
  return {{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}};
}

Ring reversed(Ring ring) { return {ring.rbegin(), ring.rend()}; }

TEST(UnionByBoundary, JoinsWhatMeetsWhicheverWayItTurns) {
  const auto regions = union_by_boundary({square(0, 0, 1), reversed(square(1, 0, 1))});
  ASSERT_TRUE(regions);
  ASSERT_EQ(regions->size(), 1u);
  EXPECT_DOUBLE_EQ((*regions)[0].area, 2.0);
  EXPECT_EQ((*regions)[0].outer.size(), 4u);
}

TEST(UnionByBoundary, KnowsHolesAndTheIslandsInThem) {
  std::vector<Ring> polygons;
  for (int i = 0; i < 5; ++i) {
    for (int j = 0; j < 5; ++j) {
      const bool ring = i == 0 || j == 0 || i == 4 || j == 4;
      if (ring || (i == 2 && j == 2)) polygons.push_back(square(i, j, 1));
    }
  }
  const auto regions = union_by_boundary(polygons);
  ASSERT_TRUE(regions);
  ASSERT_EQ(regions->size(), 2u);
  double area = 0.0;
  size_t holes = 0;
  for (const OutlinedRegion& region : *regions) {
    area += region.area;
    holes += region.holes.size();
  }
  EXPECT_DOUBLE_EQ(area, 17.0);
  EXPECT_EQ(holes, 1u);
}

TEST(UnionByBoundary, DoesNotTellWhereItCannot) {
  EXPECT_FALSE(union_by_boundary({square(0, 0, 2), square(1, 1, 2)}));       // overlap
  EXPECT_FALSE(union_by_boundary({square(0, 0, 3), square(1, 1, 1)}));       // one in another
  EXPECT_FALSE(union_by_boundary({square(0, 0, 1), square(0, 0, 1)}));       // twice the same
  EXPECT_FALSE(union_by_boundary({square(0, 0, 1), square(1, 1, 1)}));       // touch at a corner
  EXPECT_FALSE(union_by_boundary({square(0, 0, 1), square(1, 0.25, 0.5)}));  // touch along a part
  EXPECT_FALSE(union_by_boundary({{{0, 0}, {1, 0}, {2, 0}}}));               // no area
  EXPECT_FALSE(union_by_boundary({{{0, 0}, {2, 2}, {3, 0}, {0, 2}}}));       // crosses itself
}

}  // namespace
}  // namespace gable
