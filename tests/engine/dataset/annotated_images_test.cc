#include <gable/engine/dataset/annotated_images.h>
#include <gtest/gtest.h>

namespace gable {
namespace {

/// 20 x 20 cells of 1 m around (100, 200); inside are the middle 10 x 10.
HeightImage block() {
  HeightImage image;
  image.origin = {100.0, 200.0, 0.0};
  image.gsd = 1.0;
  image.rows = image.cols = 20;
  image.first_center = {-9.5, 9.5};
  for (int row = 0; row < 20; ++row) {
    for (int col = 0; col < 20; ++col) {
      image.height.push_back(4.0f);
      image.ground.push_back(0.0f);
      image.weight.push_back(1.0f);
      image.inside.push_back(row >= 5 && row < 15 && col >= 5 && col < 15);
    }
  }
  return image;
}

TEST(AnnotationIou, IsOneForTheSameOutline) {
  AnnotatedHouse house;
  house.outline = {{95.0, 195.0}, {105.0, 195.0}, {105.0, 205.0}, {95.0, 205.0}};
  EXPECT_DOUBLE_EQ(annotation_iou(block(), house), 1.0);
}

TEST(AnnotationIou, CountsGaragesAsPartOfTheBuilding) {
  AnnotatedHouse house;
  house.outline = {{95.0, 195.0}, {100.0, 195.0}, {100.0, 205.0}, {95.0, 205.0}};
  EXPECT_DOUBLE_EQ(annotation_iou(block(), house), 0.5);
  house.garages = {{{100.0, 195.0}, {105.0, 195.0}, {105.0, 205.0}, {100.0, 205.0}}};
  EXPECT_DOUBLE_EQ(annotation_iou(block(), house), 1.0);
}

TEST(AnnotationIou, IsNothingWhereTheyLieApart) {
  AnnotatedHouse house;
  house.outline = {{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}};
  EXPECT_EQ(annotation_iou(block(), house), 0.0);
}

}  // namespace
}  // namespace gable
