#include <gable/engine/closing/plan_lines.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "engine/closing/sampled_roof.h"

namespace gable {
namespace {

std::vector<PlanLine> lines_of(const PlanPolygon& outline, const std::vector<Plane>& planes,
                               const std::vector<HeightSample>& samples, double snap = 0.3) {
  ClosingOptions options;
  options.snap_distance = snap;
  const SampleGrid grid = make_sample_grid(samples, options.max_grid);
  const std::vector<int> labels = label_grid(grid, samples, planes, {}, options, {});
  return find_plan_lines(grid, labels, planes, outline, {}, options);
}

TEST(PlanLines, PlanesMeetAlongTheirCrease) {
  const std::vector<Plane> planes = {{0.5, 0.2, 3}, {-0.3, 0.1, 5}};
  const auto crease = crease_of(planes, 0, 1);
  ASSERT_TRUE(crease);
  const Eigen::Vector2d along(-crease->normal.y(), crease->normal.x());
  for (const double t : {-3.0, 0.0, 8.0}) {
    const Eigen::Vector2d p = crease->offset * crease->normal + t * along;
    EXPECT_NEAR(planes[0].at(p), planes[1].at(p), 1e-12);
  }
  EXPECT_FALSE(crease_of({{0.5, 0.2, 3}, {0.5, 0.21, 8}}, 0, 1));
}

TEST(PlanLines, NeighboursGetTheirCreaseAndNothingElse) {
  const PlanPolygon outline = rectangle(0, 0, 12, 8);
  const std::vector<Plane> planes = {{0, 0.75, 3}, {0, -0.75, 9}};
  const auto lines = lines_of(
      outline, planes,
      sample_roof(
          outline, [&](const auto& p) { return std::min(planes[0].at(p), planes[1].at(p)); }, 0.5,
          0.05, 1));
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_TRUE(lines[0].is_crease());
  EXPECT_NEAR(lines[0].signed_distance({3.0, 4.0}), 0.0, 1e-12);
}

TEST(PlanLines, StepsRunAlongTheOutlineWhereTheyNearlyDo) {
  // Turned by 20 degrees; the step is parallel to the short edges, 5 m from the first.
  const Eigen::Vector2d x(std::cos(0.35), std::sin(0.35)), y(-x.y(), x.x());
  PlanPolygon outline;
  for (const auto& [u, v] : {std::pair(0, 0), {12, 0}, {12, 8}, {0, 8}}) {
    outline.outer.push_back(u * x + v * y);
  }
  const std::vector<Plane> planes = {{0, 0, 3}, {0, 0, 6}};
  const auto lines = lines_of(
      outline, planes,
      sample_roof(
          outline, [&](const auto& p) { return x.dot(p) < 5.0 ? 3.0 : 6.0; }, 0.5, 0.05, 1));
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_FALSE(lines[0].is_crease());
  EXPECT_NEAR(std::abs(lines[0].normal.dot(x)), 1.0, 1e-12);
  EXPECT_NEAR(std::abs(lines[0].offset), 5.0, 0.2);
}

TEST(PlanLines, StepNearTheEdgeOfAWingTakesItsPlace) {
  const PlanPolygon outline{{{0, 0}, {14, 0}, {14, 6}, {8, 6}, {8, 12}, {0, 12}}, {}};
  const std::vector<Plane> planes = {{0, 0, 3}, {0, 0, 6}};
  const auto lines =
      lines_of(outline, planes,
               sample_roof(
                   outline, [&](const auto& p) { return p.x() > 8.3 ? 3.0 : 6.0; }, 0.5, 0.0, 1),
               0.6);
  // The other edge of the re-entrant corner goes on as well.
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_NEAR(std::abs(lines[0].offset), 8.0, 1e-12);
  EXPECT_NEAR(std::abs(lines[1].offset), 6.0, 1e-12);
}

}  // namespace
}  // namespace gable
