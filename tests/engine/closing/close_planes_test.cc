#include <gable/engine/closing/close_planes.h>
#include <gable/engine/closing/roof_defects.h>
#include <gable/grammar/random.h>
#include <gable/grammar/solid/triangulate.h>
#include <gable/grammar/solid/validity.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "engine/closing/sampled_roof.h"

namespace gable {
namespace {

double volume_of(const ClosedPlanes& closed) {
  double volume = 0.0;
  for (const Solid& solid : closed.solids) {
    const SolidValidity validity = check_solid(solid);
    EXPECT_EQ(validity.describe(), "valid");
    volume += validity.volume;
  }
  return volume;
}

size_t triangles_of(const ClosedPlanes& closed) {
  size_t count = 0;
  for (const Solid& solid : closed.solids) {
    for (const Face& face : solid.faces) count += triangulate(solid, face).size();
  }
  return count;
}

double lower_of(const std::vector<Plane>& planes, const Eigen::Vector2d& p) {
  double z = planes.front().at(p);
  for (const Plane& plane : planes) z = std::min(z, plane.at(p));
  return z;
}

ClosingOptions without_refits() {
  ClosingOptions options;
  options.max_refits = 0;
  return options;
}

TEST(ClosePlanes, GableRoofHasSevenFacesAndItsVolume) {
  const PlanPolygon outline = rectangle(0, 0, 12, 8);
  const std::vector<Plane> planes = {{0, 0.75, 3}, {0, -0.75, 9}};  // ridge at y = 4, z = 6
  const auto samples = sample_roof(
      outline, [&](const auto& p) { return lower_of(planes, p); }, 0.5, 0.0, 1);
  const ClosedPlanes closed = close_planes(outline, planes, samples, 0.0, without_refits());
  ASSERT_EQ(closed.reason, "");
  ASSERT_EQ(closed.solids.size(), 1u);
  EXPECT_EQ(closed.solids[0].faces.size(), 7u);
  EXPECT_EQ(triangles_of(closed), 16u);
  EXPECT_NEAR(volume_of(closed), 12 * 8 * 4.5, 1e-6);
  EXPECT_EQ(closed.origins, (std::vector<int>{0, 1}));
}

TEST(ClosePlanes, HipRoofMeetsAtTheEndsOfItsRidge) {
  const PlanPolygon outline = rectangle(0, 0, 12, 8);
  const std::vector<Plane> planes = {{0, 0.5, 3}, {0, -0.5, 7}, {0.5, 0, 3}, {-0.5, 0, 9}};
  const auto samples = sample_roof(
      outline, [&](const auto& p) { return lower_of(planes, p); }, 0.5, 0.0, 1);
  const ClosedPlanes closed = close_planes(outline, planes, samples, 0.0, without_refits());
  ASSERT_EQ(closed.reason, "");
  ASSERT_EQ(closed.solids.size(), 1u);
  EXPECT_EQ(closed.solids[0].vertices.size(), 10u);
  EXPECT_EQ(closed.solids[0].faces.size(), 9u);
  // A box, a prism under the ridge of length 4, and the two ends of a pyramid of 8 x 8.
  EXPECT_NEAR(volume_of(closed), 12 * 8 * 3 + 4 * 8 * 1.0 + 8 * 8 * 2.0 / 3.0, 1e-6);
}

TEST(ClosePlanes, LShapeHasAValley) {
  const PlanPolygon outline{{{0, 0}, {16, 0}, {16, 8}, {8, 8}, {8, 16}, {0, 16}}, {}};
  // Two wings of one height: ridges along y = 4 and x = 4, a hip to the outer corner and a valley
  // from the inner one.
  const std::vector<Plane> planes = {{0, 0.5, 3}, {0, -0.5, 7}, {0.5, 0, 3}, {-0.5, 0, 7}};
  const auto height = [&](const Eigen::Vector2d& p) {
    const double outer = std::min(planes[0].at(p), planes[2].at(p));
    const double inner = std::max(planes[1].at(p), planes[3].at(p));
    return std::min(outer, inner);
  };
  const auto samples = sample_roof(outline, height, 0.5, 0.0, 1);
  const ClosedPlanes closed = close_planes(outline, planes, samples, 0.0, without_refits());
  ASSERT_EQ(closed.reason, "");
  double truth = 0.0;
  for (const HeightSample& s : sample_roof(outline, height, 0.05, 0.0, 1)) {
    truth += s.weight * s.point.z();
  }
  EXPECT_NEAR(volume_of(closed), truth, 0.002 * truth);
  EXPECT_EQ(closed.roof.regions.size(), 4u);
  EXPECT_LE(triangles_of(closed), 30u);
}

TEST(ClosePlanes, FlatRoofsStepWhereTheHeightsDo) {
  const PlanPolygon outline = rectangle(0, 0, 12, 8);
  const std::vector<Plane> planes = {{0, 0, 3}, {0, 0, 6}};
  const auto samples = sample_roof(
      outline, [](const auto& p) { return p.x() < 5 ? 3.0 : 6.0; }, 0.5, 0.0, 1);
  const ClosedPlanes closed = close_planes(outline, planes, samples, 0.0, without_refits());
  ASSERT_EQ(closed.reason, "");
  ASSERT_EQ(closed.solids.size(), 1u);
  EXPECT_EQ(closed.solids[0].faces.size(), 8u);
  EXPECT_NEAR(volume_of(closed), 8 * (5 * 3 + 7 * 6), 1e-6);
}

TEST(ClosePlanes, CourtyardStaysOpen) {
  PlanPolygon outline = rectangle(0, 0, 14, 14);
  outline.holes.push_back({{4, 4}, {10, 4}, {10, 10}, {4, 10}});
  const std::vector<Plane> planes = {{0, 0, 5}};
  const auto samples = sample_roof(
      outline, [](const auto&) { return 5.0; }, 0.5, 0.02, 1);
  const ClosedPlanes closed = close_planes(outline, planes, samples, -1.0, without_refits());
  ASSERT_EQ(closed.reason, "");
  EXPECT_EQ(closed.solids[0].faces.size(), 10u);
  EXPECT_NEAR(volume_of(closed), (14 * 14 - 6 * 6) * 6.0, 1e-6);
}

TEST(ClosePlanes, RefitsFindTheRoofBehindTheNoiseAndNeverRaiseTheCost) {
  const PlanPolygon outline = rectangle(0, 0, 12, 8);
  const std::vector<Plane> truth = {{0, 0.75, 3}, {0, -0.75, 9}};
  const auto samples = sample_roof(
      outline, [&](const auto& p) { return lower_of(truth, p); }, 0.5, 0.1, 7);
  const std::vector<Plane> start = {{0.02, 0.65, 3.5}, {-0.03, -0.7, 8.9}};
  ClosingOptions options;
  options.regularities.angle_tolerance = 0.05;
  const ClosedPlanes closed = close_planes(outline, start, samples, 0.0, options);
  ASSERT_EQ(closed.reason, "");
  ASSERT_GE(closed.costs.size(), 2u);
  for (size_t i = 1; i < closed.costs.size(); ++i) {
    EXPECT_LT(closed.costs[i], closed.costs[i - 1]);
  }
  EXPECT_NEAR(volume_of(closed), 12 * 8 * 4.5, 3.0);
  EXPECT_EQ(closed.solids[0].faces.size(), 7u);
}

TEST(ClosePlanes, PlaneThatExplainsLittleIsLeftOut) {
  const PlanPolygon outline = rectangle(0, 0, 12, 8);
  const std::vector<Plane> planes = {{0, 0, 5}, {0, 0, 5.4}};
  const auto samples = sample_roof(
      outline, [](const auto& p) { return p.x() < 2 && p.y() < 2 ? 5.4 : 5.0; }, 0.5, 0.0, 1);
  const ClosedPlanes closed = close_planes(outline, planes, samples, 0.0, without_refits());
  EXPECT_EQ(closed.origins, std::vector<int>{0});
  EXPECT_EQ(closed.solids[0].faces.size(), 6u);
}

TEST(ClosePlanes, LevelRoofStandsInWherePlanesComeDownToTheBase) {
  const PlanPolygon outline = rectangle(0, 0, 10, 10);
  const std::vector<Plane> planes = {{2.0, 0, -5}};
  const auto samples = sample_roof(
      outline, [](const auto&) { return 4.0; }, 0.5, 0.0, 1);
  const ClosedPlanes closed = close_planes(outline, planes, samples, 0.0, {});
  EXPECT_EQ(closed.origins, std::vector<int>{-1});
  EXPECT_NEAR(volume_of(closed), 400.0, 1e-6);
}

TEST(ClosePlanes, StepsFollowTheTracesOfWalls) {
  // The step at x = 5 is blurred; the wall that was seen says where it is.
  const PlanPolygon outline = rectangle(0, 0, 12, 8);
  const std::vector<Plane> planes = {{0, 0, 3}, {0, 0, 6}};
  const auto samples = sample_roof(
      outline, [](const auto& p) { return p.x() < 5 + 0.3 * std::sin(4 * p.y()) ? 3.0 : 6.0; }, 0.5,
      0.0, 1);
  ClosingEvidence evidence;
  PlanLine wall{Eigen::Vector2d::UnitX(), 5.1};
  wall.begin = 2.0;
  wall.end = 6.0;
  evidence.traces.push_back(wall);
  const ClosedPlanes closed =
      close_planes(outline, planes, samples, 0.0, without_refits(), evidence);
  ASSERT_EQ(closed.reason, "");
  EXPECT_EQ(closed.solids[0].faces.size(), 8u);
  EXPECT_NEAR(volume_of(closed), 8 * (5.1 * 3 + 6.9 * 6), 1e-6);
}

TEST(ClosePlanes, PlanesStayWhereTheyWereSeen) {
  // The second plane would fit both ends, but reaches only one.
  const PlanPolygon outline = rectangle(0, 0, 12, 4);
  const std::vector<Plane> planes = {{0, 0, 3}, {0, 0, 6}, {0, 0, 6.1}};
  const auto samples = sample_roof(
      outline, [](const auto& p) { return p.x() > 3 && p.x() < 10 ? 3.0 : 6.0; }, 0.5, 0.0, 1);
  ClosingEvidence evidence;
  const Eigen::Vector3d far = Eigen::Vector3d::Constant(100.0);
  evidence.reaches = {{-far, far},
                      {Eigen::Vector3d(-1, -1, 0), Eigen::Vector3d(3.2, 5, 9)},
                      {Eigen::Vector3d(9.8, -1, 0), Eigen::Vector3d(13, 5, 9)}};
  const ClosedPlanes closed =
      close_planes(outline, planes, samples, 0.0, without_refits(), evidence);
  ASSERT_EQ(closed.reason, "");
  EXPECT_EQ(closed.origins, (std::vector<int>{0, 1, 2}));
  EXPECT_NEAR(volume_of(closed), 4 * (3 * 6 + 7 * 3 + 2 * 6.1), 1e-6);
}

TEST(ClosePlanes, CornersThatCrowdAreLoosened) {
  // Three steps, of which two would meet the third 1 mm apart.
  const PlanPolygon outline = rectangle(0, 0, 12, 8);
  const std::vector<Plane> planes = {{0, 0, 3}, {0, 0, 5}, {0, 0, 7}, {0, 0, 9}};
  const auto samples = sample_roof(
      outline,
      [](const auto& p) { return p.x() < 6 ? (p.y() < 4 ? 3.0 : 5.0) : (p.y() < 4 ? 7.0 : 9.0); },
      0.5, 0.0, 1);
  const auto trace = [](const Eigen::Vector2d& normal, double offset, double begin, double end) {
    PlanLine line{normal, offset};
    line.begin = begin;
    line.end = end;
    return line;
  };
  ClosingEvidence evidence;
  evidence.traces = {trace(Eigen::Vector2d::UnitX(), 6.0, 0, 8),
                     trace(Eigen::Vector2d::UnitY(), 4.0, -5.5, -0.5),
                     trace(Eigen::Vector2d::UnitY(), 4.001, -11.5, -6.5)};
  const ClosedPlanes closed =
      close_planes(outline, planes, samples, 0.0, without_refits(), evidence);
  ASSERT_EQ(closed.reason, "");
  EXPECT_NEAR(volume_of(closed), 24 * (3 + 5 + 7 + 9), 2.0);
  EXPECT_TRUE(find_roof_defects(closed.roof, 0.003).crowded.empty());
}

TEST(ClosePlanes, RandomPlanesOverRandomOutlinesCloseWatertight) {
  for (uint64_t seed = 0; seed < 40; ++seed) {
    Random random(seed);
    PlanPolygon outline;
    const int corners = random.integer(3, 14);
    for (int i = 0; i < corners; ++i) {
      const double angle = 2 * M_PI * i / corners, radius = random.uniform(4, 10);
      outline.outer.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
    if (seed % 4 == 0) outline.holes.push_back({{-1, -1}, {1, -1.5}, {1.5, 1}, {-0.5, 1}});
    std::vector<Plane> planes;
    for (int i = random.integer(1, 7); i > 0; --i) {
      planes.push_back(
          {random.uniform(-0.6, 0.6), random.uniform(-0.6, 0.6), random.uniform(6, 10)});
    }
    const auto height = [&](const Eigen::Vector2d& p) {
      return lower_of(planes, p) + (p.x() > 2 && seed % 3 == 0 ? 2.5 : 0.0);
    };
    const auto samples = sample_roof(outline, height, 0.7, 0.05, seed);
    const ClosedPlanes closed = close_planes(outline, planes, samples, -1.0, {});
    ASSERT_EQ(closed.reason, "") << "seed " << seed;
    double area = 0.0;
    for (const RoofRegion& region : closed.roof.regions) {
      area += signed_area(region.polygon.outer);
      for (const Ring& hole : region.polygon.holes) area += signed_area(hole);
    }
    double whole = signed_area(outline.outer);
    for (const Ring& hole : outline.holes) whole -= std::abs(signed_area(hole));
    EXPECT_NEAR(area, whole, 0.02 * whole) << "seed " << seed;
    EXPECT_GT(volume_of(closed), whole) << "seed " << seed;
  }
}

TEST(ClosePlanes, SameInputGivesTheSameRoof) {
  const PlanPolygon outline = rectangle(0, 0, 12, 8);
  const std::vector<Plane> planes = {{0, 0.7, 3}, {0.01, -0.72, 9}, {0.3, 0, 4}};
  const auto samples = sample_roof(
      outline, [&](const auto& p) { return lower_of(planes, p); }, 0.5, 0.1, 3);
  const ClosedPlanes one = close_planes(outline, planes, samples, 0.0, {});
  const ClosedPlanes two = close_planes(outline, planes, samples, 0.0, {});
  EXPECT_EQ(one.costs, two.costs);
  ASSERT_EQ(one.solids.size(), two.solids.size());
  for (size_t i = 0; i < one.solids.size(); ++i) {
    EXPECT_EQ(one.solids[i].vertices, two.solids[i].vertices);
  }
}

TEST(ClosePlanes, WhatCannotBeClosedSaysWhy) {
  const PlanPolygon outline = rectangle(0, 0, 12, 8);
  const auto samples = sample_roof(
      outline, [](const auto&) { return 5.0; }, 1.0, 0.0, 1);
  EXPECT_EQ(close_planes(outline, {}, {}, 0.0, {}).reason, "no heights inside the outline");
  EXPECT_EQ(close_planes({}, {}, samples, 0.0, {}).reason, "no heights inside the outline");
  // Without planes the roof is level.
  EXPECT_NEAR(volume_of(close_planes(outline, {}, samples, 0.0, {})), 480.0, 1e-6);
  const std::vector<Plane> broken = {{NAN, 0, 0}};
  EXPECT_NEAR(volume_of(close_planes(outline, broken, samples, 0.0, {})), 480.0, 1e-6);
}

TEST(ClosingOptions, BoundsAreNamed) {
  EXPECT_EQ(check(ClosingOptions{}), "");
  ClosingOptions options;
  options.clearance = 0.0;
  EXPECT_EQ(check(options), "clearance must lie in [0.01, 100] m");
}

}  // namespace
}  // namespace gable
