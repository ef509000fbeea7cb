#include <gable/training/scans/building_surface.h>
#include <gable/training/scans/car_surface.h>
#include <gable/training/scans/indoor_surface.h>
#include <gable/training/scans/plane_attachment.h>
#include <gable/training/scans/sofa_surface.h>
#include <gable/training/scans/triangle_contact.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <map>
#include <set>

#include "training/scans/merging_agreement.h"

namespace gable {
namespace {

constexpr int kSeeds = 40;
/// Planes this near are neighbours in a scan: about the spacing of its points, of the diagonal.
constexpr double kContact = 0.008;

/// What is promised of a class.
struct SurfaceClass {
  const char* name;
  LabelledSurface (*make)(uint64_t seed);
  double min_diagonal, max_diagonal;  // metres
  std::array<int, 3> min_planes, max_planes;
  std::array<double, 2> mean_agreement;  // of merging with structure and hull
};

void PrintTo(const SurfaceClass& c, std::ostream* out) { *out << c.name; }

class RandomSurface : public testing::TestWithParam<SurfaceClass> {
 protected:
  static std::array<int, 3> count(const LabelledSurface& surface) {
    std::array<int, 3> out = {0, 0, 0};
    for (const auto& planes : surface.planes) {
      for (int k = 0; k < 3; ++k) out[k] = std::max(out[k], planes[k] + 1);
    }
    return out;
  }
};

INSTANTIATE_TEST_SUITE_P(
    Classes, RandomSurface,
    testing::Values(
        SurfaceClass{
            "building", random_building, 12.0, 70.0, {40, 6, 4}, {1600, 40, 14}, {0.95, 0.92}},
        SurfaceClass{
            "indoor", random_indoor_scene, 4.5, 9.5, {40, 10, 4}, {800, 70, 14}, {0.91, 0.86}},
        SurfaceClass{"car", random_car, 3.8, 6.0, {150, 9, 6}, {600, 14, 9}, {0.95, 0.94}},
        SurfaceClass{"sofa", random_sofa, 1.2, 3.6, {30, 6, 4}, {200, 18, 8}, {0.92, 0.84}}),
    [](const testing::TestParamInfo<SurfaceClass>& i) { return std::string(i.param.name); });

TEST_P(RandomSurface, FinestPlanesArePlanar) {
  for (int seed = 1; seed <= kSeeds; ++seed) {
    const LabelledSurface surface = GetParam().make(seed);
    std::map<int, PointMoments> moments;
    for (size_t i = 0; i < surface.triangles.size(); ++i) {
      const auto& [a, b, c] = surface.triangles[i];
      moments[surface.planes[i][0]] += triangle_moments(
          surface.vertices[a], surface.vertices[b], surface.vertices[c], Eigen::Vector3d::Zero());
    }
    std::map<int, Eigen::Hyperplane<double, 3>> planes;
    for (const auto& [plane, m] : moments) {
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(m.scatter());
      planes[plane] = {solver.eigenvectors().col(0), m.centroid()};
    }
    for (size_t i = 0; i < surface.triangles.size(); ++i) {
      for (int v : surface.triangles[i]) {
        ASSERT_LE(planes[surface.planes[i][0]].absDistance(surface.vertices[v]), 1e-3)
            << "seed " << seed << ", plane " << surface.planes[i][0];
      }
    }
  }
}

TEST_P(RandomSurface, ScalesNest) {
  for (int seed = 1; seed <= kSeeds; ++seed) {
    const LabelledSurface surface = GetParam().make(seed);
    ASSERT_EQ(surface.planes.size(), surface.triangles.size());
    for (int k : {0, 1}) {
      std::map<int, int> parent;
      for (const auto& planes : surface.planes) {
        ASSERT_EQ(parent.try_emplace(planes[k], planes[k + 1]).first->second, planes[k + 1]);
      }
    }
  }
}

TEST_P(RandomSurface, HasPlausiblyManyPlanesAtEveryScaleAndFewerAtCoarserOnes) {
  for (int seed = 1; seed <= kSeeds; ++seed) {
    const LabelledSurface surface = GetParam().make(seed);
    const std::array<int, 3> planes = count(surface);
    EXPECT_GT(planes[0], planes[1]) << "seed " << seed;
    EXPECT_GT(planes[1], planes[2]) << "seed " << seed;
    for (int k = 0; k < 3; ++k) {
      EXPECT_GE(planes[k], GetParam().min_planes[k]) << "seed " << seed << ", scale " << k + 1;
      EXPECT_LE(planes[k], GetParam().max_planes[k]) << "seed " << seed << ", scale " << k + 1;
      std::set<int> used;
      for (const auto& p : surface.planes) used.insert(p[k]);
      EXPECT_EQ(static_cast<int>(used.size()), planes[k]) << "numbers without gaps";
      EXPECT_EQ(*used.begin(), 0);
    }
  }
}

TEST_P(RandomSurface, HasAPlausibleSizeAndNoDegenerateTriangle) {
  for (int seed = 1; seed <= kSeeds; ++seed) {
    const LabelledSurface surface = GetParam().make(seed);
    EXPECT_GE(diagonal(surface), GetParam().min_diagonal) << "seed " << seed;
    EXPECT_LE(diagonal(surface), GetParam().max_diagonal) << "seed " << seed;
    for (const auto& [a, b, c] : surface.triangles) {
      const Eigen::Vector3d u = surface.vertices[b] - surface.vertices[a];
      const Eigen::Vector3d v = surface.vertices[c] - surface.vertices[a];
      ASSERT_GT(u.cross(v).norm(), 1e-4 * std::max(u.norm(), v.norm())) << "seed " << seed;
    }
  }
}

TEST_P(RandomSurface, IsOnePieceWhosePlanesAreConnected) {
  for (int seed = 1; seed <= kSeeds; ++seed) {
    const LabelledSurface surface = GetParam().make(seed);
    std::vector<TriangleCorners> triangles;
    std::vector<int> detail;
    std::map<int, std::array<int, 3>> of_detail;
    for (size_t i = 0; i < surface.triangles.size(); ++i) {
      const auto& [a, b, c] = surface.triangles[i];
      triangles.push_back({surface.vertices[a], surface.vertices[b], surface.vertices[c]});
      detail.push_back(surface.planes[i][0]);
      of_detail[detail.back()] = surface.planes[i];
    }
    const auto adjacent = touching_groups(triangles, detail, kContact * diagonal(surface));
    // Pieces of every plane of the structure (scale 1), of the hull (2) and of the whole (3).
    for (int scale : {1, 2, 3}) {
      std::vector<int> root(of_detail.size());
      for (size_t i = 0; i < root.size(); ++i) root[i] = static_cast<int>(i);
      const auto find = [&](int i) {
        while (root[i] != i) i = root[i] = root[root[i]];
        return i;
      };
      for (const auto& [a, b] : adjacent) {
        if (scale < 3 && of_detail[a][scale] != of_detail[b][scale]) continue;
        root[find(a)] = find(b);
      }
      std::map<int, std::set<int>> pieces;
      for (const auto& [d, planes] : of_detail) {
        pieces[scale < 3 ? planes[scale] : 0].insert(find(d));
      }
      int split = 0;
      for (const auto& [plane, roots] : pieces) split += roots.size() > 1;
      if (scale == 3) {
        EXPECT_EQ(split, 0) << "seed " << seed;
      } else {
        EXPECT_LE(split, 1 + static_cast<int>(pieces.size()) / 5)
            << "seed " << seed << ", scale " << scale + 1;
      }
    }
  }
}

TEST_P(RandomSurface, IsTheSameForTheSameSeedAndAnotherForAnother) {
  const LabelledSurface a = GetParam().make(7), b = GetParam().make(7), c = GetParam().make(8);
  EXPECT_EQ(a.vertices, b.vertices);
  EXPECT_EQ(a.triangles, b.triangles);
  EXPECT_EQ(a.planes, b.planes);
  EXPECT_NE(a.vertices, c.vertices);
}

TEST_P(RandomSurface, MergingByRmsPassesItsScales) {
  std::array<double, 2> mean = {0.0, 0.0};
  int in_order = 0;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    const LabelledSurface surface = GetParam().make(seed);
    const MergingAgreement agreement = merging_agreement(surface, kContact * diagonal(surface));
    for (int k : {0, 1}) mean[k] += agreement.best[k] / kSeeds;
    in_order += agreement.num_shapes[0] >= agreement.num_shapes[1];
  }
  EXPECT_GE(mean[0], GetParam().mean_agreement[0]);
  EXPECT_GE(mean[1], GetParam().mean_agreement[1]);
  EXPECT_EQ(in_order, kSeeds);
}

}  // namespace
}  // namespace gable
