#include <gable/grammar/block.h>
#include <gable/grammar/height_field.h>
#include <gable/residuals/house_pair_relations.h>
#include <gable/residuals/testing/gradient_check.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "residuals/random_houses.h"

namespace gable {
namespace {

using namespace block_value;

std::vector<std::vector<double>> values_of(const House& a, const House& b,
                                           const HousePairRelation& relation) {
  std::vector<std::vector<double>> values;
  for (const auto& [house, rules] :
       {std::pair(&a, &relation.rules_a), std::pair(&b, &relation.rules_b)}) {
    for (int rule : *rules) {
      const auto parameters = house->derivation()[rule]->parameters();
      values.emplace_back(parameters.begin(), parameters.end());
    }
  }
  return values;
}

std::vector<double> residuals_of(const House& a, const House& b,
                                 const HousePairRelation& relation) {
  const auto values = values_of(a, b, relation);
  std::vector<const double*> parameters;
  for (const auto& block : values) parameters.push_back(block.data());
  std::vector<double> residuals(relation.cost->num_residuals());
  EXPECT_TRUE(relation.cost->Evaluate(parameters.data(), residuals.data(), nullptr));
  return residuals;
}

// A box of 10 x 8 m centred on (0, 0) of its frame, which `origin` and `azimuth` place.
House box(const Eigen::Vector3d& origin, double azimuth) {
  House house = make_house(Foundation::kI);
  house.origin = origin;
  house.azimuth[0] = azimuth;
  house.footprints[0].values = {0.0, 0.0, 10.0, 8.0};
  house.roofs[0].values = {5.0, 3.0};
  return house;
}

// The same box as its neighbour at +x, `gap` metres off and `aside` along the wall, in a frame of
// its own that is turned by a quarter turn.
House beside(const House& house, double gap, double aside) {
  House other = house;
  const double c = std::cos(house.azimuth[0]), s = std::sin(house.azimuth[0]);
  const Eigen::Vector2d by(10.0 + gap, aside);
  other.origin += Eigen::Vector3d(c * by.x() - s * by.y(), s * by.x() + c * by.y(), 1.5);
  other.azimuth[0] += 0.5 * M_PI;
  other.footprints[0].values = {0.0, 0.0, 8.0, 10.0};
  for (Rule& roof : other.roofs) roof[param::roof::kEaves] -= 1.5;
  return other;
}

TEST(HousePairRelations, AWallsContactIsWhereTheOtherRunsBesideIt) {
  const House a = box({100.0, 200.0, 30.0}, 0.6), b = beside(a, 0.25, 2.0);
  // House b's x runs along house a's y, so that its wall towards a is y = y1.
  const WallContact contact = wall_contact(a, {0, kX1}, b, {0, kY1});
  EXPECT_NEAR(contact.length, 6.0, 1e-9);
  EXPECT_NEAR(contact.from, 0.25, 1e-9);
  EXPECT_NEAR(contact.to, 1.0, 1e-9);
  EXPECT_NEAR(contact.offset_from, 0.25, 1e-9);
  EXPECT_NEAR(contact.offset_to, 0.25, 1e-9);
  EXPECT_NEAR(contact.angle, 0.0, 1e-9);
  EXPECT_NEAR(wall_contact(a, {0, kX1}, b, {0, kY0}).angle, M_PI, 1e-9);
  EXPECT_NEAR(wall_contact(a, {0, kY0}, b, {0, kY1}).angle, 0.5 * M_PI, 1e-9);
}

TEST(HousePairRelations, APartyWallCountsTheGapAndTheOverlap) {
  const House a = box({100.0, 200.0, 30.0}, 0.6);
  for (double gap : {0.3, 0.0, -0.2}) {
    const House b = beside(a, gap, -1.0);
    for (double r : residuals_of(a, b, party_wall(a, {0, kX1}, b, {0, kY1}, 2.0))) {
      EXPECT_NEAR(r, 2.0 * gap, 1e-9);
    }
    for (double r : residuals_of(b, a, party_wall(b, {0, kY1}, a, {0, kX1}, 2.0))) {
      EXPECT_NEAR(r, 2.0 * gap, 1e-9);
    }
  }
}

TEST(HousePairRelations, HeightsAreComparedAsElevations) {
  const House a = box({0.0, 0.0, 30.0}, 0.0);
  House b = beside(a, 0.0, 0.0);
  EXPECT_NEAR(residuals_of(a, b, equal_eaves(a, 0, b, 0, 1.0))[0], 0.0, 1e-12);
  EXPECT_NEAR(residuals_of(a, b, equal_ridges(a, 0, b, 0, 1.0))[0], 0.0, 1e-12);
  b.origin.z() -= 0.5;
  EXPECT_NEAR(residuals_of(a, b, equal_eaves(a, 0, b, 0, 2.0))[0], 1.0, 1e-12);
  b.roofs[0] = make_rule(RuleKind::kRoofFlat);
  b.roofs[0][param::roof::kEaves] = 7.0;  // at 38 m, where the ridge of a is
  EXPECT_NEAR(residuals_of(a, b, equal_ridges(a, 0, b, 0, 1.0))[0], 0.0, 1e-12);
}

TEST(HousePairRelations, AzimuthsAreComparedModuloAQuarterTurn) {
  House a = box({0.0, 0.0, 0.0}, 0.1), b = box({0.0, 0.0, 0.0}, 0.07);
  for (double turns : {-3.0, -1.0, 0.0, 2.0, 5.0}) {
    b.azimuth[0] = 0.07 + turns * 0.5 * M_PI;
    EXPECT_NEAR(residuals_of(a, b, equal_azimuths(a, b, 3.0))[0], 0.09, 1e-12);
    EXPECT_NEAR(quarter_turns(a, b), -turns * 0.5 * M_PI, 1e-12);
  }
}

TEST(HousePairRelations, ThePointsOfAWallAreThoseOfTheHeightField) {
  Random random(4);
  for (int trial = 0; trial < 300; ++trial) {
    House a = rich_house(kAllFoundations[trial % 5], &random);
    House b = rich_house(kAllFoundations[(trial / 5) % 5], &random);
    a.origin = {random.uniform(-9.0, 9.0), random.uniform(-9.0, 9.0), random.uniform(-1.0, 1.0)};
    const ComponentWall wall_a = {random.integer(0, a.num_components() - 1), random.integer(0, 3)};
    const ComponentWall wall_b = {random.integer(0, b.num_components() - 1), random.integer(0, 3)};
    const WallContact contact = wall_contact(a, wall_a, b, wall_b);
    if (contact.length < 0.1) continue;
    const HeightField field_a(a), field_b(b);
    const Block<double>& block_a = field_a.blocks()[wall_a.component];
    const Block<double>& block_b = field_b.blocks()[wall_b.component];
    const int low = wall_a.side < kY0 ? kY0 : kX0;
    for (const auto& [share, offset] :
         {std::pair(contact.from, contact.offset_from), std::pair(contact.to, contact.offset_to)}) {
      const double along = block_a[low] + share * (block_a[low + 1] - block_a[low]);
      const Eigen::Vector2d p = wall_a.side < kY0 ? Eigen::Vector2d(block_a[wall_a.side], along)
                                                  : Eigen::Vector2d(along, block_a[wall_a.side]);
      const Eigen::Vector2d local_b = field_a.local_from_house(p) + (a.origin - b.origin).head<2>();
      const Eigen::Vector2d q = field_b.house_from_local(local_b);
      const double beyond = (wall_b.side < kY0 ? q.x() : q.y()) - block_b[wall_b.side];
      EXPECT_NEAR(wall_b.side % 2 == 0 ? -beyond : beyond, offset, 1e-9);
    }
  }
}

TEST(Gradient, HousePairRelations) {
  Random random(11);
  double worst = 0.0;
  int walls = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    House a = rich_house(kAllFoundations[trial % 5], &random);
    House b = rich_house(kAllFoundations[(trial / 5) % 5], &random);
    a.origin = {random.uniform(-9.0, 9.0), random.uniform(-9.0, 9.0), random.uniform(-1.0, 1.0)};
    const int i = random.integer(0, a.num_components() - 1);
    const int j = random.integer(0, b.num_components() - 1);
    std::vector<HousePairRelation> relations;
    relations.push_back(equal_eaves(a, i, b, j, 2.0));
    relations.push_back(equal_ridges(a, i, b, j, 0.5));
    relations.push_back(equal_azimuths(a, b, 3.0));
    const ComponentWall wall_a = {i, random.integer(0, 3)}, wall_b = {j, random.integer(0, 3)};
    if (wall_contact(a, wall_a, b, wall_b).length > 0.0) {
      relations.push_back(party_wall(a, wall_a, b, wall_b, 1.5));
      ++walls;
    }
    for (const HousePairRelation& relation : relations) {
      const GradientCheckResult result = check_gradient(*relation.cost, values_of(a, b, relation));
      ASSERT_TRUE(result.evaluated);
      worst = std::max(worst, result.relative_error);
    }
  }
  EXPECT_LT(worst, 1e-6);
  EXPECT_GT(walls, 300);
}

}  // namespace
}  // namespace gable
