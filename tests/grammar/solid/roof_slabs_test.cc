#include <gable/grammar/random.h>
#include <gable/grammar/ring.h>
#include <gable/grammar/solid/roof_slabs.h>
#include <gable/grammar/solid/validity.h>
#include <gable/grammar/synthesis/houses/prior.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>

#include "grammar/solid/nasty_houses.h"

namespace gable {
namespace {

constexpr double kBase = -0.25;
constexpr RoofSlabOptions kUsual{0.35, 0.15};

House one_block(RuleKind kind, const std::array<double, kMaxRuleParameters>& roof) {
  House house = make_house(Foundation::kI);
  house.footprints[0].values = {1.0, 2.0, 10.0, 8.0};
  house.roofs[0] = make_rule(kind);
  house.roofs[0].values = roof;
  house.azimuth[0] = 0.4;
  return house;
}

std::vector<Solid> of_role(const HouseSolids& solids, PartRole role) {
  std::vector<Solid> result;
  for (const HousePart& part : solids.parts) {
    if (part.role == role) result.push_back(part.solid);
  }
  return result;
}

double volume(const std::vector<Solid>& solids) {
  double sum = 0.0;
  for (const Solid& solid : solids) sum += check_solid(solid).volume;
  return sum;
}

HouseSolids valid_slabs(const House& house, const RoofSlabOptions& options = kUsual,
                        const std::vector<PlanPolygon>& neighbours = {}) {
  HouseSolids solids = build_roof_slabs(house, kBase, options, neighbours);
  for (const HousePart& part : solids.parts) {
    EXPECT_EQ(check_solid(part.solid).describe(), "valid");
  }
  return solids;
}

TEST(RoofSlabs, AGableRoofHoldsItsThicknessTimesItsPlan) {
  const HouseSolids solids = valid_slabs(one_block(RuleKind::kRoofGable, {3.0, 2.0}));
  EXPECT_TRUE(solids.dropped.empty());
  const std::vector<Solid> slabs = of_role(solids, PartRole::kRoofSlab);
  ASSERT_EQ(slabs.size(), 1u);
  EXPECT_NEAR(volume(slabs), 0.35 * 10.3 * 8.3, 1e-6);
  // The walls end under it.
  EXPECT_NEAR(volume(of_role(solids, PartRole::kMain)), 80.0 * (3.25 + 1.0 - 0.35), 1e-6);
  double low = 1e9, high = -1e9;
  for (const Eigen::Vector3d& p : slabs[0].vertices) {
    low = std::min(low, p.z());
    high = std::max(high, p.z());
  }
  EXPECT_NEAR(high, 5.0, 1e-6);
  EXPECT_NEAR(low, 3.0 - 0.15 * 0.5 - 0.35, 1e-6);
}

TEST(RoofSlabs, HipsReachOutUntilTheEavesAreLevel) {
  // Hips of 2 and 4 m to a half width of 4 m: the first is twice as steep as the other eaves.
  const std::vector<Solid> slabs = of_role(
      valid_slabs(one_block(RuleKind::kRoofHip, {3.0, 2.0, 0.2, 0.4})), PartRole::kRoofSlab);
  ASSERT_EQ(slabs.size(), 1u);
  EXPECT_NEAR(volume(slabs), 0.35 * (10.0 + 0.075 + 0.15) * 8.3, 1e-6);
  std::vector<double> lowest;
  for (const Eigen::Vector3d& p : slabs[0].vertices) lowest.push_back(p.z());
  std::sort(lowest.begin(), lowest.end());
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(lowest[i], 3.0 - 0.15 * 0.5 - 0.35, 1e-6);
}

TEST(RoofSlabs, WithoutOverhangSlabsAndWallsFillTheHouse) {
  for (const RuleKind kind : {RuleKind::kRoofGable, RuleKind::kRoofHip, RuleKind::kRoofFlat}) {
    const House house = one_block(kind, {3.0, 2.0, 0.2, 0.4});
    const HouseSolids solids = valid_slabs(house, {0.2, 0.0});
    double all = 0.0;
    for (const HousePart& part : solids.parts) all += check_solid(part.solid).volume;
    const HouseSolids whole = build_house_solids(house, Lod::k22, kBase);
    EXPECT_NEAR(all, check_solid(whole.parts[0].solid).volume, 1e-6);
  }
}

TEST(RoofSlabs, RoofsOfAnLMeetInValleysAsOneSlab) {
  House house = make_house(Foundation::kL);
  house.footprints[0].values = {0, 0, 12, 6, 14, 6};
  for (Rule& roof : house.roofs) roof.values = {3.0, 2.0};
  const std::vector<Solid> slabs = of_role(valid_slabs(house), PartRole::kRoofSlab);
  ASSERT_EQ(slabs.size(), 1u);
  // The L grown by the overhang: the plan's area, its perimeter times the overhang, and a corner
  // square for each convex corner beyond the concave one.
  const double area = 12 * 6 + 8 * 6 + 0.15 * 52 + (5 - 1) * 0.15 * 0.15;
  EXPECT_NEAR(volume(slabs), 0.35 * area, 1e-6);
}

House tower() {
  House house = make_house(Foundation::kII);
  house.footprints[0].values = {0, 0, 10, 8};
  house.footprints[1].values = {7, 0, 4, 4};
  for (Rule& roof : house.roofs) roof = make_rule(RuleKind::kRoofFlat);
  house.roofs[0].values = {3.0};
  house.roofs[1].values = {5.0};
  return house;
}

TEST(RoofSlabs, ALowerRoofEndsAtTheWallOfAHigherOneAndRunsOnUnderItsOverhang) {
  const std::vector<Solid> slabs = of_role(valid_slabs(tower()), PartRole::kRoofSlab);
  ASSERT_EQ(slabs.size(), 2u);
  // The lower one reaches beyond the house's walls, less the strip of 4 m that the tower fills.
  EXPECT_NEAR(volume(slabs), 0.35 * (10.3 * 8.3 - 0.15 * 4.0 + 4.3 * 4.3), 1e-6);
}

TEST(RoofSlabs, ChimneysPassThrough) {
  House house = one_block(RuleKind::kRoofFlat, {3.0});
  Rule chimney = make_rule(RuleKind::kChimney);
  chimney.values = {1.0, 2.0, 1.0, 6.0};
  house.chimneys.push_back(chimney);
  const HouseSolids solids = valid_slabs(house);
  EXPECT_NEAR(volume(of_role(solids, PartRole::kRoofSlab)), 0.35 * (10.3 * 8.3 - 1.0), 1e-6);
  EXPECT_NEAR(volume(of_role(solids, PartRole::kChimney)), 3.35, 1e-6);
}

TEST(RoofSlabs, ADormersSlabLiesOnTheRoofItLooksOutOf) {
  House house = one_block(RuleKind::kRoofGable, {3.0, 3.0});
  Rule dormer = make_rule(RuleKind::kDormer);
  dormer.values = {1.0, 4.5, 2.0, 2.5, 4.6, 0.3};
  dormer.component = 0;
  house.dormers.push_back(dormer);
  const HouseSolids solids = valid_slabs(house);
  EXPECT_TRUE(solids.dropped.empty());
  EXPECT_EQ(of_role(solids, PartRole::kDormer).size(), 1u);
  EXPECT_GE(of_role(solids, PartRole::kRoofSlab).size(), 2u);
}

TEST(RoofSlabs, NoOverhangLiesAcrossAPartyWall) {
  House house = one_block(RuleKind::kRoofFlat, {3.0});
  house.azimuth[0] = 0.0;
  // East of the wall at x = 6, the house being from -4 to 6.
  const PlanPolygon neighbour{{{6, -20}, {16, -20}, {16, 20}, {6, 20}}, {}};
  const std::vector<Solid> slabs =
      of_role(valid_slabs(house, kUsual, {neighbour}), PartRole::kRoofSlab);
  EXPECT_NEAR(volume(slabs), 0.35 * 10.15 * 8.3, 1e-6);
}

TEST(RoofSlabs, DetailsThatDoNotShowLeaveNoTrace) {
  House house = one_block(RuleKind::kRoofGable, {3.0, 2.0});
  for (const double height : {4.0, 6.0}) {  // the first is inside the attic
    Rule chimney = make_rule(RuleKind::kChimney);
    chimney.values = {1.0, 2.0, 1.0, height};
    house.chimneys.push_back(chimney);
  }
  house.chimneys[1][param::chimney::kCenterX] = 3.0;
  const HouseSolids solids = valid_slabs(house);
  const auto chimney =
      std::find_if(solids.parts.begin(), solids.parts.end(),
                   [](const HousePart& part) { return part.role == PartRole::kChimney; });
  ASSERT_NE(chimney, solids.parts.end());
  EXPECT_EQ(chimney->index, 1);
}

TEST(RoofSlabs, OptionsOutOfRangeAreNamed) {
  EXPECT_EQ(check(RoofSlabOptions{}), "");
  EXPECT_EQ(check(kUsual), "");
  EXPECT_EQ(check(RoofSlabOptions{0.0, 0.1}), "an overhang needs a thickness");
  EXPECT_EQ(check(RoofSlabOptions{2.0, 0.1}), "thickness must be 0 or lie in [0.05, 1] m");
  EXPECT_EQ(check(RoofSlabOptions{0.3, NAN}), "overhang must lie in [0, 1] m");
}

// The faces of a type of a solid over a point of the local frame, as heights.
std::vector<double> heights_over(const Solid& solid, SurfaceType type, const Eigen::Vector2d& p) {
  std::vector<double> heights;
  for (const Face& face : solid.faces) {
    if (face.type != type) continue;
    int inside = 0;
    for (const std::vector<int>& ring : face.rings) {
      std::vector<Eigen::Vector2d> points;
      for (const int v : ring) points.push_back(solid.vertices[v].head<2>());
      inside += ring_holds(points, p);
    }
    if (inside != 1) continue;
    const std::vector<int>& ring = face.rings[0];
    const Eigen::Vector3d first = solid.vertices[ring[0]];
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    for (size_t i = 1; i + 1 < ring.size(); ++i) {
      normal += (solid.vertices[ring[i]] - first).cross(solid.vertices[ring[i + 1]] - first);
    }
    heights.push_back(first.z() - normal.head<2>().dot(p - first.head<2>()) / normal.z());
  }
  std::sort(heights.begin(), heights.end());
  return heights;
}

TEST(RoofSlabs, SolidsOfRandomHousesAreValidAndDoNotOverlap) {
  Random random(5);
  int dropped = 0, slabs = 0, points = 0, overlaps = 0;
  for (int i = 0; i < 200; ++i) {
    const House house = random_house(&random);
    const HouseSolids solids = valid_slabs(house);
    dropped += !solids.dropped.empty();
    slabs += static_cast<int>(of_role(solids, PartRole::kRoofSlab).size());
    EXPECT_EQ(solids.parts.empty(), !solids.dropped.empty());
    for (int k = 0; k < 20; ++k) {
      const Eigen::Vector2d p(random.uniform(-8, 8), random.uniform(-8, 8));
      // From below, the intervals that solids fill over a point follow one another.
      std::vector<std::pair<double, double>> filled;
      for (const HousePart& part : solids.parts) {
        const auto low = heights_over(part.solid, SurfaceType::kGround, p);
        const auto high = heights_over(part.solid, SurfaceType::kRoof, p);
        for (size_t n = 0; n < std::min(low.size(), high.size()); ++n) {
          filled.emplace_back(low[n], high[n]);
        }
      }
      std::sort(filled.begin(), filled.end());
      for (size_t n = 1; n < filled.size(); ++n) {
        ++points;
        overlaps += filled[n].first < filled[n - 1].second - 0.03;
      }
    }
  }
  EXPECT_EQ(dropped, 0);
  EXPECT_GE(slabs, 200);
  EXPECT_GT(points, 500);
  EXPECT_EQ(overlaps, 0);
}

TEST(RoofSlabs, NastyDerivationsGiveValidSolidsOrAReason) {
  NastyHouses houses(51);
  int left_out = 0;
  for (int i = 0; i < 60; ++i) {
    const HouseSolids solids = valid_slabs(houses.next());
    if (solids.parts.empty()) {
      ASSERT_EQ(solids.dropped.size(), 1u);
      EXPECT_EQ(solids.dropped[0], "roof slabs: no valid solid");
      ++left_out;
    }
  }
  EXPECT_LE(left_out, 3);
}

}  // namespace
}  // namespace gable
