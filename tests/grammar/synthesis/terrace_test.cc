#include <gable/grammar/synthesis/plot.h>
#include <gable/grammar/synthesis/terrace.h>
#include <gtest/gtest.h>

#include <cmath>

namespace gable {
namespace {

TEST(Terrace, NeighboursTouchAndOthersDoNot) {
  for (uint64_t seed = 1; seed <= 20; ++seed) {
    TerraceOptions options;
    options.seed = seed;
    const Terrace terrace = make_terrace(options);
    const std::vector<House>& houses = terrace.houses;
    ASSERT_EQ(houses.size(), 5u);
    ASSERT_EQ(terrace.footprints.size(), 5u);
    for (size_t i = 0; i < houses.size(); ++i) {
      ASSERT_TRUE(is_well_formed(houses[i]));
      for (size_t j = i + 1; j < houses.size(); ++j) {
        const double distance = Plot(houses[i]).distance(Plot(houses[j]));
        if (j == i + 1) {
          EXPECT_LT(distance, 1e-6);
        } else {
          EXPECT_GT(distance, 2.5);
        }
      }
    }
  }
}

TEST(Terrace, TheSurveyShowsItsRoofs) {
  TerraceOptions options;
  options.lidar.noise_share = 0.0;
  const Terrace terrace = make_terrace(options);
  for (const House& house : terrace.houses) {
    const HeightField field(house);
    const Eigen::Vector2d middle(house.footprints[0][0], house.footprints[0][1]);
    const Eigen::Vector2d world = field.local_from_house(middle) + house.origin.head<2>();
    const Eigen::Vector2d cell = terrace.dsm.grid.cell_of(world);
    const int row = static_cast<int>(std::round(cell.x()));
    const int col = static_cast<int>(std::round(cell.y()));
    const Eigen::Vector2d seen =
        field.house_from_local(terrace.dsm.grid.center_of(row, col) - house.origin.head<2>());
    EXPECT_NEAR(terrace.dsm.at(row, col), house.origin.z() + field.at_house(seen, 0.0, 0.0), 1e-4);
  }
}

TEST(Terrace, IsTheSameForTheSameSeed) {
  const Terrace a = make_terrace({}), b = make_terrace({});
  EXPECT_EQ(a.dsm.values, b.dsm.values);
  EXPECT_EQ(a.houses.back().origin, b.houses.back().origin);
}

TEST(Terrace, CheckNamesTheViolatedBound) {
  TerraceOptions options;
  options.count = 0;
  EXPECT_EQ(options.check(), "count must be >= 1");
  EXPECT_EQ(TerraceOptions{}.check(), "");
}

}  // namespace
}  // namespace gable
