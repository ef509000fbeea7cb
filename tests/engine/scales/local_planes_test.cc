#include <gable/engine/scales/first_shapes.h>
#include <gable/engine/scales/local_planes.h>
#include <gable/grammar/random.h>
#include <gtest/gtest.h>

#include <cmath>

#include "engine/scales/plane_samples.h"

namespace gable {
namespace {

constexpr int kNeighbours = 20;

TEST(SurfaceNoise, IsThatOfABoxWithinFifteenPerCent) {
  for (const double share : {0.002, 0.005, 0.01}) {
    for (uint64_t seed = 1; seed <= 3; ++seed) {
      const double noise = share * std::sqrt(10.0 * 10.0 + 6.0 * 6.0 + 4.0 * 4.0);
      const OrderedCloud cloud = order_cloud(box_cloud(20000, noise, seed).points);
      const SurfaceNoise seen = estimate_surface_noise(cloud, kNeighbours, 2);
      EXPECT_NEAR(seen.deviation, noise, 0.15 * noise) << share << " " << seed;
    }
  }
}

TEST(SurfaceNoise, NeedsNoThinningInCleanClouds) {
  const OrderedCloud cloud = order_cloud(box_cloud(20000, 0.0, 1).points);
  const SurfaceNoise seen = estimate_surface_noise(cloud, kNeighbours, 1);
  EXPECT_EQ(seen.thinning, 1);
  EXPECT_LT(seen.deviation, 1e-5);
}

TEST(SurfaceNoise, LooksFurtherTheMoreNoiseThereIs) {
  int before = 1;
  for (const double noise : {0.05, 0.1, 0.2}) {
    const OrderedCloud cloud = order_cloud(box_cloud(20000, noise, 1).points);
    const int thinning = estimate_surface_noise(cloud, kNeighbours, 1).thinning;
    EXPECT_GT(thinning, before) << noise;
    before = thinning;
  }
}

// Of the points at least 0.7 m from the edges of the box, further than neighbourhoods reach, the
// share whose normal is near enough to their face's for growing. Twenty noisy neighbours that reach
// barely further than the noise leave a tilt of some 7 degrees, so no more can be asked of them.
double good_normals(const Scan& scan) {
  const OrderedCloud cloud = order_cloud(scan.points);
  const Neighbours neighbours = find_neighbours(cloud, kNeighbours, 2);
  const SurfaceNoise noise = estimate_surface_noise(cloud, kNeighbours, 2);
  const LocalPlanes planes = fit_local_planes(cloud, neighbours, noise, 2);
  const Eigen::Vector3d size(10, 6, 4);
  int good = 0, all = 0;
  for (int p = 0; p < cloud.size(); ++p) {
    const int axis = 2 - scan.labels.at("truth")[cloud.source[p]] / 2;
    Eigen::Array3d to_edge = scan.points[cloud.source[p]].array();
    to_edge = to_edge.min(size.array() - to_edge);
    to_edge[axis] = INFINITY;
    if (to_edge.minCoeff() < 0.7) continue;
    ++all;
    good += std::abs(planes.normals[p][axis]) > std::cos(FirstShapesOptions().max_angle);
  }
  return static_cast<double>(good) / all;
}

TEST(LocalPlanes, AreThoseOfTheFacesAwayFromEdges) {
  for (const double noise : {0.0, 0.025, 0.06}) {  // up to 0.5 % of the diagonal
    EXPECT_GT(good_normals(box_cloud(20000, noise, 1)), 0.95) << noise;
  }
}

TEST(LocalPlanes, ThatPointsLieOffAreAtTheirDistance) {
  Random random(2);
  Scan scan;
  add_patch({0, 0, 0}, {4, 0, 0}, {0, 4, 0}, 4000, 0.0, 0, &random, &scan);
  scan.points.push_back({2.0, 2.0, 0.05});
  const OrderedCloud cloud = order_cloud(scan.points);
  const Neighbours neighbours = find_neighbours(cloud, kNeighbours, 1);
  const LocalPlanes planes = fit_local_planes(cloud, neighbours, {0.0, 1}, 1);
  for (int p = 0; p < cloud.size(); ++p) {
    if (cloud.source[p] != 4000) continue;
    // The point is one of 21 that the plane is fitted to.
    EXPECT_NEAR(std::abs(planes.distances[p]), 0.05 * 20.0 / 21.0, 5e-3);
  }
}

TEST(LocalPlanes, DoNotDependOnTheNumberOfThreads) {
  for (const double noise : {0.0, 0.1}) {  // whole and thinned
    const OrderedCloud cloud = order_cloud(box_cloud(5000, noise, 3).points);
    const Neighbours neighbours = find_neighbours(cloud, kNeighbours, 1);
    const SurfaceNoise seen = estimate_surface_noise(cloud, kNeighbours, 1);
    const LocalPlanes one = fit_local_planes(cloud, neighbours, seen, 1);
    const LocalPlanes four = fit_local_planes(cloud, neighbours, seen, 4);
    EXPECT_EQ(one.normals, four.normals);
    EXPECT_EQ(one.deviations, four.deviations);
  }
}

// Bare ground and trees up to 12 m high in stripes of 12 m, 300 x 300 m: as a whole it is flat, but
// its surfaces are thin.
TEST(SurfaceNoise, OfAWideSceneIsNotTheHeightOfItsTrees) {
  Random random(8);
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 60000; ++i) {
    const double x = random.uniform(0, 300), y = random.uniform(0, 300);
    const bool bare = static_cast<int>(x / 12) % 2 == 0;
    points.push_back({x, y, bare ? random.normal(0.02) : random.uniform(0, 12)});
  }
  const SurfaceNoise noise = estimate_surface_noise(order_cloud(points), 20, 2);
  EXPECT_EQ(noise.thinning, 1);
  EXPECT_LT(noise.deviation, 0.05);
}

}  // namespace
}  // namespace gable
