#include <gable/grammar/height_field.h>
#include <gable/grammar/ring.h>
#include <gable/grammar/solid/block_alignment.h>
#include <gable/grammar/solid/house_solids.h>
#include <gable/grammar/solid/validity.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "grammar/solid/nasty_houses.h"

namespace gable {
namespace {

constexpr double kBase = -0.25;

House one_block(RuleKind kind, const std::array<double, kMaxRuleParameters>& roof) {
  House house = make_house(Foundation::kI);
  house.footprints[0].values = {1.0, 2.0, 10.0, 8.0};
  house.roofs[0] = make_rule(kind);
  house.roofs[0].values = roof;
  house.azimuth[0] = 0.4;
  return house;
}

Rule chimney_at(double x, double y, double side, double height) {
  Rule rule = make_rule(RuleKind::kChimney);
  rule.values = {x, y, side, height};
  return rule;
}

Rule dormer_at(double x, double y, double width, double depth, double eaves, double rise) {
  Rule rule = make_rule(RuleKind::kDormer);
  rule.values = {x, y, width, depth, eaves, rise};
  rule.component = 0;
  return rule;
}

Rule garage_at(double x, double y, double length, double width, double height) {
  Rule rule = make_rule(RuleKind::kGarageI);
  rule.values = {x, y, length, width, height};
  return rule;
}

HouseSolids build(const House& house, Lod lod) {
  HouseSolids solids = build_house_solids(house, lod, kBase);
  for (const HousePart& part : solids.parts) {
    EXPECT_EQ(check_solid(part.solid).describe(), "valid");
  }
  return solids;
}

Solid only_solid(const House& house, Lod lod = Lod::k22) {
  const HouseSolids solids = build(house, lod);
  EXPECT_EQ(solids.parts.size(), 1u);
  EXPECT_TRUE(solids.dropped.empty());
  return solids.parts.empty() ? Solid{} : solids.parts[0].solid;
}

double volume(const Solid& solid) { return check_solid(solid).volume; }

double total_volume(const HouseSolids& solids) {
  double total = 0.0;
  for (const HousePart& part : solids.parts) total += volume(part.solid);
  return total;
}

int count_faces(const Solid& solid, SurfaceType type) {
  return static_cast<int>(std::count_if(solid.faces.begin(), solid.faces.end(),
                                        [type](const Face& f) { return f.type == type; }));
}

void expect_counts(const Solid& solid, int roofs, int walls, int grounds, int vertices) {
  EXPECT_EQ(count_faces(solid, SurfaceType::kRoof), roofs);
  EXPECT_EQ(count_faces(solid, SurfaceType::kWall), walls);
  EXPECT_EQ(count_faces(solid, SurfaceType::kGround), grounds);
  EXPECT_EQ(static_cast<int>(solid.vertices.size()), vertices);
}

// Height of the highest upward face over a point of the local frame, or `ground`.
double top_at(const HouseSolids& solids, const Eigen::Vector2d& p, double ground) {
  double top = ground;
  for (const HousePart& part : solids.parts) {
    for (const Face& face : part.solid.faces) {
      if (face.type != SurfaceType::kRoof) continue;
      int inside = 0;
      for (const std::vector<int>& ring : face.rings) {
        std::vector<Eigen::Vector2d> points;
        for (const int v : ring) points.push_back(part.solid.vertices[v].head<2>());
        inside += ring_holds(points, p);
      }
      if (inside != 1) continue;
      // Plane through the ring's first vertex with its Newell normal.
      const std::vector<int>& ring = face.rings[0];
      const Eigen::Vector3d first = part.solid.vertices[ring[0]];
      Eigen::Vector3d normal = Eigen::Vector3d::Zero();
      for (size_t i = 1; i + 1 < ring.size(); ++i) {
        normal +=
            (part.solid.vertices[ring[i]] - first).cross(part.solid.vertices[ring[i + 1]] - first);
      }
      const double z = first.z() - (normal.head<2>().dot(p - first.head<2>())) / normal.z();
      top = std::max(top, z);
    }
  }
  return top;
}

TEST(HouseSolids, GableHouseHasSevenFacesAndTenVertices) {
  const Solid solid = only_solid(one_block(RuleKind::kRoofGable, {3.0, 2.0}));
  expect_counts(solid, 2, 4, 1, 10);
  EXPECT_NEAR(volume(solid), 80.0 * (3.25 + 1.0), 1e-6);
}

TEST(HouseSolids, FlatTopsOfTheCoarsestLevelStandAtTwoThirdsOfTheRise) {
  const Solid solid = only_solid(one_block(RuleKind::kRoofGable, {3.0, 2.0}), Lod::k12);
  expect_counts(solid, 1, 4, 1, 8);
  EXPECT_NEAR(volume(solid), 80.0 * (3.25 + 4.0 / 3.0), 1e-6);
}

TEST(HouseSolids, HipHouseHasFourRoofFaces) {
  const Solid solid = only_solid(one_block(RuleKind::kRoofHip, {3.0, 2.0, 0.2, 0.4}));
  expect_counts(solid, 4, 4, 1, 10);
  // A gable roof less a pyramid's share at each end: run * width * rise / 6.
  EXPECT_NEAR(volume(solid), 80.0 * 4.25 - (2.0 + 4.0) * 8.0 * 2.0 / 6.0, 1e-6);
}

TEST(HouseSolids, MansardHouseHasFourRoofFacesAndBrokenGables) {
  const Solid solid = only_solid(one_block(RuleKind::kRoofMansard, {3.0, 4.0, 0.75, 0.25}));
  expect_counts(solid, 4, 4, 1, 14);
  // The mean height of a side: 1.5 over a quarter of it, 3.5 over the rest.
  EXPECT_NEAR(volume(solid), 80.0 * (3.25 + 0.25 * 1.5 + 0.75 * 3.5), 1e-6);
}

TEST(HouseSolids, AMansardWhoseSidesAreNotBrokenIsAGable) {
  const Solid solid = only_solid(one_block(RuleKind::kRoofMansard, {3.0, 2.0, 0.5, 0.5}));
  expect_counts(solid, 2, 4, 1, 10);
  EXPECT_NEAR(volume(solid), 80.0 * (3.25 + 1.0), 1e-6);
}

TEST(HouseSolids, HipsOfHalfTheLengthMakeAPyramid) {
  const Solid solid = only_solid(one_block(RuleKind::kRoofHip, {3.0, 2.0, 0.5, 0.5}));
  expect_counts(solid, 4, 4, 1, 9);
  EXPECT_NEAR(volume(solid), 80.0 * (3.25 + 2.0 / 3.0), 1e-6);
}

TEST(HouseSolids, LHouseWithEqualRidgesHasCrossingValleysAndOneGroundFace) {
  House house = make_house(Foundation::kL);
  house.footprints[0].values = {0, 0, 12, 6, 14, 6};
  for (Rule& roof : house.roofs) roof.values = {3.0, 2.0};
  // The ridges cross: each of the four slopes is cut in two by the valleys on the corner square's
  // diagonals, and both outer walls get a gable there.
  expect_counts(only_solid(house), 8, 6, 1, 6 + (6 + 2) + 5);
}

TEST(HouseSolids, LHouseIsOneFlatPrismAtTheCoarsestLevel) {
  House house = make_house(Foundation::kL);
  house.footprints[0].values = {0, 0, 12, 6, 14, 6};
  for (Rule& roof : house.roofs) roof.values = {3.0, 1.5};
  const Solid solid = only_solid(house, Lod::k12);
  expect_counts(solid, 1, 6, 1, 12);
  EXPECT_NEAR(volume(solid), (12 * 6 + 8 * 6) * 4.25, 1e-6);
}

House two_flat_blocks(double x, double y, double height) {
  House house = make_house(Foundation::kII);
  house.footprints[0].values = {0, 0, 10, 8};
  house.footprints[1].values = {x, y, 4, 4};
  for (Rule& roof : house.roofs) roof = make_rule(RuleKind::kRoofFlat);
  house.roofs[0].values = {3.0};
  house.roofs[1].values = {height};
  return house;
}

TEST(HouseSolids, TouchingBlocksFormOneBody) {
  const Solid solid = only_solid(two_flat_blocks(7.0, 0.0, 5.0));
  // The higher block leaves two pieces of the lower one's wall, and has its own over the roof.
  expect_counts(solid, 2, 3 + 2 + 1 + 3, 1, 8 + 6 + 4);
  EXPECT_NEAR(volume(solid), 80 * 3.25 + 16 * 5.25, 1e-6);
}

TEST(HouseSolids, TowerInTheMiddleLeavesAHoleInTheRoof) {
  const Solid solid = only_solid(two_flat_blocks(1.0, 0.5, 5.0));
  expect_counts(solid, 2, 8, 1, 16);
  EXPECT_NEAR(volume(solid), 80 * 3.25 + 16 * 2, 1e-6);
  const auto holed = std::count_if(solid.faces.begin(), solid.faces.end(),
                                   [](const Face& f) { return f.rings.size() == 2; });
  EXPECT_EQ(holed, 1);
}

TEST(HouseSolids, CoveredBlockDoesNotShow) {
  expect_counts(only_solid(two_flat_blocks(1.0, 0.5, 2.0)), 1, 4, 1, 8);
}

TEST(HouseSolids, BlocksThatMeetInACornerOrNotAtAllAreTwoBodiesInOrder) {
  for (const double y : {6.0, 9.0}) {
    const HouseSolids solids = build(two_flat_blocks(7.0, y, 5.0), Lod::k22);
    ASSERT_EQ(solids.parts.size(), 2u);
    EXPECT_EQ(solids.parts[0].index, 0);
    EXPECT_EQ(solids.parts[1].index, 1);
    EXPECT_NEAR(volume(solids.parts[0].solid), 80 * 3.25, 1e-6);
    EXPECT_NEAR(volume(solids.parts[1].solid), 16 * 5.25, 1e-6);
  }
}

TEST(HouseSolids, NearlyEqualEdgesBecomeEqual) {
  for (const double miss : {1e-9, 1e-6, 1e-4, 1e-3, 5e-3, 1.5e-2}) {
    for (const double sign : {-1.0, 1.0}) {
      House house = two_flat_blocks(7.0 + sign * miss, 0.0, 3.0 + 0.4 * sign * miss);
      house.footprints[1].values[3] = 8.0 + sign * miss;
      expect_counts(only_solid(house), 1, 4, 1, 8);
    }
  }
}

TEST(HouseSolids, ChimneyOnTheRidgeStandsOnBothSlopes) {
  House house = one_block(RuleKind::kRoofGable, {3.0, 2.0});
  house.chimneys.push_back(chimney_at(1.0, 2.0, 1.0, 6.0));
  const HouseSolids solids = build(house, Lod::k22);
  ASSERT_EQ(solids.parts.size(), 2u);
  EXPECT_EQ(solids.parts[1].role, PartRole::kChimney);
  expect_counts(solids.parts[1].solid, 1, 4, 2, 10);
  EXPECT_NEAR(volume(solids.parts[1].solid), 1.0 + 0.5 * 0.25, 1e-6);
}

TEST(HouseSolids, ChimneyAtTheGableStandsOnTheGroundOutside) {
  House house = one_block(RuleKind::kRoofGable, {3.0, 2.0});
  house.chimneys.push_back(chimney_at(6.0, 2.0, 1.0, 6.0));
  const HouseSolids solids = build(house, Lod::k22);
  ASSERT_EQ(solids.parts.size(), 2u);
  EXPECT_NEAR(volume(solids.parts[1].solid), 0.5 * 6.25 + 0.5 * (1.0 + 0.125), 1e-6);
}

TEST(HouseSolids, ChimneyInsideTheAtticIsDropped) {
  House house = one_block(RuleKind::kRoofGable, {3.0, 2.0});
  house.chimneys.push_back(chimney_at(1.0, 2.0, 1.0, 4.0));
  const HouseSolids solids = build(house, Lod::k22);
  EXPECT_EQ(solids.parts.size(), 1u);
  ASSERT_EQ(solids.dropped.size(), 1u);
  EXPECT_EQ(solids.dropped[0], "chimney 1: nothing shows above what stands below");
}

TEST(HouseSolids, DormerRunsIntoTheSlope) {
  House house = one_block(RuleKind::kRoofGable, {3.0, 2.0});
  house.dormers.push_back(dormer_at(1.0, 4.5, 2.0, 2.5, 4.2, 0.1));
  const HouseSolids solids = build(house, Lod::k22);
  ASSERT_EQ(solids.parts.size(), 2u);
  EXPECT_EQ(solids.parts[1].role, PartRole::kDormer);
  // Two roofs, a gable with its two cheeks, and the slope below.
  expect_counts(solids.parts[1].solid, 2, 3, 1, 8);
}

TEST(HouseSolids, DormerOverTheEavesEndsAtTheWall) {
  House house = one_block(RuleKind::kRoofFlat, {3.0});
  house.dormers.push_back(dormer_at(1.0, 6.0, 2.0, 2.0, 4.0, 0.0));
  const HouseSolids solids = build(house, Lod::k22);
  ASSERT_EQ(solids.parts.size(), 2u);
  EXPECT_NEAR(volume(solids.parts[1].solid), 2.0 * 1.0 * 1.0, 1e-6);
}

TEST(HouseSolids, GarageIsCutByTheHouse) {
  House house = one_block(RuleKind::kRoofGable, {3.0, 2.0});
  house.garages.push_back(garage_at(6.0, 2.0, 4.0, 3.0, 2.5));
  const HouseSolids solids = build(house, Lod::k20);
  ASSERT_EQ(solids.parts.size(), 2u);
  EXPECT_EQ(solids.parts[1].role, PartRole::kGarage);
  expect_counts(solids.parts[1].solid, 1, 4, 1, 8);
  EXPECT_NEAR(volume(solids.parts[1].solid), 2.0 * 3.0 * 2.75, 1e-6);
}

TEST(HouseSolids, GarageUnderTheRoofIsDropped) {
  House house = one_block(RuleKind::kRoofGable, {3.0, 2.0});
  house.garages.push_back(garage_at(1.0, 2.0, 4.0, 3.0, 2.5));
  const HouseSolids solids = build(house, Lod::k12);
  EXPECT_EQ(solids.parts.size(), 1u);
  EXPECT_EQ(solids.dropped.size(), 1u);
}

TEST(HouseSolids, GarageAcrossTheHouseFallsInTwo) {
  House house = one_block(RuleKind::kRoofGable, {3.0, 2.0});
  house.garages.push_back(garage_at(1.0, 2.0, 20.0, 3.0, 2.5));
  const HouseSolids solids = build(house, Lod::k20);
  ASSERT_EQ(solids.parts.size(), 3u);
  EXPECT_EQ(solids.parts[1].index, 0);
  EXPECT_EQ(solids.parts[2].index, 0);
  EXPECT_NEAR(total_volume(solids), 80 * 4.25 + 10 * 3 * 2.75, 1e-6);
}

TEST(HouseSolids, ParametersThatAreNotNumbersGiveAReason) {
  House house = one_block(RuleKind::kRoofGable, {3.0, 2.0});
  house.roofs[0].values[0] = std::numeric_limits<double>::quiet_NaN();
  const HouseSolids solids = build(house, Lod::k22);
  EXPECT_TRUE(solids.parts.empty());
  EXPECT_EQ(solids.dropped.size(), 1u);
}

// Whether alignment leaves every block where it is.
bool is_aligned(const House& house) {
  const std::vector<Block<double>> blocks = expand_blocks(house);
  const std::vector<Block<double>> aligned = BlockAlignment(blocks, kBase).blocks();
  for (size_t i = 0; i < blocks.size(); ++i) {
    if (blocks[i].flat != aligned[i].flat) return false;
    for (int k = 0; k < kNumBlockValues; ++k) {
      if (std::abs(blocks[i][k] - aligned[i][k]) > 1e-9) return false;
    }
  }
  return true;
}

// Whether a point of the house frame lies within 1 cm of the line of some block's edge.
bool near_edge(const std::vector<Block<double>>& blocks, const Eigen::Vector2d& p) {
  using namespace block_value;
  for (const Block<double>& block : blocks) {
    for (const int k : {kX0, kX1}) {
      if (std::abs(p.x() - block[k]) < 0.01) return true;
    }
    for (const int k : {kY0, kY1}) {
      if (std::abs(p.y() - block[k]) < 0.01) return true;
    }
  }
  return false;
}

TEST(HouseSolids, RoofsFollowTheHeightField) {
  NastyHouses houses(11);
  Random random(12);
  int houses_compared = 0, points_compared = 0;
  for (int i = 0; i < 1500; ++i) {
    const House house = houses.next();
    if (!is_aligned(house)) continue;
    ++houses_compared;
    const HeightField field(house);
    const HouseSolids solids = build_house_solids(house, Lod::k22, kBase);
    for (int k = 0; k < 100; ++k) {
      const Eigen::Vector2d p(random.uniform(-15, 25), random.uniform(-15, 25));
      if (near_edge(field.blocks(), p)) continue;
      const Eigen::Vector2d local = field.local_from_house(p);
      ASSERT_NEAR(top_at(solids, local, kBase), field.at_local(local, 0.0, kBase), 0.01)
          << "house " << i << " at " << p.transpose();
      ++points_compared;
    }
  }
  EXPECT_GT(houses_compared, 100);
  EXPECT_GT(points_compared, 10000);
}

// Integral of the height field above the base: midpoint rule on the cells between all edges, where
// the field is continuous.
double integral(const HeightField& field) {
  using namespace block_value;
  std::vector<double> x, y;
  for (const Block<double>& block : field.blocks()) {
    if (block[kX0] < block[kX1]) x.insert(x.end(), {block[kX0], block[kX1]});
    if (block[kY0] < block[kY1]) y.insert(y.end(), {block[kY0], block[kY1]});
  }
  std::sort(x.begin(), x.end());
  std::sort(y.begin(), y.end());
  constexpr int n = 20;
  double sum = 0.0;
  for (size_t i = 0; i + 1 < x.size(); ++i) {
    for (size_t j = 0; j + 1 < y.size(); ++j) {
      const double dx = (x[i + 1] - x[i]) / n, dy = (y[j + 1] - y[j]) / n;
      for (int k = 0; k < n * n; ++k) {
        const Eigen::Vector2d p(x[i] + (k % n + 0.5) * dx, y[j] + (k / n + 0.5) * dy);
        sum += (field.at_house(p, 0.0, kBase) - kBase) * dx * dy;
      }
    }
  }
  return sum;
}

TEST(HouseSolids, PartsTogetherHoldTheVolumeUnderTheHeightField) {
  NastyHouses houses(21);
  int compared = 0;
  for (int i = 0; i < 2000; ++i) {
    const House house = houses.next();
    if (!is_aligned(house)) continue;
    ++compared;
    const double expected = integral(HeightField(house));
    EXPECT_NEAR(total_volume(build_house_solids(house, Lod::k22, kBase)), expected,
                2e-3 * expected);
  }
  EXPECT_GT(compared, 80);
}

Solid rounded(const Solid& solid, const Eigen::Vector3d& offset) {
  Solid result = solid;
  for (Eigen::Vector3d& p : result.vertices) {
    for (int k = 0; k < 3; ++k) p[k] = std::round((p[k] + offset[k]) * 1e4) * 1e-4;
  }
  return result;
}

TEST(HouseSolids, TwoThousandNastyDerivationsAreValidAtEveryLevel) {
  NastyHouses houses(31);
  Random random(32);
  for (int i = 0; i < 2000; ++i) {
    const House house = houses.next();
    for (const Lod lod : {Lod::k12, Lod::k20, Lod::k22}) {
      const HouseSolids solids = build_house_solids(house, lod, kBase);
      ASSERT_FALSE(solids.parts.empty());
      EXPECT_EQ(solids.parts[0].role, PartRole::kMain);
      for (const std::string& line : solids.dropped) {
        EXPECT_EQ(line.find("valid"), std::string::npos) << "house " << i << ": " << line;
      }
      for (const HousePart& part : solids.parts) {
        EXPECT_EQ(check_solid(part.solid).describe(), "valid") << "house " << i;
        // As a file stores it: 0.1 mm steps from some corner of a map. Rounding may take the tenth
        // of a millimetre off the resolution that the builder keeps.
        const Eigen::Vector3d offset(random.uniform(0, 1), random.uniform(0, 1), 0.0);
        EXPECT_EQ(check_solid(rounded(part.solid, offset), {1e-3, 2.8e-3}).describe(), "valid")
            << "house " << i;
      }
    }
  }
}

TEST(HouseSolids, NastyDerivationsOfFourToEightBlocksAreValidAndNearlyAllHaveTheirRoofs) {
  NastyHouses houses(33);
  int flattened = 0, unbuilt = 0;
  for (int i = 0; i < 300; ++i) {
    const House house = houses.next_of_many();
    ASSERT_TRUE(is_well_formed(house));
    for (const Lod lod : {Lod::k12, Lod::k22}) {
      const HouseSolids solids = build_house_solids(house, lod, kBase);
      unbuilt += solids.parts.empty();
      for (const std::string& line : solids.dropped) {
        flattened += line.find("valid") != std::string::npos;
      }
      for (const HousePart& part : solids.parts) {
        EXPECT_EQ(check_solid(part.solid).describe(), "valid") << "house " << i;
      }
    }
  }
  // So many blocks hide and cut one another in features too fine to build now and then.
  EXPECT_LE(flattened, 12) << "of 600";
  EXPECT_LE(unbuilt, 1) << "of 600";
}

TEST(HouseSolids, SameHouseGivesTheSameSolids) {
  NastyHouses houses(41);
  for (int i = 0; i < 50; ++i) {
    const House house = houses.next();
    const HouseSolids once = build_house_solids(house, Lod::k22, kBase);
    const HouseSolids again = build_house_solids(house, Lod::k22, kBase);
    ASSERT_EQ(once.parts.size(), again.parts.size());
    for (size_t p = 0; p < once.parts.size(); ++p) {
      EXPECT_EQ(once.parts[p].solid.vertices, again.parts[p].solid.vertices);
    }
  }
}

}  // namespace
}  // namespace gable
