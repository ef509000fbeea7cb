#include <gable/grammar/ring.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace gable {
namespace {

TEST(Ring, TheAreaIsPositiveAnticlockwiseAndNegativeClockwise) {
  Ring ring = {{1.0, 1.0}, {4.0, 1.0}, {4.0, 3.0}, {1.0, 3.0}};
  EXPECT_DOUBLE_EQ(signed_area(ring), 6.0);
  std::reverse(ring.begin(), ring.end());
  EXPECT_DOUBLE_EQ(signed_area(ring), -6.0);
}

TEST(Ring, TheAreaFarFromTheOriginKeepsItsDigits) {
  const Eigen::Vector2d far(4e5, 2e6);
  const Ring ring = {far, far + Eigen::Vector2d(0.25, 0.0), far + Eigen::Vector2d(0.0, 0.5)};
  EXPECT_DOUBLE_EQ(signed_area(ring), 0.0625);
}

TEST(Ring, FewerThanThreePointsHaveNoArea) {
  EXPECT_EQ(signed_area({}), 0.0);
  EXPECT_EQ(signed_area({{0.0, 0.0}, {1.0, 1.0}}), 0.0);
}

TEST(Ring, HoldsThePointsWithinItAndNotThoseInItsNotch) {
  const Ring notched = {{0.0, 0.0}, {4.0, 0.0}, {4.0, 4.0}, {2.0, 1.0}, {0.0, 4.0}};
  EXPECT_TRUE(ring_holds(notched, {2.0, 0.5}));
  EXPECT_TRUE(ring_holds(notched, {3.5, 3.0}));
  EXPECT_FALSE(ring_holds(notched, {2.0, 2.0}));
  EXPECT_FALSE(ring_holds(notched, {5.0, 1.5}));
  EXPECT_FALSE(ring_holds({}, {0.0, 0.0}));
}

TEST(Ring, SeveralRingsHoldWhatAnOddNumberOfThemHolds) {
  const auto square = [](double half) {
    return Ring{{-half, -half}, {half, -half}, {half, half}, {-half, half}};
  };
  const std::vector<Ring> nested = {square(3.0), square(2.0), square(1.0)};
  EXPECT_TRUE(rings_hold(nested, {0.0, 0.0}));
  EXPECT_FALSE(rings_hold(nested, {1.5, 0.0}));
  EXPECT_TRUE(rings_hold(nested, {0.0, 2.5}));
  EXPECT_FALSE(rings_hold(nested, {4.0, 0.0}));
  EXPECT_FALSE(rings_hold({}, {0.0, 0.0}));
}

}  // namespace
}  // namespace gable
