#include <gable/engine/io/models/build_model.h>
#include <gable/engine/plan_overlay.h>
#include <gable/engine/reconstruct/building/building_fit.h>
#include <gable/engine/reconstruct/building/model_defect.h>
#include <gable/engine/reconstruct/tile/divide_common_ground.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/row_of_houses.h"

namespace gable {
namespace {

constexpr double kAzimuth = 0.3;

/// Houses of a row that each stand `excess` metres on either neighbour's ground, cut where they
/// truly meet.
std::vector<TileBuilding> overlapping_row(int count, double excess) {
  std::vector<House> houses = row_of_houses(count, kAzimuth);
  const std::vector<HeightImage> images = images_of(houses, {.gsd = 0.5, .size = 40, .noise = 0.0});
  std::vector<TileBuilding> window(count);
  for (int i = 0; i < count; ++i) {
    houses[i].footprints[0].values[i % 3 == 2 ? 3 : 2] += 2.0 * excess;
    TileBuilding& made = window[i];
    made.image = images[i];
    made.building.id = "h" + std::to_string(i);
    made.building.house = houses[i];
    set_fit(fit_of_building(made.image, made.building), &made.building);
    made.model = build_model(made.building);
    for (const double side : {-1.0, 1.0}) {
      if (i + side < 0 || i + side >= count) continue;
      PlanLine cut;
      cut.normal = side * Eigen::Vector2d(std::cos(kAzimuth), std::sin(kAzimuth));
      cut.offset = 3.0;
      made.cuts.push_back(cut);
    }
  }
  return window;
}

/// The ground that a building's solids stand on, world.
PlanShape ground_of(const TileBuilding& made) {
  PlanShape ground;
  for (const PartModel& part : made.model.parts) {
    const Solid& solid = finest_solid(part);
    for (const Face& face : solid.faces) {
      if (face.type != SurfaceType::kGround) continue;
      Ring ring;
      for (const int vertex : face.rings.front()) {
        ring.push_back((solid.vertices[vertex] + made.image.origin).head<2>());
      }
      std::reverse(ring.begin(), ring.end());  // grounds look down
      ground = union_of(ground, {{ring, {}}});
    }
  }
  return ground;
}

double common_ground(const std::vector<TileBuilding>& window) {
  double area = 0.0;
  for (size_t i = 0; i < window.size(); ++i) {
    for (size_t j = 0; j < i; ++j) {
      area += area_of(common_of(ground_of(window[i]), ground_of(window[j])));
    }
  }
  return area;
}

TEST(DivideCommonGround, NoTwoHousesStandOnOneGroundAndAllAreValid) {
  std::vector<TileBuilding> window = overlapping_row(4, 0.4);
  EXPECT_NEAR(common_ground(window), 3 * 0.8 * 9.0, 1e-6);
  divide_common_ground(1, &window);
  EXPECT_NEAR(common_ground(window), 0.0, 1e-6);
  for (size_t i = 0; i < window.size(); ++i) {
    EXPECT_EQ(defect_of(window[i].model), "");
    // Nobody's ground beyond the ends of the row stays the last houses'.
    const bool last = i == 0 || i + 1 == window.size();
    EXPECT_NEAR(area_of(ground_of(window[i])), last ? 54.0 + 0.4 * 9.0 : 54.0, 1e-6) << i;
    EXPECT_LT(window[i].building.quality.mad, 0.05);
  }
}

TEST(DivideCommonGround, AFewCentimetresAreLeftAlone) {
  std::vector<TileBuilding> window = overlapping_row(3, 0.02);
  divide_common_ground(1, &window);
  for (const TileBuilding& made : window) EXPECT_TRUE(made.building.walls.empty());
}

TEST(DivideCommonGround, WithoutCutsGroundStaysWithTheHouseWhosePixelsAreThere) {
  std::vector<TileBuilding> window = overlapping_row(2, 0.0);
  // The first reaches 1.5 m into the second.
  window[0].building.house->footprints[0].values[2] += 3.0;
  for (TileBuilding& made : window) {
    made.model = build_model(made.building);
    made.cuts.clear();
  }
  divide_common_ground(1, &window);
  EXPECT_NEAR(common_ground(window), 0.0, 1e-6);
  EXPECT_TRUE(window[1].building.walls.empty());
  EXPECT_NEAR(area_of(ground_of(window[1])), 54.0, 1e-6);
  EXPECT_NEAR(area_of(ground_of(window[0])), 54.0 + 1.5 * 9.0, 1e-6);
}

TEST(DivideCommonGround, HousesWhoseWallsAreKnownStayAsTheyAre) {
  std::vector<TileBuilding> window = overlapping_row(2, 0.4);
  const PlanPolygon walls = {{{-3, -4}, {3, -4}, {3, 4}, {-3, 4}}, {}};
  for (TileBuilding& made : window) made.building.walls = {walls, 0.0};
  divide_common_ground(1, &window);
  for (const TileBuilding& made : window) {
    EXPECT_EQ(made.building.walls.polygon.outer, walls.outer);
  }
}

TEST(DivideCommonGround, TheResultDoesNotDependOnThreads) {
  std::vector<TileBuilding> one = overlapping_row(6, 0.4), two = one;
  divide_common_ground(1, &one);
  divide_common_ground(3, &two);
  for (size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].building.walls.polygon.outer, two[i].building.walls.polygon.outer);
  }
}

}  // namespace
}  // namespace gable
