#include <gable/grammar/height_field.h>
#include <gable/residuals/outline_to_footprint.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "residuals/random_houses.h"

namespace gable {
namespace {

std::vector<double> residuals_of(const House& house, const std::vector<Eigen::Vector2d>& outline,
                                 const OutlineOptions& options) {
  const OutlineToFootprint cost(house, outline, options);
  std::vector<double> residuals(cost.num_residuals());
  EXPECT_TRUE(cost.Evaluate(pointers(house).data(), residuals.data(), nullptr));
  return residuals;
}

TEST(OutlineToFootprint, IsZeroOnTheOutlineOfTheHouseItself) {
  House house = make_house(Foundation::kL);
  house.azimuth[0] = 0.7;
  house.footprints[0].values = {-3.0, -2.0, 12.0, 5.0, 9.0, 6.0};
  const HeightField field(house);
  std::vector<Eigen::Vector2d> outline;
  for (const Eigen::Vector2d& p : std::vector<Eigen::Vector2d>{
           {-3.0, -2.0}, {9.0, -2.0}, {9.0, 3.0}, {3.0, 3.0}, {3.0, 7.0}, {-3.0, 7.0}}) {
    outline.push_back(field.local_from_house(p));
  }
  for (double r : residuals_of(house, outline, {})) EXPECT_NEAR(r, 0.0, 1e-14);
}

TEST(OutlineToFootprint, SquaresIntegrateTheRobustDistanceAlongTheOutline) {
  House house = make_house(Foundation::kI);
  house.footprints[0].values = {0.0, 0.0, 10.0, 8.0};
  // One metre further out along the whole length: distance 1 along 10 m, inside elsewhere.
  const std::vector<Eigen::Vector2d> outline = {{-5.0, -4.0}, {5.0, -4.0}, {5.0, 5.0}, {-5.0, 5.0}};
  double sum = 0.0;
  for (double r : residuals_of(house, outline, {0.25, 1.0, 3.0})) sum += r * r;
  // The two sides stick out by up to 1 m: integral of rho over [0, 1] twice.
  const RobustLoss loss(LossKind::kSoftL1, 1.0);
  double sides = 0.0;
  for (int i = 0; i < 4; ++i) sides += 2.0 * 0.25 * loss.cost(0.25 * (i + 0.5));
  EXPECT_NEAR(sum, 3.0 * (10.0 * loss.cost(1.0) + sides), 1e-9);
}

TEST(OutlineToFootprint, DistanceOutsideIsTheNearestOfManyEdgePoints) {
  Random random(3);
  for (int trial = 0; trial < 200; ++trial) {
    const double x0 = random.uniform(-5.0, 0.0), x1 = random.uniform(1.0, 5.0);
    const double y0 = random.uniform(-5.0, 0.0), y1 = random.uniform(1.0, 5.0);
    const double x = random.uniform(-9.0, 9.0), y = random.uniform(-9.0, 9.0);
    double nearest = 1e9;
    for (int i = 0; i <= 2000; ++i) {
      const double ex = x0 + (x1 - x0) * i / 2000.0, ey = y0 + (y1 - y0) * i / 2000.0;
      for (double d : {std::hypot(x - ex, y - y0), std::hypot(x - ex, y - y1),
                       std::hypot(x - x0, y - ey), std::hypot(x - x1, y - ey)}) {
        nearest = std::min(nearest, d);
      }
    }
    const bool inside = x > x0 && x < x1 && y > y0 && y < y1;
    EXPECT_NEAR(rectangle_distance(x0, x1, y0, y1, x, y), inside ? -nearest : nearest, 5e-3);
  }
}

}  // namespace
}  // namespace gable
