#include <gable/engine/scales/outline/inlier_polygon.h>
#include <gable/engine/scales/outline/outlined_region.h>
#include <gable/engine/scales/outline/plane_frame.h>
#include <gable/engine/scales/outline/ring_simplification.h>
#include <gable/grammar/random.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <ctime>
#include <functional>
#include <string>

#include "engine/scales/outline/polygon_measures.h"

namespace gable {
namespace {

using Inside = std::function<bool(double, double)>;

/// Random points of the square from 0 to `size` that `inside` keeps, on z = 0.
std::vector<Eigen::Vector3d> sampled(double size, int count, const Inside& inside,
                                     uint64_t seed = 1) {
  Random random(seed);
  std::vector<Eigen::Vector3d> points;
  while (static_cast<int>(points.size()) < count) {
    const double x = random.uniform(0.0, size), y = random.uniform(0.0, size);
    if (inside(x, y)) points.emplace_back(x, y, 0.0);
  }
  return points;
}

bool everywhere(double, double) { return true; }

TEST(InlierPolygon, OfASampledRectangleHasItsArea) {
  for (const int count : {500, 5000, 50000}) {
    const auto points = sampled(10.0, count, [](double, double y) { return y < 4.0; });
    const std::vector<SpacePolygon> polygons = inlier_polygons(points, kLevel);
    ASSERT_EQ(polygons.size(), 1u) << count;
    EXPECT_TRUE(polygons[0].holes.empty()) << count;
    EXPECT_NEAR(total_area(polygons), 40.0, 0.03 * 40.0) << count;
  }
}

TEST(InlierPolygon, OfAGridIsTheUnionOfItsCells) {
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 40; ++i) {
    for (int j = 0; j < 20; ++j) points.emplace_back(0.25 * (i + 0.5), 0.25 * (j + 0.5), 0.0);
  }
  const auto polygons = inlier_polygons(points, kLevel, {.spacing = 0.25});
  ASSERT_EQ(polygons.size(), 1u);
  EXPECT_NEAR(total_area(polygons), 50.0, 0.02 * 50.0);
  EXPECT_LE(polygons[0].outer.size(), 12u);
}

TEST(InlierPolygon, KeepsTheNotchOfAnL) {
  const auto points = sampled(10.0, 8000, [](double x, double y) { return x < 4.0 || y < 3.0; });
  const auto polygons = inlier_polygons(points, kLevel);
  ASSERT_EQ(polygons.size(), 1u);
  EXPECT_NEAR(total_area(polygons), 58.0, 0.03 * 58.0);
  EXPECT_FALSE(covers(polygons, 4.6, 3.6));
  EXPECT_TRUE(covers(polygons, 3.6, 3.6));
  EXPECT_TRUE(covers(polygons, 9.5, 2.5));
}

TEST(InlierPolygon, KeepsAHole) {
  const auto points = sampled(10.0, 8000, [](double x, double y) {
    return std::abs(x - 5.0) > 2.0 || std::abs(y - 5.0) > 1.5;
  });
  const auto polygons = inlier_polygons(points, kLevel);
  ASSERT_EQ(polygons.size(), 1u);
  ASSERT_EQ(polygons[0].holes.size(), 1u);
  EXPECT_NEAR(total_area(polygons), 88.0, 0.03 * 88.0);
  EXPECT_FALSE(covers(polygons, 5.0, 5.0));
}

TEST(InlierPolygon, MakesAPolygonOfEachIsland) {
  const auto points = sampled(10.0, 8000, [](double x, double) { return x < 6.0 || x > 7.0; });
  const auto polygons = inlier_polygons(points, kLevel);
  ASSERT_EQ(polygons.size(), 2u);
  EXPECT_NEAR(area_of(polygons[0]), 60.0, 0.03 * 60.0);
  EXPECT_NEAR(area_of(polygons[1]), 30.0, 0.03 * 30.0);
}

TEST(InlierPolygon, RunsAnticlockwiseAgainstTheNormalAndLiesOnThePlane) {
  const auto flat =
      sampled(10.0, 5000, [](double x, double y) { return std::hypot(x - 5.0, y - 5.0) > 1.5; });
  const PlaneFrame frame(OrientedPlane(Eigen::Vector3d(0.36, -0.48, 0.8), 7.0),
                         Eigen::Vector3d(3.0, 4.0, 5.0));
  const Eigen::Vector3d normal(0.36, -0.48, 0.8);
  std::vector<Eigen::Vector3d> points;
  for (const Eigen::Vector3d& p : flat) {
    points.push_back(frame.lift(p.head<2>()) + 0.05 * std::sin(9.0 * p.x()) * normal);
  }
  for (const double side : {1.0, -1.0}) {
    const OrientedPlane plane(side * normal, side * 7.0);
    const auto polygons = inlier_polygons(points, plane);
    ASSERT_EQ(polygons.size(), 1u);
    ASSERT_EQ(polygons[0].holes.size(), 1u);
    const PlaneFrame seen(plane, points[0]);
    const std::vector<Ring> rings = rings_of(polygons, seen);
    EXPECT_GT(signed_area(rings[0]), 0.0);
    EXPECT_LT(signed_area(rings[1]), 0.0);
    for (const Eigen::Vector3d& p : polygons[0].outer) {
      EXPECT_NEAR(plane.signed_distance(p), 0.0, 1e-9);
    }
  }
}

TEST(InlierPolygon, IsTheSameFarFromTheOrigin) {
  const auto inside = [](double x, double y) { return x < 4.0 || y < 3.0; };
  const auto points = sampled(10.0, 6000, inside);
  const Eigen::Matrix3d turn = (Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitZ()) *
                                Eigen::AngleAxisd(0.9, Eigen::Vector3d(1.0, 2.0, 0.5).normalized()))
                                   .toRotationMatrix();
  const Eigen::Vector3d shift(85000.0, 447000.0, 12.0);
  std::vector<Eigen::Vector3d> moved;
  for (const Eigen::Vector3d& p : points) moved.push_back(turn * p + shift);
  const Eigen::Vector3d normal = turn.col(2);
  const auto polygons = inlier_polygons(moved, OrientedPlane(normal, normal.dot(shift)));
  ASSERT_EQ(polygons.size(), 1u);
  EXPECT_NEAR(area_of(polygons[0]), 58.0, 0.03 * 58.0);
  EXPECT_NEAR(area_of(polygons[0]), total_area(inlier_polygons(points, kLevel)), 0.01 * 58.0);
}

TEST(InlierPolygon, HasSimpleRingsHoweverRaggedThePoints) {
  for (uint64_t seed = 1; seed <= 20; ++seed) {
    // Sparser and sparser to the right: islands, bays and holes of all sizes.
    Random random(seed);
    std::vector<Eigen::Vector3d> points;
    for (int i = 0; i < 3000; ++i) {
      const double x = random.uniform(0.0, 1.0);
      points.emplace_back(10.0 * x * x, random.uniform(0.0, 10.0), 0.0);
    }
    const auto polygons = inlier_polygons(points, kLevel, {.spacing = 0.05});
    const std::vector<Ring> rings = rings_of(polygons, PlaneFrame(kLevel, points[0]));
    EXPECT_TRUE(are_simple(rings)) << seed;
    EXPECT_GT(polygons.size(), 10u);
    EXPECT_GT(rings.size(), polygons.size() + 10u);
  }
}

TEST(InlierPolygon, OfPointsWithoutWidthIsNone) {
  using Points = std::vector<Eigen::Vector3d>;
  EXPECT_TRUE(inlier_polygons(Points{}, kLevel).empty());
  EXPECT_TRUE(inlier_polygons(Points{{1.0, 2.0, 0.0}}, kLevel).empty());
  EXPECT_TRUE(inlier_polygons(Points{{1.0, 2.0, 0.0}, {2.0, 2.0, 0.0}}, kLevel).empty());
  EXPECT_TRUE(inlier_polygons(Points(100, {1.0, 2.0, 0.0}), kLevel).empty());
  EXPECT_TRUE(inlier_polygons(Points(100, {1.0, 2.0, 0.0}), kLevel, {.spacing = 0.1}).empty());
  for (const double angle : {0.0, 0.3, 0.785, 1.2}) {
    Points line;
    for (int i = 0; i < 500; ++i) {
      line.emplace_back(0.02 * i * std::cos(angle), 0.02 * i * std::sin(angle), 0.0);
    }
    EXPECT_TRUE(inlier_polygons(line, kLevel).empty()) << angle;
    EXPECT_TRUE(inlier_polygons(line, kLevel, {.spacing = 0.1}).empty()) << angle;
  }
}

TEST(InlierPolygon, OfManyPointsIsFast) {
  const auto points = sampled(100.0, 300000, everywhere);
  const std::clock_t start = std::clock();
  const auto polygons = inlier_polygons(points, kLevel);
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
#ifdef NDEBUG
  EXPECT_LT(seconds, 0.5);
#endif
  RecordProperty("seconds", std::to_string(seconds));
  ASSERT_EQ(polygons.size(), 1u);
  EXPECT_NEAR(area_of(polygons[0]), 1e4, 0.03 * 1e4);
}

TEST(PlanarSpacing, OfAGridIsNearItsCell) {
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 60; ++i) {
    for (int j = 0; j < 60; ++j) points.emplace_back(0.2 * i, 0.2 * j, 0.0);
  }
  EXPECT_NEAR(planar_spacing(points, kLevel), 0.2, 0.04);
}

TEST(InlierPolygonOptions, CheckNamesTheViolatedBound) {
  EXPECT_EQ(check(InlierPolygonOptions{}), "");
  EXPECT_THAT(check(InlierPolygonOptions{.spacing = -0.1}), testing::HasSubstr("spacing"));
}

}  // namespace
}  // namespace gable
