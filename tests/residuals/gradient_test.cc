#include <ceres/autodiff_cost_function.h>
#include <gable/grammar/random.h>
#include <gable/residuals/house_relations.h>
#include <gable/residuals/moments_to_plane.h>
#include <gable/residuals/outline_to_footprint.h>
#include <gable/residuals/pixel_height_residual.h>
#include <gable/residuals/plane_relations.h>
#include <gable/residuals/point_to_plane.h>
#include <gable/residuals/testing/gradient_check.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "residuals/random_houses.h"

namespace gable {
namespace {

constexpr int kPoints = 1000;
constexpr double kTolerance = 1e-6;

Eigen::Vector3d random_point(Random* random, double range) {
  return {random->uniform(-range, range), random->uniform(-range, range),
          random->uniform(-range, range)};
}

std::vector<double> random_plane(Random* random) {
  Eigen::Vector3d normal = random_point(random, 1.0);
  while (normal.norm() < 0.1) normal = random_point(random, 1.0);
  normal.normalize();
  return {normal.x(), normal.y(), normal.z(), random->uniform(-10.0, 10.0)};
}

void expect_exact(std::unique_ptr<ceres::CostFunction> cost,
                  const std::vector<std::vector<double>>& at,
                  const GradientCheckOptions& options = {}) {
  const GradientCheckResult result = check_gradient(*cost, at, options);
  ASSERT_TRUE(result.evaluated);
  ASSERT_LT(result.relative_error, kTolerance) << result.report();
}

// r0 = x^2 y, r1 = sin x, with a wrong Jacobian on request.
class Suspect : public ceres::SizedCostFunction<2, 2> {
 public:
  explicit Suspect(double defect) : defect_(defect) {}
  bool Evaluate(double const* const* p, double* r, double** j) const override {
    const double x = p[0][0], y = p[0][1];
    r[0] = x * x * y;
    r[1] = std::sin(x);
    if (j != nullptr && j[0] != nullptr) {
      j[0][0] = 2.0 * x * y;
      j[0][1] = x * x * (1.0 + defect_);
      j[0][2] = std::cos(x);
      j[0][3] = 0.0;
    }
    return true;
  }

 private:
  double defect_;
};

TEST(Gradient, CheckerFindsAWrongEntryAndPassesARightOne) {
  EXPECT_LT(check_gradient(Suspect(0.0), {{1.3, -0.7}}).relative_error, 1e-9);
  const GradientCheckResult wrong = check_gradient(Suspect(1e-5), {{1.3, -0.7}});
  EXPECT_NEAR(wrong.relative_error, 1e-5, 1e-7);
  EXPECT_EQ(wrong.residual, 0);
  EXPECT_EQ(wrong.parameter, 1);
}

TEST(Gradient, PointToPlane) {
  Random random(1);
  for (int i = 0; i < kPoints; ++i) {
    expect_exact(std::unique_ptr<ceres::CostFunction>(
                     PointToPlane::create(random_point(&random, 20.0), random.uniform(0.1, 3.0))),
                 {random_plane(&random)});
  }
}

TEST(Gradient, MomentsToPlane) {
  Random random(2);
  for (int i = 0; i < kPoints; ++i) {
    PointMoments moments;
    moments.reference = random_point(&random, 20.0);
    for (int k = 0; k < 12; ++k) {
      moments.add(random_point(&random, 20.0), random.uniform(0.1, 2.0));
    }
    expect_exact(std::make_unique<MomentsToPlane>(moments), {random_plane(&random)});
  }
}

TEST(Gradient, PlaneRelations) {
  Random random(3);
  for (int i = 0; i < kPoints; ++i) {
    const std::vector<double> a = random_plane(&random), b = random_plane(&random);
    const double weight = random.uniform(0.1, 3.0);
    using Owned = std::unique_ptr<ceres::CostFunction>;
    expect_exact(Owned(ParallelPlanes::create(weight)), {a, b});
    expect_exact(Owned(OrthogonalPlanes::create(weight)), {a, b});
    // Keeps clear of the kink of |normal.z| at vertical planes and of horizontal ones.
    const auto inclined = [](const std::vector<double>& p) {
      return std::abs(p[2]) > 0.05 && std::abs(p[2]) < 0.95;
    };
    if (inclined(a) && inclined(b)) {
      expect_exact(Owned(EquallySteepPlanes::create(weight)), {a, b});
    }
    expect_exact(
        Owned(CoplanarPlanes::create(random_point(&random, 9.0), random_point(&random, 9.0), weight,
                                     random.uniform(0.1, 3.0))),
        {a, b});
    expect_exact(Owned(HorizontalPlane::create(weight)), {a});
    expect_exact(Owned(VerticalPlane::create(weight)), {a});
  }
}

std::vector<std::vector<double>> values_of(const House& house, const std::vector<int>& rules) {
  std::vector<std::vector<double>> values;
  const auto derivation = house.derivation();
  for (int rule : rules) {
    const auto p = derivation[rule]->parameters();
    values.emplace_back(p.begin(), p.end());
  }
  return values;
}

TEST(Gradient, HouseRelations) {
  Random random(4);
  for (int i = 0; i < kPoints; ++i) {
    House house = rich_house(kAllFoundations[1 + i % 4], &random);
    house.dormers[1].component = house.dormers[0].component;
    house.roofs[0] = make_rule(RuleKind::kRoofHip);
    const double weight = random.uniform(0.1, 3.0);
    std::vector<HouseRelation> relations;
    relations.push_back(equal_eaves(house, 0, 1, weight));
    relations.push_back(equal_ridges(house, 0, 1, weight));
    relations.push_back(symmetric_hips(house, 0, weight));
    relations.push_back(alike_dormers(house, 0, 1, weight));
    relations.push_back(parameter_priors(
        house, {{house.roof_block(0), 1, 2.0, 0.3}, {0, 0, 0.1, 0.02}, {house.roof_block(0), 2}},
        weight));
    for (HouseRelation& relation : relations) {
      expect_exact(std::move(relation.cost), values_of(house, relation.rules));
    }
  }
}

// A random outline whose samples keep `clear` metres from every place where the distance to the
// components has a kink: equal q_x and q_y (the medial axis and, outside, where the face changes),
// a zero of one while the other is positive (corner regions), equal left and right, and equal
// distance to two components. A move of the parameters by less than that changes no branch.
std::vector<Eigen::Vector2d> smooth_outline(const House& house, double clear, Random* random) {
  const HeightField field(house);
  const auto distance = [](const Block<double>& b, const Eigen::Vector2d& p) {
    return rectangle_distance(b[0], b[1], b[2], b[3], p.x(), p.y());
  };
  for (;;) {
    std::vector<Eigen::Vector2d> outline;
    for (int i = 0; i < 4; ++i) {
      outline.push_back({random->uniform(-12.0, 12.0), random->uniform(-12.0, 12.0)});
    }
    bool smooth = true;
    for (int i = 0; i < 4 && smooth; ++i) {
      // With a spacing longer than any edge, the samples are the edges' middles.
      const Eigen::Vector2d p = field.house_from_local(0.5 * (outline[i] + outline[(i + 1) % 4]));
      std::vector<double> distances;
      for (int c = 0; c < house.num_components(); ++c) {
        const Block<double>& b = field.blocks()[c];
        const double left = b[0] - p.x(), right = p.x() - b[1];
        const double below = b[2] - p.y(), above = p.y() - b[3];
        const double qx = std::max(left, right), qy = std::max(below, above);
        for (double gap : {left - right, below - above, qx - qy, qx, qy}) {
          smooth = smooth && std::abs(gap) > clear;
        }
        distances.push_back(distance(b, p));
      }
      std::sort(distances.begin(), distances.end());
      if (distances.size() > 1) smooth = smooth && distances[1] - distances[0] > clear;
    }
    if (smooth) return outline;
  }
}

TEST(Gradient, OutlineToFootprint) {
  Random random(5);
  for (int i = 0; i < kPoints; ++i) {
    const House house = rich_house(kAllFoundations[i % 6], &random);
    // Steps of 1e-3 (times values up to 20) move edges by 0.02 m, samples by 17 m * 3e-3.
    const auto outline = smooth_outline(house, 0.15, &random);
    std::vector<int> rules = {0};
    for (size_t f = 0; f < house.footprints.size(); ++f) rules.push_back(house.footprint_block(f));
    expect_exact(
        std::make_unique<OutlineToFootprint>(house, outline, OutlineOptions{100.0, 0.3, 2.0}),
        values_of(house, rules));
  }
}

}  // namespace
}  // namespace gable
