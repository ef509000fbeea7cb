#include <gable/engine/scales/neighbours.h>
#include <gable/grammar/random.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace gable {
namespace {

OrderedCloud random_cloud(int count, uint64_t seed) {
  Random random(seed);
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < count; ++i) {
    points.push_back(
        {85000.0 + random.uniform(0, 20), 447000.0 + random.uniform(0, 10), random.uniform(0, 3)});
  }
  return order_cloud(points);
}

TEST(OrderedCloud, HoldsEveryPointOnceRelativeToTheCentreOfTheBox) {
  const std::vector<Eigen::Vector3d> points = {{10, 0, 0}, {14, 2, 4}, {11, 1, 1}, {11, 1, 1}};
  const OrderedCloud cloud = order_cloud(points);
  EXPECT_DOUBLE_EQ(cloud.diagonal, 6.0);
  EXPECT_EQ(cloud.centre, Eigen::Vector3d(12, 1, 2));
  EXPECT_EQ(std::set<int>(cloud.source.begin(), cloud.source.end()).size(), points.size());
  for (int i = 0; i < cloud.size(); ++i) {
    EXPECT_EQ(cloud.positions[i].cast<double>() + cloud.centre, points[cloud.source[i]]);
  }
}

TEST(OrderedCloud, PutsNearPointsNearEachOther) {
  const OrderedCloud cloud = random_cloud(20000, 1);
  double along = 0.0;
  for (int i = 1; i < cloud.size(); ++i) {
    along += (cloud.positions[i] - cloud.positions[i - 1]).norm() / cloud.size();
  }
  EXPECT_LT(along, 1.0);  // points in no order are 9 m apart
}

TEST(Neighbours, AreThoseOfASearchThroughAllPoints) {
  const OrderedCloud cloud = random_cloud(1500, 2);
  const Neighbours neighbours = find_neighbours(cloud, 20, 2);
  ASSERT_EQ(neighbours.k, 20);
  for (int i = 0; i < cloud.size(); ++i) {
    std::vector<std::pair<float, int>> all;
    for (int j = 0; j < cloud.size(); ++j) {
      if (j != i) all.push_back({(cloud.positions[j] - cloud.positions[i]).squaredNorm(), j});
    }
    std::partial_sort(all.begin(), all.begin() + 20, all.end());
    for (int k = 0; k < 20; ++k) {
      const float distance =
          (cloud.positions[neighbours.of(i)[k]] - cloud.positions[i]).squaredNorm();
      EXPECT_FLOAT_EQ(distance, all[k].first) << i << " " << k;
    }
  }
}

TEST(Neighbours, LeaveOutThePointItselfAmongPointsAtTheSamePlace) {
  const OrderedCloud cloud = order_cloud(std::vector<Eigen::Vector3d>(50, {1, 2, 3}));
  const Neighbours neighbours = find_neighbours(cloud, 20, 1);
  for (int i = 0; i < cloud.size(); ++i) {
    const auto around = neighbours.of(i);
    EXPECT_EQ(std::count(around.begin(), around.end(), i), 0);
    EXPECT_EQ(std::set<int>(around.begin(), around.end()).size(), 20u);
  }
}

TEST(Neighbours, AreAllOtherPointsOfASmallCloud) {
  const Neighbours neighbours = find_neighbours(random_cloud(5, 3), 20, 1);
  EXPECT_EQ(neighbours.k, 4);
  EXPECT_EQ(find_neighbours(random_cloud(1, 3), 20, 1).k, 0);
}

TEST(Neighbours, DoNotDependOnTheNumberOfThreads) {
  const OrderedCloud cloud = random_cloud(20000, 4);
  EXPECT_EQ(find_neighbours(cloud, 20, 1).indices, find_neighbours(cloud, 20, 4).indices);
}

}  // namespace
}  // namespace gable
