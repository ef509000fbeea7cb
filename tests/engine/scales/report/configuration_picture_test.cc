#include <gable/engine/drawing/canvas.h>
#include <gable/engine/scales/report/configuration_picture.h>
#include <gable/engine/scales/report/shape_colors.h>
#include <gable/grammar/random.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

namespace gable {
namespace {

/// A box of a ground (0), two walls (1, 2) and a top (3), and two elements beside it without shape.
Scan box_mesh() {
  Scan mesh;
  mesh.points = {{0, 0, 0}, {8, 0, 0}, {8, 4, 0}, {0, 4, 0}, {0, 0, 3}, {8, 0, 3},
                 {8, 4, 3}, {0, 4, 3}, {9, 0, 0}, {9, 1, 0}, {9, 0, 1}};
  for (const auto& facet : std::vector<std::vector<int>>{
           {0, 3, 2, 1}, {0, 1, 5, 4}, {3, 0, 4, 7}, {4, 5, 6, 7}, {8, 9, 10}, {8, 8, 9}}) {
    mesh.facets.add(facet);
  }
  return mesh;
}

const std::vector<int> kBoxShapes{0, 1, 2, 3, -1, -1};

PlanarShape shape_of(const std::vector<Eigen::Vector3d>& ring, const Eigen::Vector3d& normal) {
  PlanarShape shape;
  shape.plane = OrientedPlane(normal, normal.dot(ring[0]));
  shape.polygons.push_back({ring, {}});
  return shape;
}

/// Pixels that have the hue of a colour, whatever the light.
int num_pixels_like(const cv::Mat& picture, const Color& color) {
  const Eigen::Vector3d wanted = Eigen::Vector3d(color.blue, color.green, color.red).normalized();
  int count = 0;
  for (int row = 0; row < picture.rows; ++row) {
    for (int col = 0; col < picture.cols; ++col) {
      const cv::Vec3b p = picture.at<cv::Vec3b>(row, col);
      const Eigen::Vector3d seen(p[0], p[1], p[2]);
      if (seen.norm() > 100.0 && seen.normalized().dot(wanted) > 0.9999) ++count;
    }
  }
  return count;
}

bool same(const cv::Mat& a, const cv::Mat& b) {
  return a.size() == b.size() && cv::norm(a, b, cv::NORM_INF) == 0.0;
}

TEST(ConfigurationPicture, HasTheViewsSizeAndIsTheSameTwice) {
  const Scan mesh = box_mesh();
  const AxonometricView view = view_of(mesh.points, 300, 200);
  const cv::Mat picture = draw_elements(mesh, kBoxShapes, view);
  EXPECT_EQ(picture.size(), cv::Size(300, 200));
  EXPECT_EQ(picture.type(), CV_8UC3);
  EXPECT_TRUE(same(picture, draw_elements(mesh, kBoxShapes, view)));
  EXPECT_EQ(picture.at<cv::Vec3b>(0, 0), bgr(kPaperColor));
}

TEST(ConfigurationPicture, ShowsTheColourOfEveryShapeInSightAndNoOther) {
  const Scan mesh = box_mesh();
  const AxonometricView view = view_of(mesh.points, 300, 200);
  const cv::Mat picture = draw_elements(mesh, kBoxShapes, view);
  EXPECT_EQ(num_pixels_like(picture, shape_color(0)), 0);  // the ground, below all else
  for (const int shape : {1, 2, 3}) {
    EXPECT_GT(num_pixels_like(picture, shape_color(shape)), 500) << shape;
  }
  EXPECT_GT(num_pixels_like(picture, kNoShapeColor), 20);
}

TEST(ConfigurationPicture, OfPointsClosesUpToSurfaces) {
  Random random(3);
  Scan cloud;
  std::vector<int> shape_of_point;
  for (int i = 0; i < 20000; ++i) {
    const double x = random.uniform(0.0, 8.0), y = random.uniform(0.0, 4.0);
    const bool wall = i % 3 == 0;
    cloud.points.push_back(wall ? Eigen::Vector3d(x, 0.0, 0.75 * y) : Eigen::Vector3d(x, y, 3.0));
    shape_of_point.push_back(wall ? 1 : 0);
  }
  const AxonometricView view = view_of(cloud.points, 300, 200);
  const cv::Mat points = draw_elements(cloud, shape_of_point, view);
  const std::vector<PlanarShape> shapes{
      shape_of({{0, 0, 3}, {8, 0, 3}, {8, 4, 3}, {0, 4, 3}}, Eigen::Vector3d::UnitZ()),
      shape_of({{0, 0, 0}, {8, 0, 0}, {8, 0, 3}, {0, 0, 3}}, -Eigen::Vector3d::UnitY())};
  const cv::Mat polygons = draw_shapes(shapes, view);
  for (const int shape : {0, 1}) {
    const int area = num_pixels_like(polygons, shape_color(shape));
    EXPECT_GT(area, 2000);
    EXPECT_NEAR(num_pixels_like(points, shape_color(shape)), area, 0.15 * area) << shape;
  }
}

TEST(ConfigurationPicture, ANearerShapeHidesAFartherOneWhateverTheirOrder) {
  const PlanarShape low =
      shape_of({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}, Eigen::Vector3d::UnitZ());
  const std::vector<Eigen::Vector3d> corners{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}};
  const AxonometricView view = view_of(corners, 240, 240);
  PlanarShape high = low;  // covers the same pixels, seen from the eye
  for (Eigen::Vector3d& p : high.polygons[0].outer) p += 2.0 * view.toward;
  high.plane = OrientedPlane(Eigen::Vector3d::UnitZ(), 2.0 * view.toward.z());
  const cv::Mat above = draw_shapes(std::vector{low, high}, view);
  EXPECT_EQ(num_pixels_like(above, shape_color(0)), 0);
  EXPECT_GT(num_pixels_like(above, shape_color(1)), 5000);
  const cv::Mat below = draw_shapes(std::vector{high, low}, view);
  EXPECT_EQ(num_pixels_like(below, shape_color(1)), 0);
  EXPECT_GT(num_pixels_like(below, shape_color(0)), 5000);
}

TEST(ConfigurationPicture, PlanesThatCrossHideEachOtherByHalves) {
  const PlanarShape roof = shape_of({{0, 0, -2}, {4, 0, -2}, {4, 4, 2}, {0, 4, 2}},
                                    Eigen::Vector3d(0, -1, 1).normalized());
  const PlanarShape level =
      shape_of({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}, Eigen::Vector3d::UnitZ());
  const std::vector<Eigen::Vector3d> corners{{0, 0, -2}, {4, 4, 2}, {4, 0, -2}, {0, 4, 2}};
  const AxonometricView view = view_of(corners, 240, 240);
  const cv::Mat picture = draw_shapes(std::vector{roof, level}, view);
  const auto color_at = [&](const Eigen::Vector3d& p) {
    const Eigen::Vector3d q = view.project(p);
    const cv::Rect around(static_cast<int>(q.x()) - 2, static_cast<int>(q.y()) - 2, 5, 5);
    return picture(around).clone();
  };
  // In front (low y) the level plane is above the roof, behind the roof is above it.
  EXPECT_GT(num_pixels_like(color_at({2, 1, 0}), shape_color(1)), 20);
  EXPECT_GT(num_pixels_like(color_at({2, 3, 1}), shape_color(0)), 20);
}

TEST(ConfigurationPicture, LeavesHolesOpen) {
  PlanarShape shape =
      shape_of({{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}}, Eigen::Vector3d::UnitZ());
  const AxonometricView view = view_of(shape.polygons[0].outer, 240, 240);
  const int whole = num_pixels_like(draw_shapes(std::vector{shape}, view), shape_color(0));
  shape.polygons[0].holes.push_back({{3, 3, 0}, {3, 6, 0}, {6, 6, 0}, {6, 3, 0}});
  const int rest = num_pixels_like(draw_shapes(std::vector{shape}, view), shape_color(0));
  EXPECT_NEAR(rest, whole * 8.0 / 9.0, 0.03 * whole);
}

TEST(ConfigurationPicture, OfNothingIsWhite) {
  const AxonometricView view = view_of({}, 64, 48);
  const cv::Mat picture = draw_shapes({}, view);
  EXPECT_TRUE(same(picture, cv::Mat(48, 64, CV_8UC3, cv::Scalar(255, 255, 255))));
  Scan one;
  one.points = {{1, 2, 3}};
  const cv::Mat dot = draw_elements(one, std::vector{0}, view_of(one.points, 64, 48));
  EXPECT_GT(num_pixels_like(dot, shape_color(0)), 10);
}

TEST(AxonometricView, HoldsThePointsAndLooksFromAbove) {
  Random random(5);
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 400; ++i) {
    points.emplace_back(85000.0 + random.uniform(0.0, 30.0), 447000.0 + random.uniform(0.0, 10.0),
                        random.uniform(0.0, 12.0));
  }
  const AxonometricView view = view_of(points, 320, 200);
  EXPECT_NEAR(view.right.cross(view.up).dot(view.toward), 1.0, 1e-12);
  EXPECT_NEAR(view.right.z(), 0.0, 1e-12);
  double least = 1e9, most = -1e9;
  for (const Eigen::Vector3d& p : points) {
    const Eigen::Vector3d q = view.project(p);
    EXPECT_GT(q.x(), 5.0);
    EXPECT_LT(q.x(), 314.0);
    EXPECT_GT(q.y(), 5.0);
    EXPECT_LT(q.y(), 194.0);
    least = std::min(least, q.x());
    most = std::max(most, q.x());
  }
  EXPECT_GT(view.toward.z(), 0.3);
  EXPECT_LT(view.toward.y(), -0.3);  // the long side that faces south
  const Eigen::Vector3d step = view.project(points[0] + view.up) - view.project(points[0]);
  EXPECT_NEAR(step.y(), -view.pixels_per_meter, 1e-6);
}

TEST(ShapeColor, IsFarFromThoseOfNeighbouringNumbers) {
  for (int shape = 0; shape < 200; ++shape) {
    for (int other = shape + 1; other <= shape + 4; ++other) {
      const Color a = shape_color(shape), b = shape_color(other);
      const double apart = std::hypot(a.red - b.red, a.green - b.green, a.blue - b.blue);
      EXPECT_GT(apart, 30.0) << shape << " and " << other;
    }
  }
}

TEST(LabelColor, IsGreyForFragmentsOnly) {
  const auto saturation = [](const Color& c) {
    return std::max({c.red, c.green, c.blue}) - std::min({c.red, c.green, c.blue});
  };
  EXPECT_LT(saturation(label_color(0)), 10);
  for (int label = 1; label < 8; ++label) EXPECT_GT(saturation(label_color(label)), 50) << label;
}

}  // namespace
}  // namespace gable
