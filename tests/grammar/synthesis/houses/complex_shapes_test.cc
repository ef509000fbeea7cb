#include <gable/grammar/synthesis/houses/complex_shapes.h>
#include <gable/grammar/synthesis/houses/distinct.h>
#include <gable/grammar/synthesis/houses/plan_union.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace gable {
namespace {

ComplexKind kind_of(int k) { return static_cast<ComplexKind>(k); }

TEST(ComplexShapes, SameSeedGivesTheSameShape) {
  for (int k = 0; k < kNumComplexKinds; ++k) {
    Random a(5), b(5);
    const BuiltShape first = random_complex(kind_of(k), &a),
                     second = random_complex(kind_of(k), &b);
    ASSERT_EQ(first.parts.size(), second.parts.size());
    for (size_t i = 0; i < first.parts.size(); ++i) {
      EXPECT_EQ(first.parts[i].center, second.parts[i].center);
      EXPECT_EQ(first.parts[i].eaves, second.parts[i].eaves);
    }
    EXPECT_EQ(a.next(), b.next());
  }
}

TEST(ComplexShapes, OfEveryKindStandAroundTheOriginAndFitACrop) {
  Random random(6);
  for (int k = 0; k < kNumComplexKinds; ++k) {
    for (int i = 0; i < 40; ++i) {
      const BuiltShape shape = random_complex(kind_of(k), &random);
      ASSERT_FALSE(shape.parts.empty());
      for (const BuiltPart& part : shape.parts) {
        EXPECT_GE(part.half_length, 0.35 - 1e-9) << k;  // chimneys
        EXPECT_GE(part.half_width, 0.35 - 1e-9) << k;
        EXPECT_GE(part.eaves, 1.8) << k;
        EXPECT_LE(part.eaves + part.rise, 25.0) << k;
        EXPECT_NEAR(part.along.norm(), 1.0, 1e-9);
        EXPECT_LT(part.center.norm() + part.radius(), 34.0) << k;
      }
    }
  }
}

TEST(ComplexShapes, OutlineHoldsAllPartsOfOneBuilding) {
  Random random(7);
  for (int k = 0; k < kNumComplexKinds; ++k) {
    if (kind_of(k) == ComplexKind::kSmallThings) continue;  // may stand apart
    for (int i = 0; i < 40; ++i) {
      const BuiltShape shape = random_complex(kind_of(k), &random);
      const PlanPolygon outline = outline_of(shape);
      int differ = 0;
      for (int p = 0; p < 500; ++p) {
        const Eigen::Vector2d point(random.uniform(-20.0, 20.0), random.uniform(-20.0, 20.0));
        bool inside = ring_holds(outline.outer, point);
        for (const auto& hole : outline.holes) inside = inside && !ring_holds(hole, point);
        differ += inside != std::isfinite(shape.at(point));
      }
      EXPECT_LE(differ, 6) << "kind " << k << ", shape " << i;
    }
  }
}

TEST(ComplexShapes, CompositesAreFourToSixBlocksThatAreToldApart) {
  Random random(8);
  int counts[7] = {};
  for (int i = 0; i < 60; ++i) {
    const House house = random_composite(&random);
    EXPECT_EQ(house.foundation, Foundation::kC);
    ASSERT_GE(house.num_components(), 4);
    ASSERT_LE(house.num_components(), 6);
    ++counts[house.num_components()];
    EXPECT_TRUE(is_distinct(house));
  }
  EXPECT_GT(counts[4], 0);
  EXPECT_GT(counts[5], 0);
  EXPECT_GT(counts[6], 0);
}

TEST(ComplexShapes, CourtyardsHaveACourtAndTurnedWingsAreTurned) {
  Random random(9);
  for (int i = 0; i < 40; ++i) {
    EXPECT_EQ(outline_of(random_complex(ComplexKind::kCourtyard, &random)).holes.size(), 1u);
    const BuiltShape turned = random_complex(ComplexKind::kTurnedWings, &random);
    const Eigen::Vector2d main = turned.parts[0].along, wing = turned.parts[1].along;
    const double angle = std::acos(std::min(1.0, std::abs(main.dot(wing)))) * 180.0 / M_PI;
    EXPECT_GE(angle, 20.0 - 1e-6);
    EXPECT_LE(angle, 70.0 + 1e-6);
  }
}

}  // namespace
}  // namespace gable
