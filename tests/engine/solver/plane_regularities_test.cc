#include <gable/engine/solver/plane_regularities.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace gable {
namespace {

// A plane through `point` with moments of three points around it.
void add(const Eigen::Vector3d& direction, const Eigen::Vector3d& point,
         std::vector<OrientedPlane>* planes, std::vector<PointMoments>* moments) {
  const Eigen::Vector3d normal = direction.normalized();
  planes->push_back({normal, normal.dot(point)});
  const Eigen::Vector3d u = normal.unitOrthogonal(), v = normal.cross(u);
  const Eigen::Vector3d points[] = {point + u, point + v, point - u - v};
  moments->push_back(moments_of(points));
}

int count(const std::vector<PlaneRegularity>& all, RegularityKind kind) {
  return static_cast<int>(std::count_if(all.begin(), all.end(),
                                        [&](const PlaneRegularity& r) { return r.kind == kind; }));
}

class PlaneRegularities : public ::testing::Test {
 protected:
  std::vector<PlaneRegularity> detect(const std::vector<std::pair<int, int>>& pairs = {}) const {
    return detect_regularities(planes_, moments_, pairs, {});
  }
  std::vector<OrientedPlane> planes_;
  std::vector<PointMoments> moments_;
};

TEST_F(PlaneRegularities, OfParallelPlanesJustEnoughPairsToConnectThem) {
  for (int i = 0; i < 5; ++i) {
    add({1.0, 2.0 + 0.001 * i, 2.0}, {0.0, 0.0, 2.0 * i}, &planes_, &moments_);
  }
  const auto found = detect();
  EXPECT_EQ(found.size(), 4u);
  EXPECT_EQ(count(found, RegularityKind::kParallel), 4);
}

TEST_F(PlaneRegularities, OppositeNormalsAreParallel) {
  add({1.0, 2.0, 2.0}, {0.0, 0.0, 0.0}, &planes_, &moments_);
  add({-1.0, -2.0, -2.0}, {0.0, 0.0, 3.0}, &planes_, &moments_);
  EXPECT_EQ(detect(), (std::vector<PlaneRegularity>{{RegularityKind::kParallel, 0, 1}}));
}

TEST_F(PlaneRegularities, CoplanarPlanesAreNotCalledParallelAsWell) {
  add({1.0, 2.0, 2.0}, {0.0, 0.0, 0.0}, &planes_, &moments_);
  add({1.0, 2.0, 2.0}, {8.0, -3.0, -0.95}, &planes_, &moments_);  // 0.03 m apart
  EXPECT_EQ(detect(), (std::vector<PlaneRegularity>{{RegularityKind::kCoplanar, 0, 1}}));
}

TEST_F(PlaneRegularities, GroupsAreRelatedAsOrthogonalOnce) {
  add({1.0, 2.0, 2.0}, {0.0, 0.0, 0.0}, &planes_, &moments_);
  add({1.0, 2.0, 2.0}, {0.0, 0.0, 5.0}, &planes_, &moments_);
  add({2.0, 1.0, -2.0}, {0.0, 0.0, 0.0}, &planes_, &moments_);
  add({2.0, 1.0, -2.0}, {0.0, 0.0, 5.0}, &planes_, &moments_);
  const auto found = detect();
  EXPECT_EQ(count(found, RegularityKind::kParallel), 2);
  EXPECT_EQ(count(found, RegularityKind::kOrthogonal), 1);
}

TEST_F(PlaneRegularities, HorizontalAndVerticalPlanesNeedNoPairs) {
  add({0.0, 0.01, 1.0}, {0.0, 0.0, 0.0}, &planes_, &moments_);
  add({0.01, 0.0, -1.0}, {0.0, 0.0, 5.0}, &planes_, &moments_);
  add({1.0, 0.7, 0.02}, {0.0, 0.0, 0.0}, &planes_, &moments_);
  EXPECT_EQ(detect(), (std::vector<PlaneRegularity>{{RegularityKind::kHorizontal, 0},
                                                    {RegularityKind::kHorizontal, 1},
                                                    {RegularityKind::kVertical, 2}}));
}

TEST_F(PlaneRegularities, NamesTheViolatedBound) {
  RegularityOptions options;
  EXPECT_EQ(check(options), "");
  options.deviations = 0.5;
  EXPECT_EQ(check(options), "deviations must lie in [1, 10]");
}

TEST_F(PlaneRegularities, NothingOutsideTheToleranceOrThePairsGiven) {
  add({1.0, 2.0, 2.0}, {0.0, 0.0, 0.0}, &planes_, &moments_);
  add({1.0, 2.0, 2.4}, {0.0, 0.0, 5.0}, &planes_, &moments_);
  add({1.0, 2.0, 2.0}, {0.0, 0.0, 9.0}, &planes_, &moments_);
  EXPECT_TRUE(detect({{0, 1}, {1, 2}}).empty());
  EXPECT_EQ(detect().size(), 1u);
}

// The same with a grid of points that alternate about the plane by `noise`.
void add_noisy(const Eigen::Vector3d& direction, const Eigen::Vector3d& point, double size,
               double noise, std::vector<OrientedPlane>* planes,
               std::vector<PointMoments>* moments) {
  add(direction, point, planes, moments);
  const Eigen::Vector3d normal = planes->back().normal();
  const Eigen::Vector3d u = normal.unitOrthogonal(), v = normal.cross(u);
  PointMoments all;
  all.reference = point;
  for (int i = -3; i <= 3; ++i) {
    for (int k = -3; k <= 3; ++k) {
      const double off = (i + k) % 2 ? -noise : noise;
      all.add(point + size / 3 * (i * u + k * v) + off * normal);
    }
  }
  moments->back() = all;
}

TEST_F(PlaneRegularities, SmallNoisyPlanesSnapAndPreciseOnesThatDifferDoNot) {
  // Both are 5 degrees off vertical; of the second the points leave 4 degrees open.
  const Eigen::Vector3d leaning(1.0, 0.3, 0.0913);
  add_noisy(leaning, {0.0, 0.0, 0.0}, 3.0, 0.01, &planes_, &moments_);
  EXPECT_TRUE(detect().empty());
  planes_.clear(), moments_.clear();
  add_noisy(leaning, {0.0, 0.0, 0.0}, 0.4, 0.1, &planes_, &moments_);
  EXPECT_EQ(detect(), (std::vector<PlaneRegularity>{{RegularityKind::kVertical, 0}}));
}

TEST_F(PlaneRegularities, APlaneThatCouldBeTurnedAnywhereIsNothingInParticular) {
  add_noisy({1.0, 0.3, 0.0}, {0.0, 0.0, 0.0}, 0.1, 0.3, &planes_, &moments_);
  EXPECT_TRUE(detect().empty());
}

TEST_F(PlaneRegularities, AnUncertainPlaneDoesNotMakeCertainOnesParallel) {
  add({1.0, 2.0, 2.0}, {0.0, 0.0, 0.0}, &planes_, &moments_);
  add({1.0, 2.0, 2.4}, {0.0, 0.0, 9.0}, &planes_, &moments_);  // 5 degrees apart
  add_noisy({1.0, 2.0, 2.2}, {0.0, 0.0, 5.0}, 0.4, 0.1, &planes_, &moments_);
  const auto found = detect();
  ASSERT_EQ(count(found, RegularityKind::kParallel), 1);
  const auto pair = std::find_if(found.begin(), found.end(), [](const PlaneRegularity& r) {
    return r.kind == RegularityKind::kParallel;
  });
  EXPECT_EQ(pair->b, 2);
}

TEST_F(PlaneRegularities, TheSidesOfAHipAreOfEqualSlopeOnce) {
  for (const auto& [x, y] : {std::pair(3.0, 1.0), {-3.0, -1.0}, {-1.0, 3.0}, {1.0, -3.0}}) {
    add({x, y, 2.0}, {4 * x, 4 * y, 0.0}, &planes_, &moments_);
  }
  add({0.0, 0.0, 1.0}, {0.0, 0.0, 9.0}, &planes_, &moments_);
  EXPECT_EQ(count(detect(), RegularityKind::kEqualSlope), 3);
  planes_[3] = {Eigen::Vector3d(1.0, -3.0, 4.0).normalized(), 0.0};
  EXPECT_EQ(count(detect(), RegularityKind::kEqualSlope), 2);
}

}  // namespace
}  // namespace gable
