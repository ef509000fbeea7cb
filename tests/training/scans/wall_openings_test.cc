#include <gable/training/scans/wall_openings.h>
#include <gtest/gtest.h>

namespace gable {
namespace {

TEST(WallOpenings, LieInsideTheWallApartFromEachOther) {
  // A gable wall 10 m wide, 6 m high at its eaves and 9 m at its ridge.
  const std::vector<Eigen::Vector2d> gable = {{0, 0}, {10, 0}, {10, 6}, {5, 9}, {0, 6}};
  for (uint64_t seed = 1; seed <= 50; ++seed) {
    Random random(seed);
    const WindowStyle style = random_window_style(2.7, &random);
    const std::vector<Recess> openings =
        wall_openings(gable, style, true, &random, [](const Recess&) { return true; });
    EXPECT_GE(openings.size(), 3u);
    for (size_t i = 0; i < openings.size(); ++i) {
      const Recess& a = openings[i];
      EXPECT_GE(a.u0, 0.2);
      EXPECT_LE(a.u1, 9.8);
      EXPECT_GE(a.v0, 0.02);
      EXPECT_LE(a.v1, 6.0 + 0.6 * std::min(a.u0, 10.0 - a.u1));
      for (size_t j = i + 1; j < openings.size(); ++j) {
        const Recess& b = openings[j];
        const double du = std::max(a.u0 - b.u1, b.u0 - a.u1);
        const double dv = std::max(a.v0 - b.v1, b.v0 - a.v1);
        EXPECT_GT(std::max(du, dv), 0.2);
      }
    }
  }
}

TEST(WallOpenings, KeepClearOfWhatIsNotFree) {
  const std::vector<Eigen::Vector2d> wall = {{0, 0}, {12, 0}, {12, 6}, {0, 6}};
  Random random(4);
  const WindowStyle style = random_window_style(2.7, &random);
  const auto openings =
      wall_openings(wall, style, false, &random, [](const Recess& r) { return r.u1 < 5.0; });
  EXPECT_FALSE(openings.empty());
  for (const Recess& r : openings) EXPECT_LT(r.u1, 5.0);
}

}  // namespace
}  // namespace gable
