#include <gable/grammar/height_field.h>
#include <gable/grammar/plan_outline.h>
#include <gable/grammar/synthesis/houses/prior.h>
#include <gtest/gtest.h>

#include <cmath>

namespace gable {
namespace {

double area(const std::vector<Eigen::Vector2d>& ring) {
  double twice = 0.0;
  for (size_t k = 0; k < ring.size(); ++k) {
    const auto& a = ring[k];
    const auto& b = ring[(k + 1) % ring.size()];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return 0.5 * twice;
}

int winding(const std::vector<Eigen::Vector2d>& ring, const Eigen::Vector2d& p) {
  int crossings = 0;
  for (size_t k = 0; k < ring.size(); ++k) {
    const auto& a = ring[k];
    const auto& b = ring[(k + 1) % ring.size()];
    if ((a.y() > p.y()) == (b.y() > p.y())) continue;
    if (p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) ++crossings;
  }
  return crossings % 2;
}

House two_blocks(std::array<double, 4> a, std::array<double, 4> b) {
  House house = make_house(Foundation::kII);
  house.footprints[0].values = {a[0], a[1], a[2], a[3]};
  house.footprints[1].values = {b[0], b[1], b[2], b[3]};
  return house;
}

TEST(PlanOutline, OneRectangleIsItsFourCorners) {
  House house = make_house(Foundation::kI);
  house.footprints[0].values = {1.0, 2.0, 10.0, 8.0};
  const auto outline = plan_outline(house);
  ASSERT_EQ(outline.size(), 1u);
  EXPECT_EQ(outline[0].outer.size(), 4u);
  EXPECT_NEAR(area(outline[0].outer), 80.0, 1e-12);
}

TEST(PlanOutline, BlocksThatTouchAlmostHaveNoSeam) {
  const auto outline = plan_outline(two_blocks({0, 0, 10, 8}, {8 + 1e-9, 0, 6, 8}));
  ASSERT_EQ(outline.size(), 1u);
  EXPECT_EQ(outline[0].outer.size(), 4u);
}

TEST(PlanOutline, SeparateBlocksAreSeparatePolygons) {
  const auto outline = plan_outline(two_blocks({0, 0, 10, 8}, {12, 0, 6, 8}));
  ASSERT_EQ(outline.size(), 2u);
  EXPECT_NEAR(area(outline[0].outer) + area(outline[1].outer), 128.0, 1e-12);
}

TEST(PlanOutline, BlocksThatMeetAtACornerOnlyStaySeparate) {
  const auto outline = plan_outline(two_blocks({0, 0, 10, 8}, {10, 8, 10, 8}));
  ASSERT_EQ(outline.size(), 2u);
  for (const auto& polygon : outline) EXPECT_EQ(polygon.outer.size(), 4u);
}

TEST(PlanOutline, ACourtyardIsAHole) {
  House house = make_house(Foundation::kU);
  house.footprints[0].values = {0, 0, 20, 5, 15, 5, 15, 5};
  Rule lid = make_rule(RuleKind::kGarageI);
  lid.values = {10, 13.5, 10, 3, 2.5};
  house.garages.push_back(lid);
  const auto outline = plan_outline(house);
  ASSERT_EQ(outline.size(), 1u);
  ASSERT_EQ(outline[0].holes.size(), 1u);
  EXPECT_NEAR(area(outline[0].outer), 300.0, 1e-12);
  EXPECT_NEAR(area(outline[0].holes[0]), -70.0, 1e-12);
}

TEST(PlanOutline, CoversWhatTheHeightFieldCovers) {
  Random random(4);
  PriorOptions options;
  options.garage_share = 1.0;
  for (int n = 0; n < 100; ++n) {
    const House house = random_house(&random, options);
    const HeightField field(house);
    const auto outline = plan_outline(house);
    for (int i = 0; i < 500; ++i) {
      const Eigen::Vector2d p(random.uniform(-16, 16), random.uniform(-16, 16));
      int covered = 0;
      for (const auto& polygon : outline) {
        covered += winding(polygon.outer, p);
        for (const auto& hole : polygon.holes) covered -= winding(hole, p);
      }
      EXPECT_EQ(covered, field.block_at_house(field.house_from_local(p)) >= 0 ? 1 : 0);
    }
  }
}

}  // namespace
}  // namespace gable
