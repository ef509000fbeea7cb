#include <gable/training/scans/sample_surface.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace gable {
namespace {

/// A floor of 4 x 3 m in two triangles, plane 0, 5, 0, and a wall of 4 x 1 m on its edge y = 0 that
/// faces -y, plane 1, 6, 0.
LabelledSurface floor_and_wall() {
  LabelledSurface surface;
  surface.vertices = {{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {0, 3, 0}, {0, 0, 1}, {4, 0, 1}};
  surface.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 1, 5}, {0, 5, 4}};
  surface.planes = {{0, 5, 0}, {0, 5, 0}, {1, 6, 0}, {1, 6, 0}};
  return surface;
}

const double kDiagonal = std::sqrt(16.0 + 9.0 + 1.0);

TEST(SampleSurface, PointsWithoutNoiseLieOnTheTrianglesOfTheirPlane) {
  SampleOptions options;
  options.num_points = 5000;
  options.with_normals = true;
  const Scan scan = sample_surface(floor_and_wall(), options);
  ASSERT_EQ(scan.points.size(), 5000u);
  for (size_t i = 0; i < scan.points.size(); ++i) {
    const Eigen::Vector3d& p = scan.points[i];
    const bool on_floor = scan.labels.at("scale_1")[i] == 0;
    EXPECT_EQ(scan.labels.at("scale_2")[i], on_floor ? 5 : 6);
    EXPECT_EQ(scan.labels.at("scale_3")[i], 0);
    EXPECT_NEAR(on_floor ? p.z() : p.y(), 0.0, 1e-12);
    EXPECT_TRUE(p.x() >= 0.0 && p.x() <= 4.0 && p.y() >= 0.0 && p.y() <= 3.0 && p.z() <= 1.0);
    EXPECT_EQ(scan.normals[i], on_floor ? Eigen::Vector3f(0, 0, 1) : Eigen::Vector3f(0, -1, 0));
  }
}

TEST(SampleSurface, PointsAreUniformByArea) {
  SampleOptions options;
  options.num_points = 64000;
  const Scan scan = sample_surface(floor_and_wall(), options);
  // Cells of half a square metre on the floor and the wall: 24 + 8, each 2000 points expected with
  // a standard deviation of 44.
  std::vector<int> floor(24, 0), wall(8, 0);
  for (size_t i = 0; i < scan.points.size(); ++i) {
    const Eigen::Vector3d& p = scan.points[i];
    const int column = std::min(static_cast<int>(p.x() * 2.0), 7);
    if (scan.labels.at("scale_1")[i] == 0) {
      ++floor[8 * std::min(static_cast<int>(p.y()), 2) + column];
    } else {
      ++wall[column];
    }
  }
  for (const int count : floor) EXPECT_NEAR(count, 2000, 5 * 44);
  for (const int count : wall) EXPECT_NEAR(count, 2000, 5 * 44);
}

TEST(SampleSurface, NoiseIsGaussianWithTheSigmaAskedFor) {
  SampleOptions options;
  options.num_points = 40000;
  options.noise = 0.01;
  options.seed = 3;
  const Scan scan = sample_surface(floor_and_wall(), options);
  for (const int plane : {0, 1}) {
    double square = 0.0, fourth = 0.0;
    int count = 0;
    for (size_t i = 0; i < scan.points.size(); ++i) {
      if (scan.labels.at("scale_1")[i] != plane) continue;
      const double off = plane == 0 ? scan.points[i].z() : scan.points[i].y();
      const double z = off / (0.01 * kDiagonal);
      square += z * z;
      fourth += z * z * z * z;
      ++count;
    }
    // At least 10000 points: standard deviations of 0.014 and 0.1.
    EXPECT_NEAR(square / count, 1.0, 0.06);
    EXPECT_NEAR(fourth / count, 3.0, 0.4);
  }
}

TEST(SampleSurface, OutliersHaveTheirShareNoLabelAndFillTheEnlargedBox) {
  SampleOptions options;
  options.num_points = 40000;
  options.outlier_share = 0.25;
  options.with_normals = true;
  const Scan scan = sample_surface(floor_and_wall(), options);
  int outliers = 0, in_first_half = 0;
  Eigen::AlignedBox3d box;
  for (size_t i = 0; i < scan.points.size(); ++i) {
    if (scan.labels.at("scale_1")[i] >= 0) continue;
    EXPECT_EQ(scan.labels.at("scale_2")[i], -1);
    EXPECT_EQ(scan.labels.at("scale_3")[i], -1);
    EXPECT_TRUE(scan.normals[i].isZero());
    box.extend(scan.points[i]);
    ++outliers;
    in_first_half += i < scan.points.size() / 2;
  }
  EXPECT_EQ(outliers, 10000);
  EXPECT_NEAR(in_first_half, 5000, 5 * 43);  // the order is random
  EXPECT_TRUE(box.min().isApprox(Eigen::Vector3d(-0.2, -0.15, -0.05), 0.02));
  EXPECT_TRUE(box.max().isApprox(Eigen::Vector3d(4.2, 3.15, 1.05), 0.02));
}

TEST(SampleSurface, SeenFromAboveLeavesOutWhatFacesDown) {
  LabelledSurface surface = floor_and_wall();
  for (std::array<int, 3>& triangle : surface.triangles) std::swap(triangle[1], triangle[2]);
  SampleOptions options;
  options.num_points = 1000;
  options.least_normal_z = -0.2;
  const Scan scan = sample_surface(surface, options);
  for (const int label : scan.labels.at("scale_1")) EXPECT_EQ(label, 1);
}

TEST(SampleSurface, TheSeedDecidesThePoints) {
  SampleOptions options;
  options.num_points = 100;
  options.noise = 0.01;
  options.outlier_share = 0.05;
  const Scan first = sample_surface(floor_and_wall(), options);
  EXPECT_EQ(first.points, sample_surface(floor_and_wall(), options).points);
  options.seed = 2;
  EXPECT_NE(first.points, sample_surface(floor_and_wall(), options).points);
}

TEST(SampleSurface, CheckNamesTheBoundThatIsViolated) {
  EXPECT_EQ(check(SampleOptions()), "");
  EXPECT_EQ(check({.num_points = 0}), "num_points must be in [1, 1e9]");
  EXPECT_EQ(check({.noise = -0.1}), "noise must be in [0, 1]");
  EXPECT_EQ(check({.outlier_share = std::nan("")}), "outlier_share must be in [0, 1]");
  EXPECT_EQ(check({.least_normal_z = 2.0}), "least_normal_z must be in [-1, 1]");
}

}  // namespace
}  // namespace gable
