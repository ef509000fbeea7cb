#include <gable/engine/scales/relax_regions.h>
#include <gable/engine/scales/shape_plane.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "engine/scales/plane_samples.h"

namespace gable {
namespace {

struct Regions {
  std::vector<int> of;
  std::vector<PointMoments> moments;
};

std::vector<PointMoments> moments_of(const OrderedCloud& cloud, const std::vector<int>& region_of,
                                     size_t count) {
  std::vector<PointMoments> moments(count);
  for (int p = 0; p < cloud.size(); ++p) {
    if (region_of[p] >= 0) moments[region_of[p]].add(cloud.positions[p].cast<double>());
  }
  return moments;
}

// The energy of a point in a region, or in none, as the header has it.
double energy(const OrderedCloud& cloud, const Neighbours& neighbours, const LocalPlanes& planes,
              const RelaxOptions& options, const Regions& regions, int point, int region) {
  double distance = options.epsilon, cosine = std::cos(M_PI / 3.0);
  if (region >= 0) {
    const ShapePlane plane = shape_plane(regions.moments[region]);
    distance = plane.normal.dot(cloud.positions[point].cast<double>() - plane.centroid);
    cosine = std::abs(plane.normal.dot(planes.normals[point].cast<double>()));
  }
  double others = 0.0;
  for (int q : neighbours.of(point)) others += regions.of[q] != region;
  return distance * distance / (2.0 * options.deviation * options.deviation) +
         options.tilt * (1.0 - cosine) + options.smoothness * others / neighbours.k;
}

// One sweep over all points from the header's words. Where a point's two best choices are within
// float rounding of each other, or one is at epsilon, `unsure` says so.
Regions slow_sweep(const OrderedCloud& cloud, const Neighbours& neighbours,
                   const LocalPlanes& planes, const RelaxOptions& options, const Regions& before,
                   std::vector<bool>* unsure) {
  Regions after = before;
  unsure->assign(before.of.size(), false);
  for (int p = 0; p < cloud.size(); ++p) {
    std::map<int, double> energies;
    for (int q : neighbours.of(p)) {
      const int region = before.of[q];
      if (region >= 0) {
        const ShapePlane plane = shape_plane(before.moments[region]);
        const double distance =
            std::abs(plane.normal.dot(cloud.positions[p].cast<double>() - plane.centroid));
        if (std::abs(distance - options.epsilon) < 1e-5) (*unsure)[p] = true;
        if (distance > options.epsilon) continue;
      }
      energies[region] = energy(cloud, neighbours, planes, options, before, p, region);
    }
    bool inside = true;
    for (int q : neighbours.of(p)) inside = inside && before.of[q] == before.of[p];
    if (inside) continue;
    int choice = -1;
    double best = INFINITY;
    for (const auto& [region, value] : energies) {
      if (std::abs(value - best) < 1e-4 * (1.0 + value)) (*unsure)[p] = true;
      if (value < best) best = value, choice = region;
    }
    after.of[p] = choice;
  }
  after.moments = moments_of(cloud, after.of, before.moments.size());
  return after;
}

struct Scene {
  OrderedCloud cloud;
  Neighbours neighbours;
  LocalPlanes planes;
  RelaxOptions options;
  Regions regions;
};

// A noisy box whose faces are the regions, but for a tenth of the points, which have none, and a
// twentieth, which have a random one.
Scene torn_box(uint64_t seed) {
  const Scan scan = box_cloud(500, 0.05, seed);
  Scene scene;
  scene.cloud = order_cloud(scan.points);
  scene.neighbours = find_neighbours(scene.cloud, 12, 1);
  scene.planes = fit_local_planes(scene.cloud, scene.neighbours, {}, 1);
  scene.options.epsilon = 0.15;
  scene.options.deviation = 0.05;
  Random random(seed);
  for (int p = 0; p < scene.cloud.size(); ++p) {
    int region = scan.labels.at("truth")[scene.cloud.source[p]];
    if (random.chance(0.1)) region = -1;
    if (random.chance(0.05)) region = random.integer(0, 5);
    scene.regions.of.push_back(region);
  }
  scene.regions.moments = moments_of(scene.cloud, scene.regions.of, 6);
  return scene;
}

TEST(RelaxRegions, ChooseAsTheDefinitionSaysInEverySweep) {
  for (uint64_t seed = 1; seed <= 3; ++seed) {
    const Scene scene = torn_box(seed);
    Regions before = scene.regions;
    for (int sweeps = 1; sweeps <= 4; ++sweeps) {
      RelaxOptions options = scene.options;
      options.sweeps = sweeps;
      Regions fast = scene.regions;
      relax_regions(scene.cloud, scene.neighbours, scene.planes, options, &fast.of, &fast.moments);
      std::vector<bool> unsure;
      const Regions slow =
          slow_sweep(scene.cloud, scene.neighbours, scene.planes, options, before, &unsure);
      int changed = 0, sure = 0;
      for (int p = 0; p < scene.cloud.size(); ++p) {
        changed += slow.of[p] != before.of[p];
        if (unsure[p]) continue;
        ++sure;
        ASSERT_EQ(fast.of[p], slow.of[p]) << "seed " << seed << " sweep " << sweeps << " " << p;
      }
      EXPECT_GT(changed, 0);
      EXPECT_GT(sure, 0.98 * scene.cloud.size());
      before = fast;
    }
  }
}

// Growing reaches over edges and leaves points out.
TEST(RelaxRegions, GivePointsBackToTheirSurfaces) {
  const Scan scan = box_cloud(2000, 0.05, 4);
  Scene scene = torn_box(4);
  scene.cloud = order_cloud(scan.points);
  scene.neighbours = find_neighbours(scene.cloud, 12, 1);
  scene.planes = fit_local_planes(scene.cloud, scene.neighbours, {}, 1);
  const std::vector<int>& truth = scan.labels.at("truth");
  std::vector<int>& region_of = scene.regions.of;
  region_of.resize(scan.points.size());
  Random random(4);
  for (int p = 0; p < scene.cloud.size(); ++p) {
    const int source = scene.cloud.source[p];
    const bool over_edge = truth[source] == 2 && scan.points[source].z() < 0.3;
    region_of[p] = random.chance(0.1) ? -1 : over_edge ? 0 : truth[source];
  }
  scene.regions.moments = moments_of(scene.cloud, region_of, 6);
  const auto wrong = [&] {
    int count = 0;
    for (int p = 0; p < scene.cloud.size(); ++p) {
      count += region_of[p] != truth[scene.cloud.source[p]];
    }
    return count;
  };
  const int before = wrong();
  ASSERT_GT(before, 1000);
  relax_regions(scene.cloud, scene.neighbours, scene.planes, scene.options, &region_of,
                &scene.regions.moments);
  EXPECT_LT(wrong(), 0.5 * before);
}

TEST(RelaxRegions, HoldTheMomentsOfTheirPointsAndGiveUpSmallOnes) {
  Scene scene = torn_box(5);
  scene.regions.moments.resize(8);
  scene.regions.of[0] = 6;  // alone among others
  scene.options.min_inliers = 2;
  relax_regions(scene.cloud, scene.neighbours, scene.planes, scene.options, &scene.regions.of,
                &scene.regions.moments);
  ASSERT_EQ(scene.regions.moments.size(), 6u);
  const std::vector<PointMoments> moments = moments_of(scene.cloud, scene.regions.of, 6);
  for (size_t r = 0; r < 6; ++r) {
    EXPECT_EQ(scene.regions.moments[r].weight, moments[r].weight);
    EXPECT_EQ(scene.regions.moments[r].sum, moments[r].sum);
  }
}

TEST(RelaxRegions, DoNotDependOnTheNumberOfThreads) {
  Scene one = torn_box(6), four = one;
  four.options.threads = 4;
  for (Scene* scene : {&one, &four}) {
    relax_regions(scene->cloud, scene->neighbours, scene->planes, scene->options,
                  &scene->regions.of, &scene->regions.moments);
  }
  EXPECT_EQ(one.regions.of, four.regions.of);
}

}  // namespace
}  // namespace gable
