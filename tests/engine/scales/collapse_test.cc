#include <gable/engine/scales/collapse.h>
#include <gable/engine/scales/feature_histograms.h>
#include <gable/engine/scales/shape_plane.h>
#include <gable/grammar/random.h>
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <map>
#include <set>

namespace gable {
namespace {

// Random small patches on a grid, each adjacent to some of the others.
struct RandomShapes {
  FirstShapes first;
  std::vector<std::vector<Eigen::Vector3d>> points;  ///< per shape

  RandomShapes(int count, uint64_t seed) {
    Random random(seed);
    first.diagonal = 30.0;
    for (int i = 0; i < count; ++i) {
      const Eigen::Vector3d centre(random.uniform(-8, 8), random.uniform(-8, 8),
                                   random.uniform(-8, 8));
      const int inliers = random.integer(3, 12);
      PointMoments moments;
      points.emplace_back();
      for (int j = 0; j < inliers; ++j) {
        const Eigen::Vector3d p =
            centre + Eigen::Vector3d(random.normal(1.0), random.normal(0.5), random.normal(0.1));
        points.back().push_back(p);
        moments.add(p);
      }
      first.moments.push_back(moments);
    }
    std::set<std::pair<int, int>> pairs;
    for (int i = 0; i < 3 * count; ++i) {
      const int a = random.integer(0, count - 1), b = random.integer(0, count - 1);
      if (a != b) pairs.insert(std::minmax(a, b));
    }
    first.adjacent.assign(pairs.begin(), pairs.end());
  }
};

// RMS distance of points to their best plane, from the points themselves.
double rms_of(const std::vector<Eigen::Vector3d>& points) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p : points) mean += p / static_cast<double>(points.size());
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& p : points) scatter += (p - mean) * (p - mean).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(scatter);
  const Eigen::Vector3d normal = eigen.eigenvectors().col(0);
  double squares = 0.0;
  for (const Eigen::Vector3d& p : points) squares += std::pow(normal.dot(p - mean), 2);
  return std::sqrt(squares / static_cast<double>(points.size()));
}

// The same process without moments, heap or local updates: every pair anew at every step.
std::vector<Merge> slow_collapse(const RandomShapes& shapes) {
  std::map<int, std::vector<Eigen::Vector3d>> points;
  for (size_t i = 0; i < shapes.points.size(); ++i) points[static_cast<int>(i)] = shapes.points[i];
  std::set<std::pair<int, int>> pairs(shapes.first.adjacent.begin(), shapes.first.adjacent.end());
  std::vector<Merge> merges;
  int made = static_cast<int>(points.size());
  while (!pairs.empty()) {
    Merge best{-1, -1, 1e300};
    for (const auto& [a, b] : pairs) {
      std::vector<Eigen::Vector3d> united = points[a];
      united.insert(united.end(), points[b].begin(), points[b].end());
      const double weight = rms_of(united);
      if (weight < best.weight) best = {a, b, weight};
    }
    merges.push_back(best);
    points[made] = points[best.a];
    points[made].insert(points[made].end(), points[best.b].begin(), points[best.b].end());
    std::set<std::pair<int, int>> next;
    for (auto [a, b] : pairs) {
      if (a == best.a || a == best.b) a = made;
      if (b == best.a || b == best.b) b = made;
      if (a != b) next.insert(std::minmax(a, b));
    }
    pairs = next;
    ++made;
  }
  return merges;
}

TEST(Collapse, MergesAsAProcessThatTriesEveryPairOnAllPointsAtEveryStep) {
  for (uint64_t seed = 1; seed <= 20; ++seed) {
    const RandomShapes shapes(30, seed);
    const Trajectory trajectory = collapse(shapes.first);
    const std::vector<Merge> slow = slow_collapse(shapes);
    ASSERT_EQ(trajectory.merges.size(), slow.size()) << seed;
    for (size_t i = 0; i < slow.size(); ++i) {
      EXPECT_EQ(trajectory.merges[i].a, slow[i].a) << seed << " step " << i;
      EXPECT_EQ(trajectory.merges[i].b, slow[i].b) << seed << " step " << i;
      EXPECT_NEAR(trajectory.merges[i].weight, slow[i].weight, 1e-9) << seed << " step " << i;
    }
  }
}

// The features of a configuration counted from its shapes and the adjacency of the first ones.
ScaleFeatures recount(const FirstShapes& first, const std::vector<int>& shape_of_first) {
  const int n = *std::max_element(shape_of_first.begin(), shape_of_first.end()) + 1;
  std::vector<PointMoments> moments(n);
  for (size_t i = 0; i < shape_of_first.size(); ++i) moments[shape_of_first[i]] += first.moments[i];
  std::vector<ShapeOutline> outlines;
  for (const PointMoments& m : moments) {
    const ShapePlane plane = shape_plane(m);
    outlines.push_back({plane.centroid, plane.normal, m.weight});
  }
  std::set<std::pair<int, int>> pairs;
  for (const auto& [a, b] : first.adjacent) {
    const int sa = shape_of_first[a], sb = shape_of_first[b];
    if (sa != sb) pairs.insert(std::minmax(sa, sb));
  }
  FeatureHistograms histograms(first.diagonal);
  for (const auto& [a, b] : pairs) histograms.add(outlines[a], outlines[b]);
  return histograms.features();
}

TEST(Collapse, KeepsTheFeaturesOfAFullRecountAtEveryStep) {
  for (uint64_t seed = 1; seed <= 5; ++seed) {
    const RandomShapes shapes(60, 100 + seed);
    const Trajectory trajectory = collapse(shapes.first);
    ASSERT_EQ(trajectory.features.size(), trajectory.merges.size() + 1);
    for (int i = 0; i < trajectory.num_configurations(); ++i) {
      const ScaleFeatures slow = recount(shapes.first, shapes_at(trajectory, i));
      for (int f = 0; f < kNumFeatures; ++f) {
        EXPECT_FLOAT_EQ(trajectory.features[i][f], slow[f])
            << seed << " step " << i << " bin " << f;
      }
    }
  }
}

TEST(Collapse, EndsWithOneShapePerConnectedGroup) {
  RandomShapes shapes(12, 7);
  std::erase_if(shapes.first.adjacent,
                [](const auto& pair) { return (pair.first < 6) != (pair.second < 6); });
  for (int i = 0; i + 1 < 12; ++i) {
    if (i != 5) shapes.first.adjacent.push_back({i, i + 1});
  }
  std::sort(shapes.first.adjacent.begin(), shapes.first.adjacent.end());
  shapes.first.adjacent.erase(
      std::unique(shapes.first.adjacent.begin(), shapes.first.adjacent.end()),
      shapes.first.adjacent.end());
  const Trajectory trajectory = collapse(shapes.first);
  EXPECT_EQ(trajectory.num_shapes(trajectory.num_configurations() - 1), 2);
  const std::vector<int> last = shapes_at(trajectory, trajectory.num_configurations() - 1);
  for (int i = 0; i < 12; ++i) EXPECT_EQ(last[i], i < 6 ? 0 : 1);
}

TEST(Collapse, LeavesNothingToDoWhereNothingIsAdjacent) {
  RandomShapes shapes(4, 3);
  shapes.first.adjacent.clear();
  const Trajectory trajectory = collapse(shapes.first);
  EXPECT_TRUE(trajectory.merges.empty());
  ASSERT_EQ(trajectory.features.size(), 1u);
  for (float f : trajectory.features[0]) EXPECT_EQ(f, 0.0f);
}

TEST(Trajectory, ReadsOffAnyConfiguration) {
  Trajectory trajectory;
  trajectory.num_first = 5;
  trajectory.merges = {{1, 3, 0.1}, {0, 5, 0.2}, {2, 4, 0.3}, {6, 7, 0.4}};
  EXPECT_EQ(shapes_at(trajectory, 0), (std::vector<int>{0, 1, 2, 3, 4}));
  EXPECT_EQ(shapes_at(trajectory, 1), (std::vector<int>{0, 1, 2, 1, 3}));
  EXPECT_EQ(shapes_at(trajectory, 2), (std::vector<int>{0, 0, 1, 0, 2}));
  EXPECT_EQ(shapes_at(trajectory, 3), (std::vector<int>{0, 0, 1, 0, 1}));
  EXPECT_EQ(shapes_at(trajectory, 4), (std::vector<int>{0, 0, 0, 0, 0}));
}

}  // namespace
}  // namespace gable
