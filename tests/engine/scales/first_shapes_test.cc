#include <gable/engine/scales/collapse.h>
#include <gable/engine/scales/first_shapes.h>
#include <gtest/gtest.h>

#include <array>
#include <set>

#include "engine/scales/plane_samples.h"

namespace gable {
namespace {

// The largest share of a truth's points that one shape holds, at its lowest over the truths.
double worst_overlap(const std::vector<int>& truth, const std::vector<int>& shape_of) {
  std::map<int, std::map<int, int>> counts;
  std::map<int, int> totals;
  for (size_t i = 0; i < truth.size(); ++i) {
    ++totals[truth[i]];
    if (shape_of[i] >= 0) ++counts[truth[i]][shape_of[i]];
  }
  double worst = 1.0;
  for (const auto& [plane, total] : totals) {
    int best = 0;
    for (const auto& [shape, count] : counts[plane]) best = std::max(best, count);
    worst = std::min(worst, static_cast<double>(best) / total);
  }
  return worst;
}

Scan cube_mesh() {
  Scan scan;
  for (int i = 0; i < 8; ++i)
    scan.points.push_back(Eigen::Vector3i(i & 1, i >> 1 & 1, i >> 2 & 1).cast<double>());
  const std::array<std::array<int, 4>, 6> sides = {
      {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
  for (const auto& s : sides) {
    scan.facets.add(std::array{s[0], s[1], s[2]});
    scan.facets.add(std::array{s[0], s[2], s[3]});
  }
  return scan;
}

TEST(FirstShapes, AreTheSixFacesOfACleanBox) {
  const Scan scan = box_cloud(4000, 0.0, 1);
  const FirstShapes first = find_first_shapes(scan, {});
  ASSERT_GE(first.moments.size(), 6u);
  EXPECT_GT(worst_overlap(scan.labels.at("truth"), first.shape_of), 0.95);
  EXPECT_NEAR(first.diagonal, std::sqrt(100.0 + 36.0 + 16.0), 0.05);
}

TEST(FirstShapes, SeeTheFacesOfABoxThroughNoiseFarAboveThePointDistance) {
  const Scan scan = box_cloud(20000, 0.12, 2);  // 1 % of the diagonal, points 4 cm apart
  const FirstShapes first = find_first_shapes(scan, {});
  EXPECT_GT(worst_overlap(scan.labels.at("truth"), first.shape_of), 0.8);
}

TEST(FirstShapes, CountTheMomentsOfTheirElements) {
  const Scan scan = box_cloud(2000, 0.01, 3);
  const FirstShapes first = find_first_shapes(scan, {});
  std::vector<int> sizes(first.moments.size(), 0);
  for (int s : first.shape_of) {
    if (s >= 0) ++sizes[s];
  }
  for (size_t s = 0; s < sizes.size(); ++s) {
    EXPECT_EQ(first.moments[s].weight, sizes[s]);
    EXPECT_GE(sizes[s], 10);
  }
}

TEST(FirstShapes, AreAdjacentAcrossTheEdgesOfABox) {
  Scan scan = box_cloud(4000, 0.0, 4);
  const FirstShapes first = find_first_shapes(scan, {});
  const Trajectory trajectory = collapse(first);
  EXPECT_EQ(trajectory.num_shapes(trajectory.num_configurations() - 1), 1);
}

TEST(FirstShapes, DoNotDependOnTheNumberOfThreads) {
  const Scan scan = box_cloud(20000, 0.05, 5);
  FirstShapesOptions one, four;
  four.threads = 4;
  const FirstShapes a = find_first_shapes(scan, one), b = find_first_shapes(scan, four);
  EXPECT_EQ(a.shape_of, b.shape_of);
  EXPECT_EQ(a.adjacent, b.adjacent);
}

TEST(FirstShapes, OfACubesMeshAreItsSides) {
  const Scan scan = cube_mesh();
  const FirstShapes first = find_first_shapes(scan, {});
  ASSERT_EQ(first.moments.size(), 6u);
  EXPECT_EQ(first.adjacent.size(), 12u);
  for (const PointMoments& m : first.moments) EXPECT_NEAR(m.weight, 1.0, 1e-12);
  for (size_t f = 0; f < 12; f += 2) EXPECT_EQ(first.shape_of[f], first.shape_of[f + 1]);
}

TEST(FirstShapes, AreTheFacetsThemselvesForAnEpsilonOfZero) {
  FirstShapesOptions options;
  options.epsilon_percent = 0.0;
  const FirstShapes first = find_first_shapes(cube_mesh(), options);
  EXPECT_EQ(first.moments.size(), 12u);
  EXPECT_EQ(first.adjacent.size(), 18u);
}

TEST(FirstShapes, HoldTheExactMomentsOfFacets) {
  Scan scan;  // a rectangle of 4 x 2 m about (1, 1, 5)
  scan.points = {{-1, 0, 5}, {3, 0, 5}, {3, 2, 5}, {-1, 2, 5}};
  scan.facets.add(std::array{0, 1, 2, 3});
  const FirstShapes first = find_first_shapes(scan, {});
  ASSERT_EQ(first.moments.size(), 1u);
  const PointMoments& m = first.moments[0];
  EXPECT_NEAR(m.weight, 8.0, 1e-12);
  EXPECT_NEAR(m.scatter()(0, 0), 8.0 * 16.0 / 12.0, 1e-12);
  EXPECT_NEAR(m.scatter()(1, 1), 8.0 * 4.0 / 12.0, 1e-12);
  EXPECT_NEAR(m.scatter()(0, 1), 0.0, 1e-12);
}

TEST(FirstShapes, JoinFacetsWhoseCornersLieAtTheSamePlaces) {
  Scan soup;
  const Scan cube = cube_mesh();
  for (size_t f = 0; f < cube.facets.size(); ++f) {
    std::vector<int> corners;
    for (int c : cube.facets[f]) {
      corners.push_back(static_cast<int>(soup.points.size()));
      soup.points.push_back(cube.points[c]);
    }
    soup.facets.add(corners);
  }
  EXPECT_EQ(find_first_shapes(soup, {}).moments.size(), 6u);
}

TEST(FirstShapes, PassOverDegenerateAndNonManifoldFacets) {
  Scan scan = cube_mesh();
  scan.facets.add(std::array{0, 0, 1});     // no area
  scan.facets.add(std::array{0, 1, 1});     // no area
  scan.facets.add(std::array{0, 1, 7, 6});  // inside, on edges that have two facets already
  const FirstShapes first = find_first_shapes(scan, {});
  EXPECT_EQ(first.shape_of[12], -1);
  EXPECT_EQ(first.shape_of[13], -1);
  EXPECT_GE(first.shape_of[14], 0);
  EXPECT_EQ(first.moments.size(), 7u);
}

TEST(FirstShapes, AreNoneWhereThereIsNoSurface) {
  Scan scan;
  EXPECT_TRUE(find_first_shapes(scan, {}).moments.empty());
  scan.points.assign(1, {1, 2, 3});
  EXPECT_TRUE(find_first_shapes(scan, {}).moments.empty());
  scan.points.assign(500, {1, 2, 3});
  EXPECT_TRUE(find_first_shapes(scan, {}).moments.empty());
  scan.points.clear();
  for (int i = 0; i < 500; ++i) scan.points.push_back({0.1 * i, 0.2 * i, 0.3 * i});
  const FirstShapes line = find_first_shapes(scan, {});
  EXPECT_TRUE(line.moments.empty());
  EXPECT_EQ(line.shape_of, std::vector<int>(500, -1));
}

TEST(FirstShapes, NameTheBoundThatAnOptionViolates) {
  FirstShapesOptions options;
  EXPECT_EQ(check(options), "");
  options.neighbours = 2;
  EXPECT_NE(check(options).find("neighbours"), std::string::npos);
  options = {};
  options.epsilon_percent = -1.0;
  EXPECT_NE(check(options).find("epsilon_percent"), std::string::npos);
}

}  // namespace
}  // namespace gable
