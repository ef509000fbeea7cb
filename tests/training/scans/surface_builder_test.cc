#include <gable/training/scans/surface_builder.h>
#include <gable/training/scans/surface_shapes.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <map>
#include <set>

namespace gable {
namespace {

using Eigen::Vector3d;

/// Area vectors summed: zero over a closed surface.
Vector3d flux(const LabelledSurface& surface) {
  Vector3d sum = Vector3d::Zero();
  for (const auto& [a, b, c] : surface.triangles) {
    sum += 0.5 * (surface.vertices[b] - surface.vertices[a])
                     .cross(surface.vertices[c] - surface.vertices[a]);
  }
  return sum;
}

/// Enclosed volume, positive where triangles look outward.
double volume(const LabelledSurface& surface) {
  double sum = 0.0;
  for (const auto& [a, b, c] : surface.triangles) {
    sum += surface.vertices[a].dot(surface.vertices[b].cross(surface.vertices[c])) / 6.0;
  }
  return sum;
}

double area(const LabelledSurface& surface) {
  double sum = 0.0;
  for (const auto& [a, b, c] : surface.triangles) {
    sum += 0.5 * (surface.vertices[b] - surface.vertices[a])
                     .cross(surface.vertices[c] - surface.vertices[a])
                     .norm();
  }
  return sum;
}

TEST(AddBox, MakesAClosedBoxThatLooksOutward) {
  SurfaceBuilder builder;
  add_box(&builder, {1, 2, 3}, {3, 5, 4}, builder.add_structure());
  const LabelledSurface box = builder.build(0.01);
  EXPECT_EQ(box.triangles.size(), 12u);
  EXPECT_NEAR(volume(box), 6.0, 1e-9);
  EXPECT_LT(flux(box).norm(), 1e-9);
}

TEST(SurfaceBuilder, MirroredPosesStillLookOutward) {
  SurfaceBuilder builder;
  Eigen::Affine3d mirror = Eigen::Affine3d::Identity();
  mirror.linear()(1, 1) = -1.0;
  builder.set_pose(mirror);
  add_box(&builder, {1, 2, 3}, {3, 5, 4}, builder.add_structure());
  EXPECT_NEAR(volume(builder.build(0.01)), 6.0, 1e-9);
}

TEST(AddPanel, CutsInsetsOutAndClosesThem) {
  // The front of a box as a panel with one inset and one piece that stands out.
  SurfaceBuilder builder;
  const int structure = builder.add_structure();
  add_box(&builder, Vector3d::Zero(), {4, 1, 3}, structure, {kFront});
  const std::vector<Recess> recesses = {{0.5, 1.5, 0.5, 2.0, 0.1}, {2.0, 3.5, 1.0, 2.0, -0.2}};
  add_panel(&builder, structure, Vector3d::Zero(), Vector3d::UnitX(), Vector3d::UnitZ(),
            {{0, 0}, {4, 0}, {4, 3}, {0, 3}}, recesses);
  const LabelledSurface surface = builder.build(0.01);
  EXPECT_LT(flux(surface).norm(), 1e-9);
  EXPECT_NEAR(volume(surface), 12.0 - 1.5 * 0.1 + 1.5 * 0.2, 1e-9);
  std::set<int> details;
  for (const auto& planes : surface.planes) details.insert(planes[0]);
  EXPECT_EQ(details.size(), 5u + 1u + 2u * 5u);
}

TEST(AddPatch, CoversItsSquareAndLooksUp) {
  SurfaceBuilder builder;
  add_patch(&builder, builder.add_structure(), 3, 4,
            [](double s, double t) { return Vector3d(2.0 * s, 3.0 * t, 0.2 * s * t); });
  const LabelledSurface surface = builder.build(0.01);
  EXPECT_NEAR(flux(surface).z(), 6.0, 1e-9);
  EXPECT_GT(surface.triangles.size(), 23u);
}

TEST(SurfaceBuilder, GivesDetailsToWhatMergingJoinsThemTo) {
  // A low box on a large floor beside a wall that it hardly touches.
  SurfaceBuilder builder;
  const int floor = builder.add_structure(builder.add_hull());
  const int wall = builder.add_structure(builder.add_hull());
  builder.add_face(floor, {{0, 0, 0}, {5, 0, 0}, {5, 5, 0}, {0, 5, 0}});
  builder.add_face(wall, {{0, 5, 0}, {5, 5, 0}, {5, 5, 3}, {0, 5, 3}});
  add_box(&builder, {1, 4.6, 0}, {2, 5, 0.1}, kTouching, {kBottom, kBack});
  const LabelledSurface surface = builder.build(0.01);
  std::map<int, std::set<int>> structures;
  for (const auto& planes : surface.planes) structures[planes[2]].insert(planes[1]);
  ASSERT_EQ(structures.size(), 2u);
  for (size_t i = 4; i < surface.planes.size(); ++i) {
    EXPECT_EQ(surface.planes[i][1], surface.planes[0][1]);
  }
}

TEST(SurfaceBuilder, LeavesOutDegeneratePolygonsAndUnusedPlanes) {
  SurfaceBuilder builder;
  builder.add_structure(builder.add_hull());
  const int used = builder.add_structure(builder.add_hull());
  builder.add_face(used, {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}});
  builder.add_face(used, {{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 0}});
  const LabelledSurface surface = builder.build(0.01);
  EXPECT_NEAR(area(surface), 0.5, 1e-12);
  ASSERT_EQ(surface.planes.size(), 1u);
  EXPECT_EQ(surface.planes[0], (std::array<int, 3>{0, 0, 0}));
  EXPECT_EQ(surface.vertices.size(), 3u);
}

}  // namespace
}  // namespace gable
