#include <gable/engine/scales/dissolve_regions.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/scales/plane_samples.h"

namespace gable {
namespace {

constexpr double kNoise = 0.01;  // metres

struct Regions {
  OrderedCloud cloud;
  Neighbours neighbours;
  std::vector<int> of;
  std::vector<PointMoments> moments;

  int count(int region) const { return static_cast<int>(std::count(of.begin(), of.end(), region)); }
};

// The regions of a scan: its labels, which `relabel(point, label)` may change.
template <typename Relabel>
Regions regions_of(const Scan& scan, int count, const Relabel& relabel) {
  Regions regions;
  regions.cloud = order_cloud(scan.points);
  regions.neighbours = find_neighbours(regions.cloud, 20, 1);
  regions.moments.resize(count);
  for (int p = 0; p < regions.cloud.size(); ++p) {
    const int source = regions.cloud.source[p];
    const int region = relabel(scan.points[source], scan.labels.at("truth")[source]);
    regions.of.push_back(region);
    if (region >= 0) regions.moments[region].add(regions.cloud.positions[p].cast<double>());
  }
  return regions;
}

DissolveOptions options() {
  DissolveOptions options;
  options.deviation = kNoise;
  options.reach = 3.5 * kNoise;
  return options;
}

// A floor (0) and a wall (1) that meet at the y axis.
Scan corner(Random* random) {
  Scan scan;
  const Eigen::Vector3d o = Eigen::Vector3d::Zero();
  add_patch(o, {4, 0, 0}, {0, 4, 0}, 8000, kNoise, 0, random, &scan);
  add_patch(o, {0, 0, 4}, {0, 4, 0}, 8000, kNoise, 1, random, &scan);
  return scan;
}

TEST(DissolveRegions, GiveUpAStripAlongAnEdge) {
  Random random(1);
  const Scan scan = corner(&random);
  Regions regions = regions_of(scan, 3, [](const Eigen::Vector3d& p, int label) {
    return p.x() < 0.15 && p.z() < 0.15 ? 2 : label;
  });
  ASSERT_GT(regions.count(2), 300);
  dissolve_regions(regions.cloud, regions.neighbours, options(), &regions.of, &regions.moments);
  EXPECT_EQ(regions.count(2), 0);
  EXPECT_EQ(regions.moments[2].weight, 0.0);
  int right = 0;
  for (int p = 0; p < regions.cloud.size(); ++p) {
    right += regions.of[p] == scan.labels.at("truth")[regions.cloud.source[p]];
  }
  EXPECT_GT(right, 0.98 * regions.cloud.size());
  for (int r : {0, 1}) EXPECT_EQ(regions.moments[r].weight, regions.count(r));
}

TEST(DissolveRegions, KeepASmallPlaneThatStandsOff) {
  Random random(2);
  Scan scan = corner(&random);
  // The top of a shelf 0.2 m above the floor, as long and as wide as the strip, on the wall.
  add_patch({0, 1, 0.2}, {0.15, 0, 0}, {0, 2, 0}, 300, kNoise, 2, &random, &scan);
  Regions regions = regions_of(scan, 3, [](const Eigen::Vector3d&, int label) { return label; });
  const std::vector<int> before = regions.of;
  dissolve_regions(regions.cloud, regions.neighbours, options(), &regions.of, &regions.moments);
  EXPECT_EQ(regions.of, before);
}

TEST(DissolveRegions, KeepAStepTooHighForNoise) {
  Random random(3);
  Scan scan;
  add_patch({0, 0, 0}, {4, 0, 0}, {0, 4, 0}, 8000, kNoise, 0, &random, &scan);
  // Within reach, but its squares are far above the noise's.
  add_patch({4, 0, 0.025}, {1, 0, 0}, {0, 4, 0}, 2000, 0.2 * kNoise, 1, &random, &scan);
  Regions regions = regions_of(scan, 2, [](const Eigen::Vector3d&, int label) { return label; });
  const std::vector<int> before = regions.of;
  dissolve_regions(regions.cloud, regions.neighbours, options(), &regions.of, &regions.moments);
  EXPECT_EQ(regions.of, before);
}

TEST(DissolveRegions, LeaveOutWhatFitsNoPlane) {
  Random random(4);
  Scan scan = corner(&random);
  for (int i = 0; i < 10; ++i) scan.points[i] = {0.02 * i, 0.3 * i + 0.5, 0.1};  // off both planes
  Regions regions = regions_of(scan, 3, [](const Eigen::Vector3d& p, int label) {
    return p.x() < 0.15 && p.z() < 0.15 ? 2 : label;
  });
  const std::vector<int> before = regions.of;
  dissolve_regions(regions.cloud, regions.neighbours, options(), &regions.of, &regions.moments);
  ASSERT_EQ(regions.count(2), 0);
  int left_out = 0;
  for (int p = 0; p < regions.cloud.size(); ++p) {
    if (before[p] != 2) continue;
    const Eigen::Vector3d& at = scan.points[regions.cloud.source[p]];
    // The fitted planes are a little off the true ones.
    const double deviations = std::min(std::abs(at.x()), std::abs(at.z())) / kNoise;
    if (deviations > 3.8) {
      EXPECT_EQ(regions.of[p], -1) << at.transpose();
      ++left_out;
    } else if (deviations < 3.2) {
      EXPECT_GE(regions.of[p], 0) << at.transpose();
    }
  }
  EXPECT_GE(left_out, 6);
}

}  // namespace
}  // namespace gable
