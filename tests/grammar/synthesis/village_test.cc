#include <gable/grammar/height_field.h>
#include <gable/grammar/synthesis/village.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace gable {
namespace {

VillageOptions small_village() {
  VillageOptions options;
  options.count = 60;
  options.seed = 7;
  return options;
}

/// Points every 0.25 m along an outline.
std::vector<Eigen::Vector2d> dense(const std::vector<Eigen::Vector2d>& ring) {
  std::vector<Eigen::Vector2d> points;
  for (size_t k = 0; k < ring.size(); ++k) {
    const Eigen::Vector2d along = ring[(k + 1) % ring.size()] - ring[k];
    const int steps = static_cast<int>(std::ceil(along.norm() / 0.25));
    for (int i = 0; i < steps; ++i) points.push_back(ring[k] + along * i / steps);
  }
  return points;
}

double area(const std::vector<Eigen::Vector2d>& ring) {
  double twice = 0.0;
  for (size_t k = 0; k < ring.size(); ++k) {
    const auto& a = ring[k];
    const auto& b = ring[(k + 1) % ring.size()];
    twice += (a - ring[0]).x() * (b - ring[0]).y() - (a - ring[0]).y() * (b - ring[0]).x();
  }
  return 0.5 * twice;
}

TEST(Village, SameSeedGivesTheSameVillage) {
  const Village a = synthesize_village(small_village()), b = synthesize_village(small_village());
  EXPECT_EQ(a.dsm.values, b.dsm.values);
  EXPECT_EQ(a.dtm.values, b.dtm.values);
  VillageOptions other = small_village();
  other.seed = 8;
  EXPECT_NE(synthesize_village(other).dsm.values, a.dsm.values);
}

TEST(Village, HousesKeepTheirDistance) {
  const VillageOptions options = small_village();
  const Village village = synthesize_village(options);
  std::vector<std::vector<Eigen::Vector2d>> outlines;
  for (const PlanPolygon& footprint : village.footprints)
    outlines.push_back(dense(footprint.outer));
  for (size_t i = 0; i < outlines.size(); ++i) {
    for (size_t j = 0; j < i; ++j) {
      double nearest = 1e9;
      for (const auto& p : outlines[i]) {
        for (const auto& q : outlines[j]) nearest = std::min(nearest, (p - q).norm());
      }
      EXPECT_GE(nearest, options.gap - 1e-9) << i << " and " << j;
      const HeightField field(village.houses[j]);
      const Eigen::Vector2d local =
          village.houses[i].origin.head<2>() - village.houses[j].origin.head<2>();
      EXPECT_LT(field.block_at_house(field.house_from_local(local)), 0);
    }
  }
}

TEST(Village, EveryTypeHasItsShare) {
  std::map<Foundation, int> count;
  for (const House& house : synthesize_village(small_village()).houses) ++count[house.foundation];
  ASSERT_EQ(count.size(), 5u);
  for (const auto& [type, n] : count) EXPECT_EQ(n, 12) << foundation_name(type);
}

TEST(Village, TruthCoversTheFootprints) {
  const Village village = synthesize_village(small_village());
  ASSERT_EQ(village.footprints.size(), village.houses.size());
  double total = 0.0;
  for (const PlanPolygon& footprint : village.footprints) total += area(footprint.outer);
  double covered = 0.0;
  for (float height : village.truth.values) covered += std::isfinite(height) ? 0.25 : 0.0;
  EXPECT_NEAR(covered / total, 1.0, 0.005);
}

TEST(Village, HousesStandOnTheTerrain) {
  const Village village = synthesize_village(small_village());
  double lowest = 0.0;
  for (size_t i = 0; i < village.houses.size(); ++i) {
    const Eigen::Vector3d& origin = village.houses[i].origin;
    const Eigen::Vector2d cell = village.dtm.grid.cell_of(origin.head<2>());
    const int row = static_cast<int>(std::lround(cell.x()));
    const int col = static_cast<int>(std::lround(cell.y()));
    EXPECT_NEAR(village.dtm.at(row, col), origin.z(), 0.15);
    EXPECT_LE(village.base[i], 0.0);
    EXPECT_GE(village.base[i], -1.5);
    lowest = std::min(lowest, village.base[i]);
    for (const Eigen::Vector2d& p : village.footprints[i].outer) {
      const Eigen::Vector2d c = village.dtm.grid.cell_of(p);
      EXPECT_GE(village.dtm.at(static_cast<int>(std::lround(c.x())),
                               static_cast<int>(std::lround(c.y()))),
                origin.z() + village.base[i] - 0.15);
    }
  }
  EXPECT_LT(lowest, -0.1);
}

TEST(Village, RoofsCarryThePapersNoiseAndAFewTrees) {
  const Village village = synthesize_village(small_village());
  int roof = 0, exact = 0, noisy = 0, other = 0;
  for (size_t i = 0; i < village.dsm.values.size(); ++i) {
    if (!std::isfinite(village.truth.values[i])) continue;
    ++roof;
    const double difference = std::abs(village.dsm.values[i] - village.truth.values[i]);
    ++(difference == 0.0 ? exact : difference <= 0.3 + 1e-4 ? noisy : other);
  }
  EXPECT_NEAR(exact / static_cast<double>(roof), 0.3, 0.02);
  EXPECT_NEAR(noisy / static_cast<double>(roof), 0.7, 0.02);
  EXPECT_GT(other, 0);
  EXPECT_LT(other / static_cast<double>(roof), 0.02);
}

TEST(Village, TheWorldStartsWhereItIsAskedTo) {
  VillageOptions options = small_village();
  options.north_west = {401234.0, 205678.0};
  const Village village = synthesize_village(options);
  EXPECT_EQ(village.dsm.grid.north_west, options.north_west);
  EXPECT_EQ(village.dsm.grid, village.dtm.grid);
  for (const PlanPolygon& footprint : village.footprints) {
    for (const Eigen::Vector2d& p : footprint.outer) {
      EXPECT_GE(p.x() - options.north_west.x(), options.margin - 1e-6);
      EXPECT_GE(options.north_west.y() - p.y(), options.margin - 1e-6);
    }
  }
}

TEST(Village, OneHouseIsAVillage) {
  VillageOptions options;
  options.count = 1;
  options.gsd = 1.0;
  const Village village = synthesize_village(options);
  EXPECT_EQ(village.houses.size(), 1u);
  EXPECT_GT(village.dsm.grid.size(), 48u * 48u);
}

TEST(Village, OptionsNameTheBoundThatFails) {
  VillageOptions options;
  EXPECT_EQ(options.check(), "");
  options.gsd = 5.0;
  EXPECT_EQ(options.check(), "gsd must be in [0.1, 2]");
  options = {};
  options.prior.garage_share = 2.0;
  EXPECT_EQ(options.check(), "garage_share must be in [0, 1]");
}

}  // namespace
}  // namespace gable
