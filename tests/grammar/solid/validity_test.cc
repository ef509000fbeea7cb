#include <gable/grammar/solid/validity.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace gable {
namespace {

Solid cube(double size, const Eigen::Vector3d& at) {
  Solid solid;
  for (int i = 0; i < 8; ++i) {
    solid.vertices.push_back(at + size * Eigen::Vector3d(i & 1, (i >> 1) & 1, (i >> 2) & 1));
  }
  solid.faces = {{{{0, 2, 3, 1}}, SurfaceType::kGround}, {{{4, 5, 7, 6}}, SurfaceType::kRoof},
                 {{{0, 1, 5, 4}}, SurfaceType::kWall},   {{{1, 3, 7, 5}}, SurfaceType::kWall},
                 {{{3, 2, 6, 7}}, SurfaceType::kWall},   {{{2, 0, 4, 6}}, SurfaceType::kWall}};
  return solid;
}

// Both solids in one, their coincident vertices shared.
Solid joined(const Solid& a, const Solid& b) {
  Solid solid = a;
  std::vector<int> number;
  for (const Eigen::Vector3d& p : b.vertices) {
    const auto found = std::find(solid.vertices.begin(), solid.vertices.end(), p);
    number.push_back(static_cast<int>(found - solid.vertices.begin()));
    if (found == solid.vertices.end()) solid.vertices.push_back(p);
  }
  for (Face face : b.faces) {
    for (auto& ring : face.rings) {
      for (int& v : ring) v = number[v];
    }
    solid.faces.push_back(face);
  }
  return solid;
}

// A cube whose top has a square pit of one metre in its middle.
Solid pitted_cube() {
  Solid solid = cube(3.0, {0, 0, 0});
  Solid pit = cube(1.0, {1, 1, 2});
  for (Face& face : pit.faces) {
    std::reverse(face.rings[0].begin(), face.rings[0].end());
    for (int& v : face.rings[0]) v += 8;
  }
  pit.faces[0].type = SurfaceType::kRoof;
  solid.vertices.insert(solid.vertices.end(), pit.vertices.begin(), pit.vertices.end());
  solid.faces[1].rings.push_back(pit.faces[1].rings[0]);
  pit.faces.erase(pit.faces.begin() + 1);
  solid.faces.insert(solid.faces.end(), pit.faces.begin(), pit.faces.end());
  return solid;
}

TEST(Validity, CubeAndPittedCubeAreValidWithTheirVolume) {
  EXPECT_EQ(check_solid(cube(2.0, {1, 2, 3})).describe(), "valid");
  EXPECT_NEAR(check_solid(cube(2.0, {1, 2, 3})).volume, 8.0, 1e-12);
  EXPECT_EQ(check_solid(pitted_cube()).describe(), "valid");
  EXPECT_NEAR(check_solid(pitted_cube()).volume, 26.0, 1e-12);
}

TEST(Validity, MissingAndTurnedFacesLeaveOpenEdges) {
  Solid open = cube(2.0, {0, 0, 0});
  open.faces.pop_back();
  EXPECT_EQ(check_solid(open).open_edges, 4);
  Solid turned = cube(2.0, {0, 0, 0});
  std::reverse(turned.faces[1].rings[0].begin(), turned.faces[1].rings[0].end());
  EXPECT_GT(check_solid(turned).open_edges, 0);
  EXPECT_EQ(check_solid(turned).misfacing, 1);
}

TEST(Validity, InsideOutShellHasNegativeVolume) {
  Solid solid = cube(2.0, {0, 0, 0});
  for (Face& face : solid.faces) std::reverse(face.rings[0].begin(), face.rings[0].end());
  EXPECT_NEAR(check_solid(solid).volume, -8.0, 1e-12);
  EXPECT_FALSE(check_solid(solid).valid());
}

TEST(Validity, CubesThatShareAnEdgeOrAVertexAreNotManifold) {
  const Solid edge = joined(cube(1.0, {0, 0, 0}), cube(1.0, {1, 1, 0}));
  EXPECT_GT(check_solid(edge).non_manifold_edges, 0);
  const Solid vertex = joined(cube(1.0, {0, 0, 0}), cube(1.0, {1, 1, 1}));
  EXPECT_EQ(check_solid(vertex).non_manifold_edges, 0);
  EXPECT_EQ(check_solid(vertex).non_manifold_vertices, 1);
  EXPECT_EQ(check_solid(vertex).components, 2);
}

TEST(Validity, BentFaceIsNotPlanar) {
  Solid solid = cube(2.0, {0, 0, 0});
  solid.vertices[7].z() += 0.01;
  // One corner of a square lifted by d leaves a least distance of d / 4 from its mean plane.
  EXPECT_NEAR(check_solid(solid).planarity, 0.0025, 1e-5);
  EXPECT_GT(check_solid(solid).non_planar_faces, 0);
}

TEST(Validity, VertexOnAnotherFacesEdgeIsATJunction) {
  Solid solid = cube(2.0, {0, 0, 0});
  solid.vertices.push_back({1, 0, 2});
  solid.faces[1].rings[0] = {4, 8, 5, 7, 6};
  const SolidValidity validity = check_solid(solid);
  EXPECT_GT(validity.near_edges, 0);
  EXPECT_GT(validity.open_edges, 0);
  solid.faces[2].rings[0] = {0, 1, 5, 8, 4};  // now the neighbour knows it as well
  EXPECT_TRUE(check_solid(solid).valid());
}

TEST(Validity, VerticesCloserThanTheResolutionAreReported) {
  Solid solid = cube(2.0, {0, 0, 0});
  solid.vertices.push_back({0.002, 0, 2});
  solid.faces[1].rings[0] = {4, 8, 5, 7, 6};
  solid.faces[2].rings[0] = {0, 1, 5, 8, 4};
  EXPECT_EQ(check_solid(solid).near_vertices, 1);
  EXPECT_TRUE(check_solid(solid, {1e-3, 1e-3}).valid());
}

TEST(Validity, HolesMustLieInsideAndBeReversed) {
  Solid unreversed = pitted_cube();
  std::reverse(unreversed.faces[1].rings[1].begin(), unreversed.faces[1].rings[1].end());
  EXPECT_EQ(check_solid(unreversed).misplaced_holes, 1);
  Solid outside = pitted_cube();
  for (int i = 8; i < 16; ++i) outside.vertices[i].x() += 5.0;
  EXPECT_EQ(check_solid(outside).misplaced_holes, 1);
  Solid across = pitted_cube();
  for (int i = 8; i < 16; ++i) across.vertices[i].x() += 1.5;
  EXPECT_EQ(check_solid(across).crossing_rings, 1);
}

TEST(Validity, FigureOfEightCrossesItself) {
  Solid solid = cube(2.0, {0, 0, 0});
  solid.faces[1].rings[0] = {4, 5, 6, 7};
  EXPECT_FALSE(check_solid(solid).valid());
}

}  // namespace
}  // namespace gable
