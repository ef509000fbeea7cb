#include <gable/engine/scales/shape_plane.h>
#include <gable/grammar/random.h>
#include <gable/training/scans/plane_attachment.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

namespace gable {
namespace {

using Eigen::Vector3d;
using testing::ElementsAre;

Vector3d random_point(Random* random) {
  return {random->uniform(-1, 1), random->uniform(-1, 1), random->uniform(-1, 1)};
}

/// Planes as points, a chain with random further pairs.
struct Planes {
  std::vector<std::vector<Vector3d>> points;
  std::vector<PointMoments> moments;
  std::vector<std::pair<int, int>> adjacent;
};

Planes random_planes(int n, Random* random) {
  Planes out;
  for (int i = 0; i < n; ++i) {
    const Vector3d origin = random_point(random), u = random_point(random),
                   v = random_point(random);
    out.points.emplace_back();
    out.moments.emplace_back();
    for (int k = 0; k < 12; ++k) {
      out.points[i].push_back(origin + random->uniform(0, 1) * u + random->uniform(0, 1) * v);
      out.moments[i].add(out.points[i].back());
    }
    if (i > 0) out.adjacent.push_back({i - 1, i});
    if (i > 2) out.adjacent.push_back({random->integer(0, i - 2), i});
  }
  return out;
}

TEST(MergePlanes, TakesTheCheapestAdjacentPairOfAllEveryTime) {
  Random random(11);
  for (int trial = 0; trial < 20; ++trial) {
    const Planes planes = random_planes(14, &random);
    const std::vector<int> open(14, -1);
    const std::vector<Merge> merges = merge_planes(planes.moments, planes.adjacent, open);
    ASSERT_EQ(merges.size(), 13u);
    // The slow version: sets of points, all pairs, planes from the points themselves.
    std::vector<std::vector<int>> sets;
    for (int i = 0; i < 14; ++i) sets.push_back({i});
    for (const Merge& merge : merges) {
      double least = std::numeric_limits<double>::infinity(), chosen = 0.0;
      for (size_t a = 0; a < sets.size(); ++a) {
        for (size_t b = a + 1; b < sets.size(); ++b) {
          bool touching = false;
          for (const auto& [i, j] : planes.adjacent) {
            const auto in = [](const std::vector<int>& set, int k) {
              return std::find(set.begin(), set.end(), k) != set.end();
            };
            touching |= (in(sets[a], i) && in(sets[b], j)) || (in(sets[a], j) && in(sets[b], i));
          }
          if (!touching) continue;
          std::vector<Vector3d> points;
          for (const auto& set : {sets[a], sets[b]}) {
            for (int i : set) {
              points.insert(points.end(), planes.points[i].begin(), planes.points[i].end());
            }
          }
          const double rms = plane_rms(moments_of(points));
          least = std::min(least, rms);
          if (static_cast<int>(a) == merge.a && static_cast<int>(b) == merge.b) chosen = rms;
        }
      }
      EXPECT_NEAR(merge.weight, least, 1e-9);
      EXPECT_NEAR(chosen, least, 1e-9);
      std::vector<int> both = sets[merge.a];
      both.insert(both.end(), sets[merge.b].begin(), sets[merge.b].end());
      sets[merge.a].clear();
      sets[merge.b].clear();
      sets.push_back(both);
    }
  }
}

TEST(AttachPlanes, KeepsWhatIsKnownAndGivesTheRestToOneOfThem) {
  Random random(5);
  for (int trial = 0; trial < 50; ++trial) {
    const Planes planes = random_planes(20, &random);
    std::vector<int> seeds(20, -1);
    seeds[3] = 1;
    seeds[9] = 0;
    seeds[15] = 1;
    const std::vector<int> groups = attach_planes(planes.moments, planes.adjacent, seeds);
    for (int i = 0; i < 20; ++i) {
      if (seeds[i] >= 0) {
        EXPECT_EQ(groups[i], seeds[i]);
      }
      EXPECT_THAT(groups[i], testing::AnyOf(0, 1));
    }
  }
}

TEST(AttachPlanes, GivesWhatTouchesNothingKnownAGroupOfItsOwn) {
  std::vector<PointMoments> moments(4);
  for (int i = 0; i < 4; ++i) {
    moments[i] =
        triangle_moments({0, 0, 1.0 * i}, {1, 0, 1.0 * i}, {0, 1, 1.0 * i}, Vector3d::Zero());
  }
  const std::vector<std::pair<int, int>> adjacent = {{0, 1}, {2, 3}};
  EXPECT_THAT(attach_planes(moments, adjacent, std::vector<int>{-1, 0, -1, -1}),
              ElementsAre(0, 0, 1, 1));
}

}  // namespace
}  // namespace gable
