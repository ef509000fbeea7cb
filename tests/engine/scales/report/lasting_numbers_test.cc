#include <gable/engine/scales/report/lasting_numbers.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include "engine/scales/report/sample_trajectory.h"

namespace gable {
namespace {

/// First shapes per shape, merged one after the other.
std::vector<std::set<int>> plainly(const Trajectory& trajectory, int configuration) {
  std::map<int, std::set<int>> shapes;
  for (int i = 0; i < trajectory.num_first; ++i) shapes[i] = {i};
  for (int i = 0; i < configuration; ++i) {
    const Merge& merge = trajectory.merges[i];
    std::set<int> both = shapes[merge.a];
    both.insert(shapes[merge.b].begin(), shapes[merge.b].end());
    shapes.erase(merge.a);
    shapes.erase(merge.b);
    shapes[trajectory.num_first + i] = both;
  }
  std::vector<std::set<int>> out;
  for (const auto& [number, shape] : shapes) out.push_back(shape);
  return out;
}

TEST(LastingNumbers, AreThoseFromZeroOnePerShape) {
  const SampleTrajectory sample(60, 3);
  const LastingNumbers numbers(sample.trajectory, sample.first_shapes);
  for (int c = 0; c < sample.trajectory.num_configurations(); ++c) {
    const std::vector<int> at = numbers.at(c);
    ASSERT_EQ(at.size(), 60u);
    std::set<int> used;
    for (const std::set<int>& shape : plainly(sample.trajectory, c)) {
      for (const int first : shape) EXPECT_EQ(at[first], at[*shape.begin()]);
      used.insert(at[*shape.begin()]);
    }
    EXPECT_EQ(static_cast<int>(used.size()), sample.trajectory.num_shapes(c));
    EXPECT_EQ(*used.rbegin(), sample.trajectory.num_shapes(c) - 1);
  }
}

TEST(LastingNumbers, StayWithTheLargerPart) {
  const SampleTrajectory sample(60, 4);
  const LastingNumbers numbers(sample.trajectory, sample.first_shapes);
  for (int c = 0; c + 1 < sample.trajectory.num_configurations(); ++c) {
    const std::vector<int> before = numbers.at(c), after = numbers.at(c + 1);
    for (const std::set<int>& shape : plainly(sample.trajectory, c + 1)) {
      std::map<int, int> count;
      for (const int first : shape) ++count[before[first]];
      int most = 0;
      for (const auto& [number, n] : count) most = std::max(most, n);
      EXPECT_EQ(count[after[*shape.begin()]], most);
    }
  }
}

}  // namespace
}  // namespace gable
