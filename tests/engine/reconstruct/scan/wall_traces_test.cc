#include <gable/engine/reconstruct/scan/wall_traces.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace gable {
namespace {

// Samples of a wall from `from` to `to` in plan, between two heights, leaning outward by `lean`
// metres per metre.
void add_wall(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double low, double high,
              double lean, const Eigen::Vector3d& origin, std::vector<SurfaceSample>* samples,
              std::vector<PlanarShape>* shapes) {
  const Eigen::Vector2d along = (to - from).normalized();
  const Eigen::Vector2d out(along.y(), -along.x());
  const auto point = [&](double u, double z) {
    const Eigen::Vector2d p = from + u * (to - from) + lean * (z - low) * out;
    return Eigen::Vector3d(p.x(), p.y(), z);
  };
  for (int i = 0; i <= 40; ++i) {
    for (int k = 0; k <= 10; ++k) {
      samples->push_back(
          {point(i / 40.0, low + k * (high - low) / 10), 1.0, static_cast<int>(shapes->size())});
    }
  }
  const Eigen::Vector3d normal = Eigen::Vector3d(out.x(), out.y(), -lean).normalized();
  PlanarShape shape;
  shape.plane = OrientedPlane(normal, normal.dot(point(0, low) + origin));
  shapes->push_back(shape);
}

TEST(WallTraces, WallsStandWhereTheyDoAndReachAsFarAsTheyAreSeen) {
  const Eigen::Vector3d origin(84000, 447000, 3);
  std::vector<SurfaceSample> samples;
  std::vector<PlanarShape> shapes;
  add_wall({1, 2}, {5, 2}, 0, 3, 0.0, origin, &samples, &shapes);
  add_wall({5, 2}, {8, 6}, 0, 4, 0.1, origin, &samples, &shapes);
  add_wall({0, 0}, {0, 1}, 0, 3, 0.0, origin, &samples, &shapes);
  shapes.emplace_back().plane = OrientedPlane(Eigen::Vector3d::UnitZ(), 8.0);
  const auto traces = wall_traces(samples, shapes, origin, 0.25, 1.5);
  ASSERT_EQ(traces.size(), 2u);  // one is too short, one a roof
  // The longest first. It leans by 0.2 m where it is half as high.
  EXPECT_NEAR(traces[0].line.end - traces[0].line.begin, 5.0, 0.3);
  const Eigen::Vector2d out(0.8, -0.6);
  EXPECT_NEAR(traces[0].line.signed_distance(Eigen::Vector2d(5, 2) + 0.2 * out), 0.0, 1e-6);
  EXPECT_NEAR(traces[0].line.signed_distance(Eigen::Vector2d(8, 6) + 0.2 * out), 0.0, 1e-6);
  EXPECT_NEAR(traces[1].line.signed_distance({3, 2}), 0.0, 1e-9);
  EXPECT_NEAR(
      traces[1].line.at(traces[1].line.begin).x() + traces[1].line.at(traces[1].line.end).x(), 6.0,
      1e-6);
  EXPECT_NEAR(traces[1].line.end - traces[1].line.begin, 4.0, 0.25);
  EXPECT_NEAR(traces[1].low, 0.0, 1e-9);
  EXPECT_NEAR(traces[0].high, 4.0, 1e-9);
}

}  // namespace
}  // namespace gable
