#include <gable/grammar/synthesis/houses/bent_row.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace gable {
namespace {

TEST(BentRow, FitsItsBoxAndIsNoRectangle) {
  Random random(1);
  double largest_seen = 0.0;
  for (double largest : {30.0, 100.0}) {
    for (int i = 0; i < 150; ++i) {
      const BuiltShape shape = random_bent_row(largest, &random);
      double outer = 0.0;
      Eigen::Vector2d low = shape.parts[0].center, high = low;
      for (const BuiltPart& part : shape.parts) {
        for (const Eigen::Vector2d& p : part.ring()) {
          outer = std::max(outer, p.norm());
          low = low.cwiseMin(p);
          high = high.cwiseMax(p);
        }
        EXPECT_GE(part.eaves, 2.0);
      }
      EXPECT_LE(2.0 * outer, largest + 1e-9);
      largest_seen = std::max(largest_seen, (high - low).norm());
      // More than the four corners of a rectangle.
      EXPECT_GE(outline_of(shape).outer.size(), 6u);
    }
  }
  EXPECT_GT(largest_seen, 70.0);
}

TEST(BentRow, SameSeedGivesTheSameRow) {
  Random a(7), b(7);
  const BuiltShape first = random_bent_row(50.0, &a), second = random_bent_row(50.0, &b);
  ASSERT_EQ(first.parts.size(), second.parts.size());
  for (size_t i = 0; i < first.parts.size(); ++i) {
    EXPECT_EQ(first.parts[i].center, second.parts[i].center);
    EXPECT_EQ(first.parts[i].eaves, second.parts[i].eaves);
  }
}

}  // namespace
}  // namespace gable
