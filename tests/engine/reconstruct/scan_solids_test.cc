#include <gable/engine/reconstruct/scan_solids.h>
#include <gable/engine/scales/measure_shapes.h>
#include <gable/grammar/random.h>
#include <gable/grammar/solid/validity.h>
#include <gtest/gtest.h>

#include <array>
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
  EXPECT_LE(solid.facets, 11);  // seven, and what the outline's corners are cut into
  EXPECT_EQ(solid.triangles >= 16, true);
  EXPECT_LT(solid.rms, 0.15);
  EXPECT_LT(solid.mean, 0.08);
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
