#include <gable/engine/scales/lack_of_shapes.h>
#include <gable/grammar/random.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gable {
namespace {

using ::testing::HasSubstr;

Scan cloud(std::vector<Eigen::Vector3d> points) {
  Scan scan;
  scan.points = std::move(points);
  return scan;
}

TEST(LackOfShapes, SaysWhatIsWrongWithTheScan) {
  const FirstShapesOptions options;
  EXPECT_EQ(lack_of_shapes(cloud({{1, 2, 3}}), options), "it has 1 point, a shape needs 10");
  const Eigen::Vector3d far(84000.0, 447000.0, 12.3);
  EXPECT_THAT(lack_of_shapes(cloud(std::vector<Eigen::Vector3d>(50, far)), options),
              HasSubstr("at one place"));
  std::vector<Eigen::Vector3d> line, ball;
  Random random(1);
  for (int i = 0; i < 50; ++i) {
    line.push_back(far + 0.1 * i * Eigen::Vector3d(1.0, 2.0, -0.3));
    ball.push_back({random.normal(1.0), random.normal(1.0), random.normal(1.0)});
  }
  EXPECT_THAT(lack_of_shapes(cloud(line), options), HasSubstr("on a line"));
  EXPECT_THAT(lack_of_shapes(cloud(ball), options), HasSubstr("nowhere"));
  Scan mesh = cloud({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  mesh.facets.add(std::vector<int>{0, 1, 1});
  EXPECT_THAT(lack_of_shapes(mesh, options), HasSubstr("facets"));
}

}  // namespace
}  // namespace gable
