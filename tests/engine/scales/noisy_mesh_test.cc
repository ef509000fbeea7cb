#include <gable/engine/scales/absorb_small_shapes.h>
#include <gable/engine/scales/first_shapes.h>
#include <gable/engine/scales/mesh_noise.h>
#include <gable/grammar/random.h>
#include <gtest/gtest.h>

#include <array>
#include <map>

namespace gable {
namespace {

// A saddle roof of 20 x 10 m as a grid of triangles 0.25 m wide, its vertices moved up and down.
Scan roof_mesh(double noise, uint64_t seed) {
  Random random(seed);
  Scan scan;
  constexpr int kX = 80, kY = 40;
  for (int y = 0; y <= kY; ++y) {
    for (int x = 0; x <= kX; ++x) {
      const double py = 0.25 * y, height = 0.8 * (5.0 - std::abs(py - 5.0));
      scan.points.push_back({0.25 * x, py, height + random.normal(noise)});
    }
  }
  for (int y = 0; y < kY; ++y) {
    for (int x = 0; x < kX; ++x) {
      const int a = y * (kX + 1) + x, b = a + 1, c = a + kX + 1, d = c + 1;
      scan.facets.add(std::array{a, b, d});
      scan.facets.add(std::array{a, d, c});
    }
  }
  return scan;
}

TEST(MeshNoise, IsThatOfTheVerticesAlongTheNormal) {
  const double slope = std::cos(std::atan(0.8));
  for (double noise : {0.01, 0.03}) {
    EXPECT_NEAR(mesh_noise(roof_mesh(noise, 1)), noise * slope, 0.15 * noise * slope);
  }
}

TEST(MeshNoise, IsNothingOnFlatFacetsAndUnknownForFewOfThem) {
  EXPECT_LT(mesh_noise(roof_mesh(0.0, 1)), 1e-9);
  Scan tetrahedron;
  tetrahedron.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  tetrahedron.facets.add(std::array{0, 1, 2});
  EXPECT_EQ(mesh_noise(tetrahedron), 0.0);
}

TEST(FirstShapes, OfARoughMeshAreItsSlopesAndFewMore) {
  const Scan scan = roof_mesh(0.04, 2);
  const FirstShapes first = find_first_shapes(scan, {});
  EXPECT_LT(first.moments.size(), 40u);  // of 6400 facets
  std::map<int, int> lower, upper;       // facets by shape, on either slope
  for (size_t f = 0; f < scan.facets.size(); ++f) {
    ASSERT_GE(first.shape_of[f], 0);
    ++(f < scan.facets.size() / 2 ? lower : upper)[first.shape_of[f]];
  }
  const auto most = [](const std::map<int, int>& counts) {
    std::pair<int, int> best{-1, 0};
    for (const auto& [shape, count] : counts) {
      if (count > best.second) best = {shape, count};
    }
    return best;
  };
  EXPECT_GT(most(lower).second, 2200);  // of 3200
  EXPECT_GT(most(upper).second, 2200);
  EXPECT_NE(most(lower).first, most(upper).first);
}

TEST(AbsorbSmallShapes, GivesThemToTheNeighbourOnTheSamePlane) {
  // Two large patches on the planes z = 0 and x = 0, a small one beside both on z = 0, one apart.
  FirstShapes first;
  first.diagonal = 10.0;
  first.moments.resize(4);
  const auto put = [&](int shape, const Eigen::Vector3d& p) {
    first.shape_of.push_back(shape);
    first.moments[shape].add(p);
  };
  for (int i = 0; i < 5; ++i) {
    for (int j = 0; j < 5; ++j) {
      put(0, {0.0, 1.0 * i, 1.0 + j});
      put(1, {2.0 + i, 1.0 * j, 0.0});
    }
  }
  put(2, {1.0, 1.0, 0.0});
  put(2, {1.0, 2.0, 0.0});
  put(2, {0.5, 2.0, 0.0});
  put(3, {9.0, 9.0, 9.0});
  first.adjacent = {{0, 2}, {1, 2}};
  absorb_small_shapes(10, &first);
  ASSERT_EQ(first.moments.size(), 3u);
  EXPECT_EQ(first.shape_of[50], first.shape_of[1]);  // on z = 0
  EXPECT_NE(first.shape_of[50], first.shape_of[0]);
  EXPECT_EQ(first.moments[first.shape_of[1]].weight, 28.0);
  EXPECT_EQ(first.shape_of[53], 2);  // has no neighbour, so it stays
  EXPECT_EQ(first.adjacent, (std::vector<std::pair<int, int>>{{0, 1}}));
}

}  // namespace
}  // namespace gable
