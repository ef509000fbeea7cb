#include <gable/engine/solver/plane_refinement.h>
#include <gable/grammar/random.h>
#include <gable/residuals/robust_loss.h>
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

namespace gable {
namespace {

struct Scan {
  std::vector<Eigen::Vector3d> points;
  std::vector<std::vector<int>> members;
  std::vector<OrientedPlane> truth;
};

OrientedPlane plane_through(const Eigen::Vector3d& normal, const Eigen::Vector3d& point) {
  return {normal.normalized(), normal.normalized().dot(point)};
}

void sample(const OrientedPlane& plane, const Eigen::Vector3d& center, int count, double noise,
            double outliers, Random* random, Scan* scan) {
  const Eigen::Vector3d n = plane.normal();
  const Eigen::Vector3d u = n.unitOrthogonal(), v = n.cross(u);
  scan->truth.push_back(plane);
  scan->members.emplace_back();
  for (int i = 0; i < count; ++i) {
    double off = random->normal(noise);
    if (random->chance(outliers)) off += random->uniform(0.2, 1.0);
    const Eigen::Vector3d c = center - n * plane.signed_distance(center);
    scan->members.back().push_back(static_cast<int>(scan->points.size()));
    scan->points.push_back(c + u * random->uniform(-3.0, 3.0) + v * random->uniform(-2.0, 2.0) +
                           n * off);
  }
}

double angle(const OrientedPlane& a, const OrientedPlane& b) {
  return std::asin(std::min(1.0, a.normal().cross(b.normal()).norm()));
}

// Two roof planes, a wall and a garage roof, in national coordinates, with one-sided outliers.
Scan house_scan(double outliers) {
  Random random(5);
  Scan scan;
  const Eigen::Vector3d at(85000.0, 446000.0, 8.0);
  sample(plane_through({0.0, 0.6, 0.8}, at), at, 400, 0.02, outliers, &random, &scan);
  sample(plane_through({0.0, -0.6, 0.8}, at), at, 300, 0.02, outliers, &random, &scan);
  sample(plane_through({1.0, 0.0, 0.0}, at), at, 200, 0.02, outliers, &random, &scan);
  sample(plane_through({0.0, 0.0, 1.0}, at), at, 100, 0.02, outliers, &random, &scan);
  return scan;
}

std::vector<OrientedPlane> perturbed(const Scan& scan, uint64_t seed) {
  Random random(seed);
  std::vector<OrientedPlane> planes;
  for (size_t i = 0; i < scan.truth.size(); ++i) {
    const Eigen::Vector3d turn(random.normal(0.05), random.normal(0.05), random.normal(0.05));
    const Eigen::Vector3d through =
        scan.points[scan.members[i][0]] + Eigen::Vector3d(0.0, 0.0, random.uniform(-0.2, 0.2));
    planes.push_back(plane_through(scan.truth[i].normal() + turn, through));
  }
  return planes;
}

std::vector<PointMoments> all_moments(const Scan& scan) {
  std::vector<PointMoments> all;
  for (const auto& members : scan.members) {
    PointMoments moments;
    moments.reference = scan.points[members[0]];
    for (int m : members) moments.add(scan.points[m]);
    all.push_back(moments);
  }
  return all;
}

TEST(PlaneRefinement, WithoutRobustnessGivesTheSmallestEigenvectorOfEachScatter) {
  const Scan scan = house_scan(0.0);
  std::vector<OrientedPlane> planes = perturbed(scan, 1);
  PlaneRefinementOptions options;
  options.loss_scale = 100.0;  // far above every distance: squares
  options.cost_tolerance = 0.0;
  const PlaneRefinementSummary summary =
      refine_planes(scan.points, scan.members, {}, options, &planes);
  EXPECT_NE(summary.termination, Termination::kFailed);
  const auto moments = all_moments(scan);
  for (size_t i = 0; i < planes.size(); ++i) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(moments[i].scatter());
    const Eigen::Vector3d normal = eigen.eigenvectors().col(0);
    EXPECT_LT(planes[i].normal().cross(normal).norm(), 1e-6);
    EXPECT_NEAR(planes[i].signed_distance(moments[i].centroid()), 0.0, 1e-6);
    EXPECT_NEAR(planes[i].normal().norm(), 1.0, 1e-12);
  }
}

TEST(PlaneRefinement, EndsWhereNoMoveLowersTheRobustCostOfThePoints) {
  const Scan scan = house_scan(0.1);
  std::vector<OrientedPlane> planes = perturbed(scan, 2);
  PlaneRefinementOptions options;
  options.cost_tolerance = 1e-12;
  options.max_reweightings = 200;
  const PlaneRefinementSummary summary =
      refine_planes(scan.points, scan.members, {}, options, &planes);
  EXPECT_EQ(summary.termination, Termination::kConverged);
  EXPECT_LT(summary.final_cost, summary.initial_cost);
  const RobustLoss loss(LossKind::kSoftL1, options.loss_scale);
  const auto cost = [&](size_t i, const OrientedPlane& plane) {
    double sum = 0.0;
    for (int m : scan.members[i]) sum += 0.5 * loss.cost(plane.signed_distance(scan.points[m]));
    return sum;
  };
  double total = 0.0;
  for (size_t i = 0; i < planes.size(); ++i) {
    const double best = cost(i, planes[i]);
    total += best;
    const auto moments = all_moments(scan)[i];
    for (int k = 0; k < 6; ++k) {
      const double delta = k % 2 ? 1e-3 : -1e-3;
      // Turned about the centroid, or shifted.
      Eigen::Vector3d normal = planes[i].normal();
      const Eigen::Vector3d u = normal.unitOrthogonal();
      const Eigen::Vector3d c =
          moments.centroid() - normal * planes[i].signed_distance(moments.centroid());
      if (k / 2 == 0) normal += delta * u;
      if (k / 2 == 1) normal += delta * normal.cross(u);
      const Eigen::Vector3d shift =
          k / 2 == 2 ? Eigen::Vector3d(delta * normal) : Eigen::Vector3d::Zero();
      EXPECT_GT(cost(i, plane_through(normal, c + shift)), best);
    }
  }
  EXPECT_NEAR(summary.final_cost, total, 1e-9 * total);
}

TEST(PlaneRefinement, OutliersOnOneSideMoveThePlanesLessThanLeastSquares) {
  const Scan scan = house_scan(0.1);
  std::vector<OrientedPlane> robust = perturbed(scan, 3), square = robust;
  PlaneRefinementOptions options;
  refine_planes(scan.points, scan.members, {}, options, &robust);
  options.loss_scale = 100.0;
  refine_planes(scan.points, scan.members, {}, options, &square);
  const auto moments = all_moments(scan);
  for (size_t i = 0; i < robust.size(); ++i) {
    const Eigen::Vector3d c = moments[i].centroid();
    const double robust_error =
        std::abs(robust[i].signed_distance(c) - scan.truth[i].signed_distance(c));
    const double square_error =
        std::abs(square[i].signed_distance(c) - scan.truth[i].signed_distance(c));
    EXPECT_LT(robust_error, 0.5 * square_error);
    EXPECT_LT(angle(robust[i], scan.truth[i]), 0.01);
  }
}

TEST(PlaneRefinement, RegularitiesHoldAfterwardsAndTheFitStays) {
  const Scan scan = house_scan(0.05);
  std::vector<OrientedPlane> free = perturbed(scan, 4);
  refine_planes(scan.points, scan.members, {}, {}, &free);
  const auto regularities = detect_regularities(free, all_moments(scan), {}, {});
  ASSERT_FALSE(regularities.empty());
  std::vector<OrientedPlane> regular = free;
  PlaneRefinementOptions options;
  options.regularity_strength = 100.0;
  const auto summary = refine_planes(scan.points, scan.members, regularities, options, &regular);
  EXPECT_EQ(summary.termination, Termination::kConverged);
  // Wall vertical, garage flat: at least ten times closer than before.
  EXPECT_LT(std::abs(regular[2].normal().z()), 0.1 * std::abs(free[2].normal().z()));
  EXPECT_LT(regular[3].normal().head<2>().norm(), 0.1 * free[3].normal().head<2>().norm());
  for (size_t i = 0; i < free.size(); ++i) EXPECT_LT(angle(regular[i], free[i]), 0.02);
}

TEST(PlaneRefinement, CoplanarPlanesFarFromTheOriginMeetBetweenTheirPoints) {
  Random random(6);
  Scan scan;
  const Eigen::Vector3d at(85000.0, 446000.0, 8.0), normal(0.0, 0.6, 0.8), beside(9.0, 0.0, 0.0);
  sample(plane_through(normal, at), at, 200, 0.01, 0.0, &random, &scan);
  sample(plane_through(normal, at + 0.06 * normal), at + beside, 200, 0.01, 0.0, &random, &scan);
  std::vector<OrientedPlane> planes = scan.truth;
  const auto moments = all_moments(scan);
  const auto regularities = detect_regularities(planes, moments, {}, {});
  ASSERT_EQ(regularities, (std::vector<PlaneRegularity>{{RegularityKind::kCoplanar, 0, 1}}));
  PlaneRefinementOptions options;
  options.regularity_strength = 100.0;
  refine_planes(scan.points, scan.members, regularities, options, &planes);
  EXPECT_LT(angle(planes[0], planes[1]), 1e-3);
  EXPECT_LT(std::abs(planes[0].signed_distance(moments[1].centroid())), 5e-3);
  EXPECT_LT(std::abs(planes[1].signed_distance(moments[0].centroid())), 5e-3);
}

TEST(PlaneRefinement, AWeightOfTwoIsThePointTwice) {
  const Scan scan = house_scan(0.1);
  std::vector<PlaneSupport> twice, weighted;
  for (const std::vector<int>& members : scan.members) {
    PlaneSupport a{members, {}, 0.5}, b{members, {}, 0.5};
    for (size_t k = 0; k < members.size(); ++k) {
      if (k % 3 == 0) a.members.push_back(members[k]);
      b.weights.push_back(k % 3 == 0 ? 2.0 : 1.0);
    }
    twice.push_back(a);
    weighted.push_back(b);
  }
  const std::vector<PlaneRegularity> regularities{{RegularityKind::kVertical, 2},
                                                  {RegularityKind::kEqualSlope, 0, 1}};
  for (const LossKind loss : {LossKind::kSoftL1, LossKind::kGemanMcClure}) {
    PlaneRefinementOptions options;
    options.loss = loss;
    std::vector<OrientedPlane> a = perturbed(scan, 7), b = a;
    const auto summary_a = refine_planes(scan.points, twice, regularities, options, &a);
    const auto summary_b = refine_planes(scan.points, weighted, regularities, options, &b);
    EXPECT_NEAR(summary_a.final_cost, summary_b.final_cost, 1e-6 * summary_a.final_cost);
    EXPECT_NEAR(summary_a.rmse, summary_b.rmse, 1e-6);
    for (size_t i = 0; i < a.size(); ++i) EXPECT_LT(angle(a[i], b[i]), 1e-6);
  }
}

TEST(PlaneRefinement, TheCostNeverRisesUnderAnyLoss) {
  const Scan scan = house_scan(0.2);
  std::vector<PlaneSupport> supports;
  for (const std::vector<int>& members : scan.members) supports.push_back({members, {}, 0.02});
  PlaneRefinementOptions options;
  options.loss = LossKind::kGemanMcClure;
  options.loss_scale = 3.0;
  options.max_reweightings = 1;
  options.cost_tolerance = 0.0;
  std::vector<OrientedPlane> planes = perturbed(scan, 8);
  double cost = 1e300;
  for (int pass = 0; pass < 15; ++pass) {
    const auto summary = refine_planes(scan.points, supports, {}, options, &planes);
    EXPECT_LE(summary.initial_cost, cost * (1.0 + 1e-9));
    EXPECT_LE(summary.final_cost, summary.initial_cost * (1.0 + 1e-9));
    cost = summary.final_cost;
  }
}

TEST(PlaneRefinement, WhereTiedPlanesMeetDependsOnTheirNoise) {
  Random random(9);
  Scan scan;
  const Eigen::Vector3d level(0.0, 0.0, 1.0), tilted(0.0, 0.05, 1.0);
  sample(plane_through(level, {0, 0, 0}), {0, 0, 0}, 300, 0.01, 0.0, &random, &scan);
  sample(plane_through(tilted, {9, 0, 3}), {9, 0, 3}, 300, 0.10, 0.0, &random, &scan);
  std::vector<PlaneSupport> supports{{scan.members[0], {}, 0.01}, {scan.members[1], {}, 0.10}};
  std::vector<OrientedPlane> planes = scan.truth;
  PlaneRefinementOptions options;
  options.loss_scale = 10.0;
  options.regularity_strength = 1000.0;
  refine_planes(scan.points, supports, {{RegularityKind::kParallel, 0, 1}}, options, &planes);
  EXPECT_LT(angle(planes[0], planes[1]), 1e-4);
  // A hundred times the information keeps the first where it was.
  EXPECT_LT(angle(planes[0], scan.truth[0]), 0.003);
}

TEST(PlaneRefinement, NamesTheViolatedBound) {
  PlaneRefinementOptions options;
  EXPECT_EQ(check(options), "");
  options.loss_scale = 0.0;
  EXPECT_EQ(check(options), "loss_scale must lie in (0, 100]");
  options = {};
  options.regularity_strength = -1.0;
  EXPECT_EQ(check(options), "regularity_strength must lie in [0, 1e4]");
}

}  // namespace
}  // namespace gable
