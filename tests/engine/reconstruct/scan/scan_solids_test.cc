#include <gable/engine/closing/surface_distance.h>
#include <gable/engine/reconstruct/scan/scan_solids.h>
#include <gable/engine/scales/measure_shapes.h>
#include <gable/grammar/random.h>
#include <gable/grammar/solid/validity.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace gable {
namespace {

// The walls and the gable roof of a house of 12 x 8 x 6 m far from the origin, as points.
struct HouseScan {
  Scan scan;
  std::vector<int> shape_of;
  std::vector<OrientedPlane> planes;

  explicit HouseScan(double noise) {
    const Eigen::Vector3d far(84000, 447000, 2);
    const std::array<Eigen::Vector3d, 6> normals = {Eigen::Vector3d(0, -0.75, 1).normalized(),
                                                    Eigen::Vector3d(0, 0.75, 1).normalized(),
                                                    -Eigen::Vector3d::UnitX(),
                                                    Eigen::Vector3d::UnitX(),
                                                    -Eigen::Vector3d::UnitY(),
                                                    Eigen::Vector3d::UnitY()};
    const std::array<Eigen::Vector3d, 6> on = {
        Eigen::Vector3d(0, 0, 3), {0, 8, 3}, {0, 0, 0}, {12, 0, 0}, {0, 0, 0}, {0, 8, 0}};
    Random random(2);
    for (int i = 0; i < 6; ++i) {
      planes.emplace_back(normals[i], normals[i].dot(on[i] + far));
      for (int k = 0; k < (i < 2 ? 3000 : 400); ++k) {
        const double u = random.uniform(0, 1), v = random.uniform(0, 1);
        Eigen::Vector3d p;
        if (i == 0) p = {12 * u, 4 * v, 3 + 3 * v};
        if (i == 1) p = {12 * u, 8 - 4 * v, 3 + 3 * v};
        if (i == 2 || i == 3) p = {i == 2 ? 0.0 : 12.0, 8 * u, 3 * v};
        if (i >= 4) p = {12 * u, i == 4 ? 0.0 : 8.0, 3 * v};
        scan.points.push_back(p + far + random.normal(noise) * normals[i]);
        shape_of.push_back(i);
      }
    }
  }
};

TEST(ScanSolids, HouseOfPointsIsClosedIntoSevenFacets) {
  const HouseScan house(0.02);
  const ScanSolid solid =
      close_scale(house.scan, measure_shapes(house.scan, house.shape_of, house.planes), {});
  ASSERT_EQ(solid.reason, "");
  ASSERT_EQ(solid.solids.size(), 1u);
  const SolidValidity validity = check_solid(solid.solids[0]);
  EXPECT_EQ(validity.describe(), "valid");
  EXPECT_EQ(solid.planes, 2);
  EXPECT_EQ(solid.facets, 7);
  EXPECT_EQ(solid.triangles, 16);
  EXPECT_LT(solid.rms, 0.025);
  EXPECT_LT(solid.mean, 0.02);
}

TEST(ScanSolids, HouseComesOutAtItsHeightsAndNearerThanTheNoise) {
  const HouseScan house(0.05), truth(0.0);
  const ScanSolid solid =
      close_scale(house.scan, measure_shapes(house.scan, house.shape_of, house.planes), {});
  ASSERT_EQ(solid.reason, "");
  ASSERT_EQ(solid.solids.size(), 1u);
  // The corners of the walls, at the eaves (3 m) and the base, and the ends of the ridge (6 m).
  const Eigen::Vector3d far(84000, 447000, 2);
  double lowest = 1e9;
  for (const Eigen::Vector3d& p : house.scan.points) lowest = std::min(lowest, p.z() - far.z());
  ASSERT_EQ(solid.solids[0].vertices.size(), 10u);
  for (const Eigen::Vector3d& vertex : solid.solids[0].vertices) {
    const Eigen::Vector3d p = vertex + solid.origin - far;
    const bool ridge = p.z() > 4.5;
    EXPECT_NEAR(p.x(), p.x() < 6 ? 0.0 : 12.0, 0.05);
    EXPECT_NEAR(p.y(), ridge ? 4.0 : (p.y() < 4 ? 0.0 : 8.0), 0.05);
    EXPECT_NEAR(p.z(), ridge ? 6.0 : (p.z() < 1.5 ? lowest - 0.2 : 3.0), 0.05);
  }
  const SurfaceDistance distance(solid.solids);
  double squares = 0.0;
  for (const Eigen::Vector3d& p : truth.scan.points) {
    squares += std::pow(distance(p - solid.origin), 2);
  }
  EXPECT_LT(std::sqrt(squares / static_cast<double>(truth.scan.points.size())), 0.02);
}

TEST(ScanSolids, RoofEndsAtTheWallThatItJutsOutOver) {
  // The house with its roof 0.6 m longer at both gables.
  HouseScan house(0.01);
  const double x0 = 84000, x1 = 84012;
  Random random(3);
  for (size_t i = 0; i < 6000; ++i) {
    Eigen::Vector3d& p = house.scan.points[i];
    p.x() = x0 - 0.6 + (p.x() - x0) * 1.1;
  }
  const ScanSolid solid =
      close_scale(house.scan, measure_shapes(house.scan, house.shape_of, house.planes), {});
  ASSERT_EQ(solid.reason, "");
  for (const Eigen::Vector3d& vertex : solid.solids[0].vertices) {
    const double x = vertex.x() + solid.origin.x();
    EXPECT_NEAR(x, x < x0 + 6 ? x0 : x1, 0.1);
  }
}

TEST(ScanSolids, FinerScalesAreNearerAndCoarserOnesHaveFewerFacets) {
  const HouseScan house(0.02);
  const ScaleShapes fine = measure_shapes(house.scan, house.shape_of, house.planes);
  // A scale at which the roof is one level plane, between the two.
  std::vector<int> merged = house.shape_of;
  for (int& shape : merged) shape = shape < 2 ? 0 : shape - 1;
  std::vector<OrientedPlane> planes(house.planes.begin() + 1, house.planes.end());
  planes[0] = OrientedPlane(Eigen::Vector3d::UnitZ(), 2.0 + 4.5);
  const ScaleShapes coarse = measure_shapes(house.scan, merged, planes);
  const auto in_order = close_scales(house.scan, {fine, coarse}, {});
  ASSERT_EQ(in_order.size(), 2u);
  EXPECT_EQ(in_order[0].scale, 0);
  EXPECT_EQ(in_order[1].scale, 1);
  EXPECT_LT(in_order[0].rms, in_order[1].rms);
  EXPECT_GT(in_order[0].facets, in_order[1].facets);
  // The other way round the second one has more facets, and is left out.
  const auto turned = close_scales(house.scan, {coarse, fine}, {});
  EXPECT_EQ(turned[0].scale, 0);
  EXPECT_EQ(turned[1].scale, 0);
  EXPECT_EQ(turned[1].facets, in_order[1].facets);
  ScaleShapes none;
  none.shape_of.assign(house.scan.points.size(), -1);
  const auto with_none = close_scales(house.scan, {fine, none, coarse}, {});
  EXPECT_EQ(with_none[1].reason, "no shape of the scan faces up");
  EXPECT_EQ(with_none[2].scale, 2);
}

TEST(ScanSolids, MeshIsSampledWithinItsFacets) {
  Scan mesh;
  mesh.points = {{0, 0, 0}, {10, 0, 0}, {10, 6, 0}, {0, 6, 0},
                 {0, 0, 4}, {10, 0, 4}, {10, 6, 4}, {0, 6, 4}};
  for (const auto& f : std::vector<std::vector<int>>{
           {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}) {
    mesh.facets.add(f);
  }
  const std::vector<OrientedPlane> planes = {{Eigen::Vector3d::UnitZ(), 4.0},
                                             {-Eigen::Vector3d::UnitY(), 0.0},
                                             {Eigen::Vector3d::UnitX(), 10.0},
                                             {Eigen::Vector3d::UnitY(), 6.0},
                                             {-Eigen::Vector3d::UnitX(), 0.0}};
  ScanSolidOptions options;
  options.most_samples = 5000;
  const ScanSolid solid = close_scale(mesh, measure_shapes(mesh, {0, 1, 2, 3, 4}, planes), options);
  ASSERT_EQ(solid.reason, "");
  EXPECT_EQ(solid.facets, 6);
  EXPECT_LT(solid.rms, 1e-3);
}

TEST(ScanSolids, WhatIsNoBuildingSaysWhy) {
  HouseScan house(0.0);
  const ScaleShapes scale = measure_shapes(house.scan, house.shape_of, house.planes);
  EXPECT_EQ(close_scale({}, {}, {}).reason, "the scan is not the size of a building in metres");
  ScaleShapes walls = scale;
  for (PlanarShape& shape : walls.shapes) {
    shape.plane = OrientedPlane(Eigen::Vector3d::UnitX(), 84000.0);
  }
  EXPECT_EQ(close_scale(house.scan, walls, {}).reason, "no shape of the scan faces up");
}

}  // namespace
}  // namespace gable
