#include <gable/engine/scales/report/regularity_angles.h>
#include <gtest/gtest.h>

#include <cmath>

namespace gable {
namespace {

/// A plane whose normal is tilted from straight up to +x.
OrientedPlane tilted(double degrees) {
  const double angle = degrees * M_PI / 180.0;
  return {{std::sin(angle), 0.0, std::cos(angle)}, 1.0};
}

TEST(RegularityAngles, AreTheMeanMissesOfTheTiedPlanes) {
  PlaneRefit refit;
  refit.before = {tilted(0), tilted(2), tilted(91), tilted(-4), tilted(87), tilted(33)};
  refit.after = {tilted(0), tilted(0.5), tilted(90), tilted(0), tilted(90), tilted(30)};
  refit.regularities = {{RegularityKind::kParallel, 0, 1},     // 2, 0.5
                        {RegularityKind::kOrthogonal, 0, 2},   // 1, 0
                        {RegularityKind::kHorizontal, 3, -1},  // 4, 0
                        {RegularityKind::kVertical, 4, -1},    // 3, 0
                        {RegularityKind::kEqualSlope, 1, 5}};  // counts for nothing
  const RegularityAngles angles = regularity_angles(refit);
  EXPECT_NEAR(angles.before, (2 + 1 + 4 + 3) / 4.0, 1e-9);
  EXPECT_NEAR(angles.after, 0.5 / 4.0, 1e-9);
}

TEST(RegularityAngles, AreUnknownWhereNothingIsTied) {
  EXPECT_TRUE(std::isnan(regularity_angles({}).before));
}

}  // namespace
}  // namespace gable
