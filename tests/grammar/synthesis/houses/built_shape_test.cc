#include <gable/grammar/height_field.h>
#include <gable/grammar/plan_outline.h>
#include <gable/grammar/synthesis/houses/built_shape.h>
#include <gable/grammar/synthesis/houses/plan_union.h>
#include <gable/grammar/synthesis/houses/prior.h>
#include <gtest/gtest.h>

#include <cmath>

namespace gable {
namespace {

BuiltPart make_part(PartForm form) {
  BuiltPart part;
  part.center = {10.0, 20.0};
  part.along = {0.6, 0.8};
  part.half_length = 6.0;
  part.half_width = 4.0;
  part.form = form;
  part.eaves = 5.0;
  part.rise = 3.0;
  return part;
}

double at(const BuiltPart& part, double u, double v) {
  const Eigen::Vector2d across(-part.along.y(), part.along.x());
  return part.at(part.center + u * part.along + v * across);
}

TEST(BuiltShape, OfAHouseIsItsHeightField) {
  Random random(3);
  for (Foundation foundation :
       {Foundation::kI, Foundation::kII, Foundation::kIII, Foundation::kL, Foundation::kU}) {
    for (int i = 0; i < 20; ++i) {
      House house = random_house(foundation, &random);
      house.origin = {400.0, 200.0, 70.0};
      const HeightField field(house);
      const BuiltShape shape = shape_of(house);
      for (int k = 0; k < 200; ++k) {
        const Eigen::Vector2d local(random.uniform(-18.0, 18.0), random.uniform(-18.0, 18.0));
        const double height = shape.at(house.origin.head<2>() + local);
        if (field.block_at_house(field.house_from_local(local)) < 0) {
          EXPECT_EQ(height, -INFINITY);
        } else {
          EXPECT_NEAR(height, 70.0 + field.at_local(local, 0.0, 0.0), 1e-9);
        }
      }
    }
  }
}

TEST(BuiltShape, OutlineOfAHouseIsItsPlanOutline) {
  Random random(4);
  for (int i = 0; i < 40; ++i) {
    const House house = random_house(&random);
    const auto exact = plan_outline(house);
    if (exact.size() != 1) continue;
    double area = signed_area(exact[0].outer);
    for (const auto& hole : exact[0].holes) area += signed_area(hole);
    const PlanPolygon outline = outline_of(shape_of(house));
    double other = signed_area(outline.outer);
    for (const auto& hole : outline.holes) other += signed_area(hole);
    EXPECT_NEAR(other, area, 0.6);
  }
}

TEST(BuiltShape, FormsHaveTheirHeights) {
  EXPECT_NEAR(at(make_part(PartForm::kFlat), 5.9, -3.9), 5.0, 1e-12);
  EXPECT_NEAR(at(make_part(PartForm::kMono), 0.0, 2.0), 5.0 + 3.0 * 0.75, 1e-9);
  EXPECT_NEAR(at(make_part(PartForm::kBarrel), 3.0, 0.0), 8.0, 1e-9);
  EXPECT_NEAR(at(make_part(PartForm::kBarrel), 3.0, 2.0), 5.0 + 3.0 * 0.75, 1e-9);

  BuiltPart teeth = make_part(PartForm::kSawtooth);
  teeth.count = 3;  // 4 m each
  EXPECT_NEAR(at(teeth, -5.0, 0.0), 5.0 + 3.0 * 0.25, 1e-9);
  EXPECT_NEAR(at(teeth, 5.0, 0.0), 5.0 + 3.0 * 0.75, 1e-9);

  BuiltPart mansard = make_part(PartForm::kMansard);
  mansard.kink = 1.0;
  mansard.kink_rise = 2.4;
  EXPECT_NEAR(at(mansard, 0.0, 3.5), 6.2, 1e-9);
  EXPECT_NEAR(at(mansard, -5.0, 0.0), 7.4, 1e-9);
  EXPECT_NEAR(at(mansard, 0.0, 0.0), 8.0, 1e-9);

  BuiltPart hip = make_part(PartForm::kGable);
  hip.start_run = 3.0;
  EXPECT_NEAR(at(hip, -5.0, 0.0), 6.0, 1e-9);
  EXPECT_NEAR(at(hip, 5.9, 0.0), 8.0, 1e-9);
}

TEST(BuiltShape, RoundFormsEndAtTheirRims) {
  for (int corners : {0, 6, 8}) {
    BuiltPart cone = make_part(PartForm::kCone);
    cone.half_width = cone.half_length;
    cone.count = corners;
    EXPECT_NEAR(at(cone, 0.0, 0.0), 8.0, 1e-9);
    EXPECT_NEAR(at(cone, 3.0, 0.0), 6.5, 1e-9);
    for (const Eigen::Vector2d& corner : cone.ring()) {
      EXPECT_NEAR((corner - cone.center).norm(), cone.radius(), 1e-9);
      const Eigen::Vector2d inside = cone.center + 0.999 * (corner - cone.center);
      const Eigen::Vector2d outside = cone.center + 1.001 * (corner - cone.center);
      // A circle's ring has its corners on the circle.
      EXPECT_NEAR(cone.at(inside), 5.0, 0.01) << corners;
      EXPECT_EQ(cone.at(outside), -INFINITY) << corners;
    }
  }
}

TEST(BuiltShape, LiftsRaiseWhatIsUnderThemAndNothingElse) {
  BuiltShape shape;
  shape.parts = {make_part(PartForm::kGable)};
  BuiltPart lift = make_part(PartForm::kFlat);
  lift.half_length = 20.0;
  lift.half_width = 1.0;
  lift.eaves = 0.2;
  shape.lifts = {lift};
  const Eigen::Vector2d middle(10.0, 20.0), beyond = middle + 10.0 * lift.along;
  EXPECT_NEAR(shape.at(middle), 8.2, 1e-9);
  EXPECT_EQ(shape.at(beyond), -INFINITY);
  shape.move({1.0, 2.0, 50.0});
  EXPECT_NEAR(shape.at(middle + Eigen::Vector2d(1.0, 2.0)), 58.2, 1e-9);
}

}  // namespace
}  // namespace gable
