#include <gable/engine/evaluate/triangles.h>
#include <gable/engine/io/models/build_model.h>
#include <gable/engine/reconstruct/building/building_fit.h>
#include <gable/engine/reconstruct/building/known_walls.h>
#include <gable/grammar/outlined_house.h>
#include <gable/grammar/random.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "grammar/sample_houses.h"

namespace gable {
namespace {

// What a survey sees of a house that ends at `outline` (local frame): half metre pixels with 3 cm
// of noise over level ground at 0, those inside the outline marked.
HeightImage image_of(const House& house, const PlanPolygon& outline) {
  const OutlinedHouse truth(house, {outline, 1.5});
  HeightImage image;
  image.rows = image.cols = 64;
  const double half = 0.5 * (image.rows - 1) * image.gsd;
  image.first_center = {-half, half};
  image.ground.assign(image.size(), 0.0f);
  image.weight.assign(image.size(), 1.0f);
  Random random(5);
  for (int row = 0; row < image.rows; ++row) {
    for (int col = 0; col < image.cols; ++col) {
      const auto top = truth.at_local(image.center_of(row, col));
      image.height.push_back(static_cast<float>((top ? top->height : 0.0) + random.normal(0.03)));
      image.inside.push_back(top.has_value());
    }
  }
  return image;
}

Building building_of(const House& house) {
  Building building;
  building.house = house;
  return building;
}

double charge(const HeightImage& image, const Building& building, const KnownOutline& walls) {
  Building with = building;
  with.walls = walls;
  return fit_of_building(image, with).charge;
}

double distance_to_nearest(const Eigen::Vector2d& p, const Ring& ring) {
  double least = 1e300;
  for (const Eigen::Vector2d& q : ring) least = std::min(least, (p - q).norm());
  return least;
}

// A ring with a corner every half metre, each off by up to `jitter` metres along x and y.
Ring jittered(const Ring& ring, double jitter) {
  Random random(8);
  Ring out;
  for (size_t i = 0; i < ring.size(); ++i) {
    const Eigen::Vector2d along = ring[(i + 1) % ring.size()] - ring[i];
    const int steps = static_cast<int>(along.norm() / 0.5);
    for (int k = 0; k < steps; ++k) {
      out.push_back(
          ring[i] + along * k / steps +
          Eigen::Vector2d(random.uniform(-jitter, jitter), random.uniform(-jitter, jitter)));
    }
  }
  return out;
}

const House kGabled = box_house(12.0, 8.0, gable_roof(4.0, 3.0, Axis::kX), 0.0);
// Its east wall, to a neighbour, is oblique.
const PlanPolygon kOblique{{{-6.0, -4.0}, {3.5, -4.0}, {6.5, 4.0}, {-6.0, 4.0}}, {}};

TEST(KnownWalls, AnObliquePartyWallIsTakenFromTheOutline) {
  const HeightImage image = image_of(kGabled, kOblique);
  const Building building = building_of(kGabled);
  const KnownOutline walls = known_walls(kOblique, image, building);
  ASSERT_EQ(walls.polygon.outer.size(), 4u);
  for (const Eigen::Vector2d& p : walls.polygon.outer) {
    EXPECT_LT(distance_to_nearest(p, kOblique.outer), 1e-9);
  }
  EXPECT_LT(charge(image, building, walls), 0.05) << "little more than the noise";
  EXPECT_GT(charge(image, building, {}), 0.5);
}

TEST(KnownWalls, OfAnOutlineThatJittersHaveFewCorners) {
  const PlanPolygon drawn{jittered(kOblique.outer, 0.1), {}};
  ASSERT_GT(drawn.outer.size(), 70u);
  const HeightImage image = image_of(kGabled, kOblique);
  const Building building = building_of(kGabled);
  const KnownOutline walls = known_walls(drawn, image, building);
  EXPECT_GE(walls.polygon.outer.size(), 4u);
  EXPECT_LE(walls.polygon.outer.size(), 6u);
  for (const Eigen::Vector2d& corner : kOblique.outer) {
    EXPECT_LT(distance_to_nearest(corner, walls.polygon.outer), 0.6);
  }
  EXPECT_LT(charge(image, building, walls), 0.5 * charge(image, building, {}));
}

TEST(KnownWalls, AreNotNeededWhereTheOutlineIsTheHousesOwn) {
  const PlanPolygon own{{{-6.0, -4.0}, {6.0, -4.0}, {6.0, 4.0}, {-6.0, 4.0}}, {}};
  const HeightImage image = image_of(kGabled, own);
  EXPECT_TRUE(known_walls(own, image, building_of(kGabled)).empty());
}

TEST(KnownWalls, CornersNearTheHousesWallsCutNoSliversOffIt) {
  House house = make_house(Foundation::kII);
  house.footprints = {rectangle_rule(-7.0, 2.0, -4.0, 4.0), rectangle_rule(2.0, 7.0, -3.0, 2.0)};
  house.roofs = {gable_roof(5.0, 3.0, Axis::kY), flat_roof(3.5)};
  const PlanPolygon plan{{{-7.0, -4.0},
                          {2.0, -4.0},
                          {2.0, -3.0},
                          {7.0, -3.0},
                          {7.0, 2.0},
                          {2.0, 2.0},
                          {2.0, 4.0},
                          {-7.0, 4.0}},
                         {}};
  const HeightImage image = image_of(house, plan);
  const Building building = building_of(house);
  const auto triangles = [&](const KnownOutline& walls) {
    Building with = building;
    with.walls = walls;
    int count = 0;
    for (const PartModel& part : build_model(with).parts) {
      count += count_triangles(finest_solid(part));
    }
    return count;
  };
  Random random(2);
  for (int i = 0; i < 10; ++i) {
    PlanPolygon drawn = plan;
    for (Eigen::Vector2d& p : drawn.outer) {
      p += Eigen::Vector2d(random.uniform(-0.15, 0.15), random.uniform(-0.15, 0.15));
    }
    EXPECT_GT(triangles({drawn, 0.0}), triangles({}));
    EXPECT_LE(triangles(known_walls(drawn, image, building)), triangles({}));
  }
}

TEST(KnownWalls, TooFarFromTheHeightsGiveWayToOthers) {
  // A bay of one pixel, too small for its corners to pay.
  const Building building = building_of(kGabled);
  const PlanPolygon bayed{{{-6.0, -4.0},
                           {3.5, -4.0},
                           {6.5, 4.0},
                           {-2.0, 4.0},
                           {-2.0, 4.45},
                           {-2.5, 4.45},
                           {-2.5, 4.0},
                           {-6.0, 4.0}},
                          {}};
  const HeightImage seen = image_of(kGabled, bayed);
  const KnownOutline cheap = known_walls(bayed, seen, building);
  const double distance = charge(seen, building, cheap);
  const double exact = charge(seen, building, {bayed, 0.5});
  ASSERT_GT(distance, exact + 0.005);
  const KnownOutline near = known_walls(bayed, seen, building, 0.5 * (distance + exact));
  EXPECT_LT(charge(seen, building, near), 0.5 * (distance + exact));
  const KnownOutline all_too_far = known_walls(bayed, seen, building, 0.0);
  EXPECT_EQ(charge(seen, building, all_too_far), distance);
}

TEST(KnownWalls, KeepAYard) {
  const House flat = box_house(16.0, 12.0, flat_roof(5.0), 0.0);
  const Ring yard = {{-4.0, -2.0}, {-4.0, 2.5}, {3.0, 2.5}, {3.0, -2.0}};
  const PlanPolygon outline{{{-8.0, -6.0}, {8.0, -6.0}, {8.0, 6.0}, {-8.0, 6.0}}, {yard}};
  const HeightImage image = image_of(flat, outline);
  const KnownOutline walls = known_walls(outline, image, building_of(flat));
  ASSERT_EQ(walls.polygon.holes.size(), 1u);
  ASSERT_EQ(walls.polygon.holes[0].size(), 4u);
  for (const Eigen::Vector2d& p : walls.polygon.holes[0]) {
    EXPECT_LT(distance_to_nearest(p, yard), 1e-9);
  }
  EXPECT_FALSE(OutlinedHouse(flat, walls).at_local({0.0, 0.0}));
}

TEST(KnownWalls, StayOffANeighboursGround) {
  // The house's block reaches half a metre over the party wall, where nothing can be seen of it.
  const House house = box_house(12.0, 8.0, gable_roof(5.0, 3.0, Axis::kX));
  const PlanPolygon outline{{{-6.0, -4.0}, {5.5, -4.0}, {5.5, 4.0}, {-6.0, 4.0}}, {}};
  HeightImage image = image_of(house, outline);
  for (int row = 0; row < image.rows; ++row) {
    for (int col = 0; col < image.cols; ++col) {
      const size_t i = image.index(row, col);
      if (image.center_of(row, col).x() > 5.5) image.weight[i] = 0.05f;
    }
  }
  const Building building = building_of(house);
  EXPECT_GT(fit_of_building(image, building).intrusion, 0.1);
  Building walled = building;
  walled.walls = known_walls(outline, image, building, 100.0);
  ASSERT_FALSE(walled.walls.empty());
  EXPECT_EQ(fit_of_building(image, walled).intrusion, 0.0);
}

TEST(KnownWalls, AnOutlineWithoutAreaGivesNone) {
  const HeightImage image = image_of(kGabled, kOblique);
  const PlanPolygon line{{{-6.0, 0.0}, {6.0, 0.0}, {0.0, 0.0}}, {}};
  EXPECT_TRUE(known_walls(line, image, building_of(kGabled)).empty());
}

}  // namespace
}  // namespace gable
