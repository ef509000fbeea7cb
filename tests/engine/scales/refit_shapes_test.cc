#include <gable/engine/scales/refit_shapes.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/scales/synthetic_houses.h"

namespace gable {
namespace {

double angle(const OrientedPlane& a, const OrientedPlane& b) {
  return std::asin(std::min(1.0, a.normal().cross(b.normal()).norm()));
}

struct Errors {
  double before = 0.0, after = 0.0;  ///< sums of angles, radians
  double factor() const { return before / after; }
};

Errors errors(HouseKind kind, int houses, int points, double outliers) {
  Errors out;
  for (int seed = 0; seed < houses; ++seed) {
    Random random(7 * seed + 1);
    const SyntheticHouse house = random_house(kind, &random);
    std::vector<int> shape_of;
    const Scan scan =
        scan_house(house, points, 0.01 * house.diagonal, outliers, &random, &shape_of);
    const PlaneRefit refit = refit_shapes(scan, shape_of, {});
    for (size_t i = 0; i < house.facets.size(); ++i) {
      out.before += angle(refit.before[i], house.plane(i)) / house.facets.size();
      out.after += angle(refit.after[i], house.plane(i)) / house.facets.size();
    }
  }
  return out;
}

constexpr HouseKind kAllKinds[] = {HouseKind::kBox, HouseKind::kGable, HouseKind::kHip,
                                   HouseKind::kEvenHip};

// How far angles can fall is a matter of counting: with all true regularities given, about 7 for
// boxes, 3 for gables and even hips, and 2.5 for hips whose ends share no slope with their sides.
TEST(RefitShapes, TheAnglesOfBoxesAndRoofsFallThreefold) {
  Errors all;
  for (const HouseKind kind : kAllKinds) {
    const Errors own = errors(kind, 20, 20000, 0.0);
    all.before += own.before, all.after += own.after;
    EXPECT_GT(own.factor(), 1.9);
  }
  EXPECT_GT(all.factor(), 3.0);
}

TEST(RefitShapes, TheAnglesOfEveryKindFallThreefoldWhereSomeInliersAreNone) {
  for (const HouseKind kind : kAllKinds) EXPECT_GT(errors(kind, 20, 20000, 0.05).factor(), 3.0);
}

TEST(RefitShapes, SaysWhatItFoundAndWhatItCost) {
  Random random(3);
  const SyntheticHouse house = random_house(HouseKind::kBox, &random);
  std::vector<int> shape_of;
  const Scan scan = scan_house(house, 3000, 0.05, 0.02, &random, &shape_of);
  const PlaneRefit refit = refit_shapes(scan, shape_of, {});
  const auto count = [&](RegularityKind kind) {
    return std::count_if(refit.regularities.begin(), refit.regularities.end(),
                         [&](const PlaneRegularity& r) { return r.kind == kind; });
  };
  EXPECT_EQ(count(RegularityKind::kVertical), 4);
  EXPECT_EQ(count(RegularityKind::kHorizontal), 1);
  EXPECT_EQ(count(RegularityKind::kParallel), 2);
  EXPECT_EQ(count(RegularityKind::kOrthogonal), 1);
  EXPECT_EQ(refit.regularities.size(), 8u);
  EXPECT_EQ(refit.termination, Termination::kConverged);
  EXPECT_LT(refit.cost_after, refit.cost_before);
  EXPECT_GE(refit.rms_after, refit.rms_before);
  EXPECT_LT(refit.rms_after, 1.1 * refit.rms_before);
  EXPECT_GT(refit.reweightings, 0);
  // Least squares' own RMS, the slow way.
  double squares = 0.0;
  for (size_t i = 0; i < shape_of.size(); ++i) {
    squares += std::pow(refit.before[shape_of[i]].signed_distance(scan.points[i]), 2);
  }
  EXPECT_NEAR(refit.rms_before, std::sqrt(squares / shape_of.size()), 1e-9);
}

TEST(RefitShapes, WithoutRegularitiesEachPlaneIsFittedAlone) {
  Random random(3);
  const SyntheticHouse house = random_house(HouseKind::kGable, &random);
  std::vector<int> shape_of;
  Scan scan = scan_house(house, 3000, 0.05, 0.0, &random, &shape_of);
  RefitOptions options;
  options.regularities = false;
  options.loss_scale = 100.0;  // squares
  const PlaneRefit refit = refit_shapes(scan, shape_of, options);
  EXPECT_TRUE(refit.regularities.empty());
  for (size_t i = 0; i < refit.before.size(); ++i) {
    EXPECT_LT(angle(refit.before[i], refit.after[i]), 1e-4);
  }
}

TEST(RefitShapes, AWallThatTrulyLeansStaysSo) {
  Random random(5);
  SyntheticHouse house = random_house(HouseKind::kBox, &random);
  for (int corner : {2, 3}) house.facets[0][corner] += 0.35 * house.plane(0).normal();
  std::vector<int> shape_of;
  const Scan scan = scan_house(house, 20000, 0.02, 0.0, &random, &shape_of);
  const double lean = std::asin(std::abs(house.plane(0).normal().z()));
  ASSERT_GT(lean, 0.04);
  const PlaneRefit refit = refit_shapes(scan, shape_of, {});
  EXPECT_LT(angle(refit.after[0], house.plane(0)), 0.1 * lean);
}

TEST(RefitShapes, ManyHousesOfAllAzimuthsDoNotBendEachOther) {
  Scan all;
  std::vector<int> shape_of;
  std::vector<OrientedPlane> truth;
  for (int i = 0; i < 60; ++i) {
    Random random(i);
    const SyntheticHouse house = random_house(kAllKinds[i % 4], &random);
    std::vector<int> own;
    const Scan scan = scan_house(house, 2500, 0.05, 0.0, &random, &own);
    const Eigen::Vector3d lot(20.0 * (i % 8), 20.0 * (i / 8), 0.0);
    for (int shape : own) shape_of.push_back(static_cast<int>(truth.size()) + shape);
    for (const Eigen::Vector3d& p : scan.points) all.points.push_back(p + lot);
    for (size_t f = 0; f < house.facets.size(); ++f) truth.push_back(house.plane(f));
  }
  const PlaneRefit refit = refit_shapes(all, shape_of, {});
  Errors sums;
  double worst = 0.0;
  for (size_t i = 0; i < truth.size(); ++i) {
    sums.before += angle(refit.before[i], truth[i]);
    sums.after += angle(refit.after[i], truth[i]);
    worst = std::max(worst, angle(refit.after[i], truth[i]));
  }
  EXPECT_GT(sums.factor(), 1.2);
  EXPECT_LT(worst, 0.03);
  EXPECT_LT(refit.rms_after, 1.02 * refit.rms_before);
}

// The facets of a house as triangles of a grid, moved by noise.
Scan house_mesh(const SyntheticHouse& house, double noise, Random* random,
                std::vector<int>* shape_of) {
  Scan scan;
  constexpr int kSteps = 12;
  for (size_t f = 0; f < house.facets.size(); ++f) {
    const auto& ring = house.facets[f];
    for (size_t i = 2; i < ring.size(); ++i) {
      const int base = static_cast<int>(scan.points.size());
      const auto at = [&](int a, int b) { return base + a * (kSteps + 1) + b; };
      for (int a = 0; a <= kSteps; ++a) {
        for (int b = 0; b <= kSteps; ++b) {
          scan.points.push_back(
              ring[0] + (ring[i - 1] - ring[0]) * a / kSteps + (ring[i] - ring[0]) * b / kSteps +
              Eigen::Vector3d(random->normal(noise), random->normal(noise), random->normal(noise)));
        }
      }
      for (int a = 0; a < kSteps; ++a) {
        for (int b = 0; a + b < kSteps; ++b) {
          scan.facets.add(std::vector{at(a, b), at(a + 1, b), at(a, b + 1)});
          shape_of->push_back(static_cast<int>(f));
          if (a + b + 2 > kSteps) continue;
          scan.facets.add(std::vector{at(a + 1, b), at(a + 1, b + 1), at(a, b + 1)});
          shape_of->push_back(static_cast<int>(f));
        }
      }
    }
  }
  return scan;
}

TEST(RefitShapes, MeshesAreRefittedByArea) {
  Random random(11);
  const SyntheticHouse house = random_house(HouseKind::kBox, &random);
  std::vector<int> shape_of;
  const Scan exact = house_mesh(house, 0.0, &random, &shape_of);
  const PlaneRefit same = refit_shapes(exact, shape_of, {});
  for (size_t i = 0; i < house.facets.size(); ++i) {
    EXPECT_LT(angle(same.after[i], house.plane(i)), 1e-6);
  }
  EXPECT_LT(same.rms_after, 1e-6);

  shape_of.clear();
  const Scan noisy = house_mesh(house, 0.01 * house.diagonal, &random, &shape_of);
  const PlaneRefit refit = refit_shapes(noisy, shape_of, {});
  Errors sums;
  for (size_t i = 0; i < house.facets.size(); ++i) {
    sums.before += angle(refit.before[i], house.plane(i));
    sums.after += angle(refit.after[i], house.plane(i));
  }
  EXPECT_GT(sums.factor(), 3.0);
}

TEST(RefitShapes, ShapesThatAreNoPlanesAreLeftAlone) {
  Scan scan;
  const PlaneRefit none = refit_shapes(scan, {}, {});
  EXPECT_TRUE(none.after.empty());
  scan.points = {{0, 0, 0}, {1, 0, 0}, {5, 5, 5}, {5, 5, 5},
                 {5, 5, 5}, {0, 0, 1}, {1, 0, 1}, {2, 0, 1}};
  // Two points, three equal ones, a line, and a shape without elements.
  const PlaneRefit refit = refit_shapes(scan, {0, 0, 1, 1, 1, 3, 3, 3}, {});
  ASSERT_EQ(refit.after.size(), 4u);
  for (const OrientedPlane& plane : refit.after) {
    EXPECT_TRUE(plane.values.allFinite());
    EXPECT_NEAR(plane.normal().norm(), 1.0, 1e-9);
  }
}

TEST(RefitShapes, NamesTheViolatedBound) {
  RefitOptions options;
  EXPECT_EQ(check(options), "");
  options.loss_scale = 0.0;
  EXPECT_EQ(check(options), "loss_scale must lie in (0, 100]");
  options = {};
  options.deviations = 0.0;
  EXPECT_EQ(check(options), "deviations must lie in [1, 10]");
}

}  // namespace
}  // namespace gable
