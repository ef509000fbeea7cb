#include <gable/engine/solver/unstrained_refinement.h>
#include <gable/grammar/random.h>
#include <gtest/gtest.h>

#include <cmath>

namespace gable {
namespace {

// Vertical planes with points of 0.01 m noise, turned by azimuths in degrees.
class UnstrainedRefinement : public ::testing::Test {
 protected:
  void add(double azimuth) {
    Random random(planes_.size() + 1);
    const double a = azimuth * M_PI / 180.0;
    const Eigen::Vector3d normal(std::cos(a), std::sin(a), 0.0), u(-normal.y(), normal.x(), 0.0);
    const Eigen::Vector3d center(10.0 * planes_.size(), 0.0, 0.0);
    PlaneSupport support;
    support.noise = 0.01;
    PointMoments moments;
    moments.reference = center;
    for (int i = 0; i < 500; ++i) {
      support.members.push_back(static_cast<int>(points_.size()));
      points_.push_back(center + u * random.uniform(-3.0, 3.0) + normal * random.normal(0.01) +
                        Eigen::Vector3d(0.0, 0.0, random.uniform(-3.0, 3.0)));
      moments.add(points_.back());
    }
    supports_.push_back(support);
    moments_.push_back(moments);
    planes_.push_back({normal, normal.dot(center)});
  }

  double turned(size_t plane, const std::vector<OrientedPlane>& now) const {
    return std::asin(now[plane].normal().cross(planes_[plane].normal()).norm()) * 180.0 / M_PI;
  }

  std::vector<OrientedPlane> refine(std::vector<PlaneRegularity>* regularities) const {
    RegularityOptions tolerances;
    tolerances.angle_tolerance = M_PI / 180.0;
    PlaneRefinementOptions options;
    options.loss_scale = 4.0;
    options.regularity_strength = 100.0;
    std::vector<OrientedPlane> planes = planes_;
    refine_unstrained(points_, supports_, planes_, moments_, tolerances, options, regularities,
                      &planes);
    return planes;
  }

  std::vector<Eigen::Vector3d> points_;
  std::vector<PlaneSupport> supports_;
  std::vector<PointMoments> moments_;
  std::vector<OrientedPlane> planes_;
};

TEST_F(UnstrainedRefinement, KeepsWhatThePlanesBear) {
  add(0.0), add(0.8), add(90.3);
  const std::vector<PlaneRegularity> all{{RegularityKind::kParallel, 0, 1},
                                         {RegularityKind::kOrthogonal, 0, 2},
                                         {RegularityKind::kVertical, 1}};
  std::vector<PlaneRegularity> kept = all;
  const auto planes = refine(&kept);
  EXPECT_EQ(kept, all);
  EXPECT_LT(std::abs(planes[0].normal().dot(planes[2].normal())), 1e-4);
}

TEST_F(UnstrainedRefinement, ARegularityThatAPlaneCannotBearIsDropped) {
  add(0.0), add(4.0), add(90.0);
  std::vector<PlaneRegularity> kept{{RegularityKind::kParallel, 0, 1},
                                    {RegularityKind::kVertical, 2}};
  const auto planes = refine(&kept);
  EXPECT_EQ(kept, (std::vector<PlaneRegularity>{{RegularityKind::kVertical, 2}}));
  for (size_t i = 0; i < 3; ++i) EXPECT_LT(turned(i, planes), 0.1);
}

TEST_F(UnstrainedRefinement, SmallMissesThatAddUpBendNoPlaneTooFar) {
  // Each pair is only 0.9 degrees off, the first and the last 8.
  std::vector<PlaneRegularity> kept;
  for (int i = 0; i < 10; ++i) {
    add(0.9 * i + (i % 2 ? 90.0 : 0.0));
    if (i > 0) kept.push_back({RegularityKind::kOrthogonal, i - 1, i});
  }
  const auto planes = refine(&kept);
  EXPECT_LT(kept.size(), 9u);
  for (size_t i = 0; i < 10; ++i) EXPECT_LT(turned(i, planes), 1.1);
}

}  // namespace
}  // namespace gable
