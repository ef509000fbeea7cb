#include <gable/engine/scales/outline/facet_polygon.h>
#include <gable/engine/scales/outline/outlined_region.h>
#include <gable/engine/scales/outline/plane_frame.h>
#include <gable/grammar/random.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "engine/scales/outline/polygon_measures.h"

namespace gable {
namespace {

Scan mesh_of(const std::vector<Eigen::Vector3d>& points,
             const std::vector<std::vector<int>>& facets) {
  Scan mesh;
  mesh.points = points;
  for (const auto& facet : facets) mesh.facets.add(facet);
  return mesh;
}

TEST(FacetPolygon, IsTheUnionOfFacetsThatMeetOverlapOrDegenerate) {
  const Scan mesh = mesh_of({{0, 0, 0},
                             {4, 0, 0},
                             {4, 3, 0.1},
                             {0, 3, -0.1},
                             {2, 1, 0},
                             {6, 1, 0},
                             {6, 2, 0},
                             {2, 2, 0},
                             {1, 1, 9}},
                            {{0, 1, 2}, {0, 2, 3}, {4, 5, 6, 7}, {0, 0, 1}, {0, 1, 1}});
  const std::vector<int> all{0, 1, 2, 3, 4};
  const auto polygons = facet_polygons(mesh, all, kLevel);
  ASSERT_EQ(polygons.size(), 1u);
  EXPECT_NEAR(total_area(polygons), 14.0, 0.01 * 14.0);
  EXPECT_TRUE(polygons[0].holes.empty());
  EXPECT_TRUE(covers(polygons, 5.9, 1.5));
  EXPECT_FALSE(covers(polygons, 5.0, 0.5));
  const std::vector<int> degenerate{3, 4};
  EXPECT_TRUE(facet_polygons(mesh, degenerate, kLevel).empty());
  EXPECT_TRUE(facet_polygons(mesh, {}, kLevel).empty());
  const OrientedPlane upright(Eigen::Vector3d::UnitX(), 0.0);
  const std::vector<int> level{2};
  EXPECT_TRUE(facet_polygons(mesh, level, upright).empty());
}

TEST(FacetPolygon, HasExactlyTheCornersOfFacetsThatMeet) {
  const Scan mesh = mesh_of({{0, 0, 0}, {10, 0, 0}, {10, 5, 0}, {0, 5, 0}, {5, 0, 0}},
                            {{0, 4, 3}, {3, 4, 2}, {2, 4, 1}});
  const std::vector<int> all{0, 1, 2};
  for (const double side : {1.0, -1.0}) {
    const auto polygons =
        facet_polygons(mesh, all, OrientedPlane(side * Eigen::Vector3d::UnitZ(), 0.0));
    ASSERT_EQ(polygons.size(), 1u);
    ASSERT_EQ(polygons[0].outer.size(), 4u);
    for (const Eigen::Vector3d& p : polygons[0].outer) {
      double nearest = 1e9;
      for (const Eigen::Vector3d& corner : mesh.points) {
        nearest = std::min(nearest, (p - corner).norm());
      }
      EXPECT_LT(nearest, 1e-12);
    }
    Ring seen;
    const PlaneFrame frame(OrientedPlane(side * Eigen::Vector3d::UnitZ(), 0.0), mesh.points[0]);
    for (const Eigen::Vector3d& p : polygons[0].outer) seen.push_back(frame.project(p));
    EXPECT_NEAR(signed_area(seen), 50.0, 1e-9);
  }
}

TEST(FacetPolygon, OnARasterIsNearTheExactOne) {
  Random random(2);
  Scan mesh;
  constexpr int kCells = 12;
  for (int i = 0; i <= kCells; ++i) {
    for (int j = 0; j <= kCells; ++j) {
      mesh.points.emplace_back(i + random.uniform(-0.3, 0.3), j + random.uniform(-0.3, 0.3), 0.0);
    }
  }
  std::vector<int> facets;
  for (int i = 0; i < kCells; ++i) {
    for (int j = 0; j < kCells; ++j) {
      if ((i == 4 || i == 5) && j > 3 && j < 9) continue;
      const int a = i * (kCells + 1) + j, b = a + kCells + 1;
      for (const auto& corners : {std::array{a, b, b + 1}, std::array{a + 1, a, b + 1}}) {
        facets.push_back(static_cast<int>(mesh.facets.size()));
        mesh.facets.add(corners);
      }
    }
  }
  const auto exact = facet_polygons(mesh, facets, kLevel);
  std::vector<int> twice = facets;  // overlap
  twice.insert(twice.end(), facets.begin(), facets.end());
  const auto drawn = facet_polygons(mesh, twice, kLevel);
  ASSERT_EQ(exact.size(), 1u);
  ASSERT_EQ(drawn.size(), 1u);
  EXPECT_EQ(exact[0].holes.size(), 1u);
  EXPECT_EQ(drawn[0].holes.size(), 1u);
  double sum = 0.0;
  for (const int f : facets) {
    Ring ring;
    for (const int corner : mesh.facets[f]) ring.push_back(mesh.points[corner].head<2>());
    sum += std::abs(signed_area(ring));
  }
  EXPECT_NEAR(area_of(exact[0]), sum, 1e-9);
  EXPECT_NEAR(area_of(drawn[0]), sum, 0.01 * sum);
}

TEST(FacetPolygon, KeepsTheHoleOfARingOfFacets) {
  const Scan mesh = mesh_of(
      {{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}, {3, 3, 0}, {6, 3, 0}, {6, 6, 0}, {3, 6, 0}},
      {{0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}});
  const std::vector<int> all{0, 1, 2, 3};
  const auto polygons = facet_polygons(mesh, all, kLevel);
  ASSERT_EQ(polygons.size(), 1u);
  ASSERT_EQ(polygons[0].holes.size(), 1u);
  EXPECT_NEAR(total_area(polygons), 72.0, 0.01 * 72.0);
}

}  // namespace
}  // namespace gable
