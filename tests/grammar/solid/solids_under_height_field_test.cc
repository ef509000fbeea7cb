#include <gable/grammar/height_field.h>
#include <gable/grammar/ring.h>
#include <gable/grammar/solid/block_alignment.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "grammar/solid/built_houses.h"
#include "grammar/solid/nasty_houses.h"

namespace gable {
namespace {

// Height of the highest upward face over a point of the local frame, or `ground`.
double top_at(const HouseSolids& solids, const Eigen::Vector2d& p, double ground) {
  double top = ground;
  for (const HousePart& part : solids.parts) {
    for (const Face& face : part.solid.faces) {
      if (face.type != SurfaceType::kRoof) continue;
      int inside = 0;
      for (const std::vector<int>& ring : face.rings) {
        std::vector<Eigen::Vector2d> points;
        for (const int v : ring) points.push_back(part.solid.vertices[v].head<2>());
        inside += ring_holds(points, p);
      }
      if (inside != 1) continue;
      // Plane through the ring's first vertex with its Newell normal.
      const std::vector<int>& ring = face.rings[0];
      const Eigen::Vector3d first = part.solid.vertices[ring[0]];
      Eigen::Vector3d normal = Eigen::Vector3d::Zero();
      for (size_t i = 1; i + 1 < ring.size(); ++i) {
        normal +=
            (part.solid.vertices[ring[i]] - first).cross(part.solid.vertices[ring[i + 1]] - first);
      }
      const double z = first.z() - (normal.head<2>().dot(p - first.head<2>())) / normal.z();
      top = std::max(top, z);
    }
  }
  return top;
}

// Whether alignment leaves every block where it is.
bool is_aligned(const House& house) {
  const std::vector<Block<double>> blocks = expand_blocks(house);
  const std::vector<Block<double>> aligned = BlockAlignment(blocks, kBase).blocks();
  for (size_t i = 0; i < blocks.size(); ++i) {
    if (blocks[i].flat != aligned[i].flat) return false;
    for (int k = 0; k < kNumBlockValues; ++k) {
      if (std::abs(blocks[i][k] - aligned[i][k]) > 1e-9) return false;
    }
  }
  return true;
}

// Whether a point of the house frame lies within 1 cm of the line of some block's edge.
bool near_edge(const std::vector<Block<double>>& blocks, const Eigen::Vector2d& p) {
  using namespace block_value;
  for (const Block<double>& block : blocks) {
    for (const int k : {kX0, kX1}) {
      if (std::abs(p.x() - block[k]) < 0.01) return true;
    }
    for (const int k : {kY0, kY1}) {
      if (std::abs(p.y() - block[k]) < 0.01) return true;
    }
  }
  return false;
}

TEST(HouseSolids, RoofsFollowTheHeightField) {
  NastyHouses houses(11);
  Random random(12);
  int houses_compared = 0, points_compared = 0;
  for (int i = 0; i < 1500; ++i) {
    const House house = houses.next();
    if (!is_aligned(house)) continue;
    ++houses_compared;
    const HeightField field(house);
    const HouseSolids solids = build_house_solids(house, Lod::k22, kBase);
    for (int k = 0; k < 100; ++k) {
      const Eigen::Vector2d p(random.uniform(-15, 25), random.uniform(-15, 25));
      if (near_edge(field.blocks(), p)) continue;
      const Eigen::Vector2d local = field.local_from_house(p);
      ASSERT_NEAR(top_at(solids, local, kBase), field.at_local(local, 0.0, kBase), 0.01)
          << "house " << i << " at " << p.transpose();
      ++points_compared;
    }
  }
  EXPECT_GT(houses_compared, 100);
  EXPECT_GT(points_compared, 10000);
}

// Integral of the height field above the base: midpoint rule on the cells between all edges, where
// the field is continuous.
double integral(const HeightField& field) {
  using namespace block_value;
  std::vector<double> x, y;
  for (const Block<double>& block : field.blocks()) {
    if (block[kX0] < block[kX1]) x.insert(x.end(), {block[kX0], block[kX1]});
    if (block[kY0] < block[kY1]) y.insert(y.end(), {block[kY0], block[kY1]});
  }
  std::sort(x.begin(), x.end());
  std::sort(y.begin(), y.end());
  constexpr int n = 20;
  double sum = 0.0;
  for (size_t i = 0; i + 1 < x.size(); ++i) {
    for (size_t j = 0; j + 1 < y.size(); ++j) {
      const double dx = (x[i + 1] - x[i]) / n, dy = (y[j + 1] - y[j]) / n;
      for (int k = 0; k < n * n; ++k) {
        const Eigen::Vector2d p(x[i] + (k % n + 0.5) * dx, y[j] + (k / n + 0.5) * dy);
        sum += (field.at_house(p, 0.0, kBase) - kBase) * dx * dy;
      }
    }
  }
  return sum;
}

TEST(HouseSolids, PartsTogetherHoldTheVolumeUnderTheHeightField) {
  NastyHouses houses(21);
  int compared = 0;
  for (int i = 0; i < 2000; ++i) {
    const House house = houses.next();
    if (!is_aligned(house)) continue;
    ++compared;
    const double expected = integral(HeightField(house));
    EXPECT_NEAR(total_volume(build_house_solids(house, Lod::k22, kBase)), expected,
                2e-3 * expected);
  }
  EXPECT_GT(compared, 80);
}

}  // namespace
}  // namespace gable
