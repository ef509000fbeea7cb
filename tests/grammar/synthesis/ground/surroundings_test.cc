#include <gable/grammar/synthesis/ground/surroundings.h>
#include <gable/grammar/synthesis/houses/plan_union.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace gable {
namespace {

/// An L, anticlockwise.
const PlanRing kOutline = {{0, 0}, {14, 0}, {14, 6}, {6, 6}, {6, 12}, {0, 12}};

double distance_of(const Eigen::Vector2d& p) { return ring_distance(kOutline, {p, p, p}); }

SiteGround make_ground() {
  Random random(1);
  return SiteGround({5.0, 5.0}, &random);
}

TEST(Surroundings, CarsStandInFrontOfTheHouseOnTheGround) {
  const SiteGround ground = make_ground();
  Random random(2);
  size_t made = 0;
  for (int i = 0; i < 200; ++i) {
    for (const BuiltPart& part : random_cars(kOutline, ground, &random).parts) {
      ++made;
      EXPECT_GE(ring_distance(kOutline, part.ring()), 0.7);
      EXPECT_LE(distance_of(part.center), 6.5);  // cabins sit back by half a metre
      const double height = part.eaves - ground.at(part.center);
      EXPECT_GT(height, 0.8);
      EXPECT_LT(height, 2.5);
    }
  }
  EXPECT_GT(made, 200u);
}

TEST(Surroundings, ShedsAreLowAndClearOfTheHouse) {
  const SiteGround ground = make_ground();
  Random random(3);
  int made = 0, close = 0;
  for (int i = 0; i < 200; ++i) {
    for (const BuiltPart& part : random_sheds(kOutline, ground, &random).parts) {
      ++made;
      const double top = part.eaves + part.rise - ground.at(part.center);
      EXPECT_GE(top, 2.0 - 1e-9);
      EXPECT_LE(top, 2.6 + 1e-9);
      EXPECT_GE(ring_distance(kOutline, part.ring()), 0.4);
      close += ring_distance(kOutline, part.ring()) < 1.5;
    }
  }
  EXPECT_GT(made, 200);
  EXPECT_GT(close, made / 5);
}

TEST(Surroundings, TreesOverWallsReachOverThem) {
  Random random(4);
  int mostly = 0, made = 0;
  for (int i = 0; i < 200; ++i) {
    Greenery greenery;
    plant_trees_over_walls(kOutline, &random, &greenery);
    for (const Tree& tree : greenery.trees) {
      const double over = tree.radius - distance_of(tree.center);
      EXPECT_GE(over, -0.06);
      EXPECT_LE(over, 2.2 + 1e-6);
      mostly += over <= 1.0;
      ++made;
    }
  }
  EXPECT_GT(made, 200);
  EXPECT_GT(mostly, made * 3 / 4);
}

TEST(Surroundings, GardensKeepClearOfTheHouse) {
  Random random(5);
  size_t trees = 0, hedges = 0;
  for (int i = 0; i < 200; ++i) {
    Greenery greenery;
    plant_garden(kOutline, &random, &greenery);
    for (const Tree& tree : greenery.trees) EXPECT_GT(distance_of(tree.center), tree.radius);
    for (const Hedge& hedge : greenery.hedges) {
      EXPECT_GT(ring_distance(kOutline, {hedge.from, hedge.to, hedge.to}), 0.0);
      EXPECT_LE(hedge.height, 2.0);
    }
    trees += greenery.trees.size();
    hedges += greenery.hedges.size();
  }
  EXPECT_GT(trees, 200u);
  EXPECT_GT(hedges, 100u);
}

TEST(Surroundings, GrovesAreHighAtTheirCentre) {
  for (uint64_t seed = 0; seed < 100; ++seed) {
    Random random(seed);
    const Greenery grove = random_grove({3.0, 4.0}, &random);
    double nearest = INFINITY;
    for (const Tree& tree : grove.trees) {
      EXPECT_GE(tree.height, 4.0);
      nearest = std::min(nearest, (tree.center - Eigen::Vector2d(3.0, 4.0)).norm() - tree.radius);
    }
    for (const Hedge& hedge : grove.hedges) {
      EXPECT_GE(hedge.height, 2.3);
      const Eigen::Vector2d p(3.0, 4.0);
      nearest = std::min(nearest,
                         ring_distance({hedge.from, hedge.to, hedge.to}, {p, p, p}) - hedge.width);
    }
    EXPECT_LT(nearest, 0.0) << seed;
  }
}

}  // namespace
}  // namespace gable
