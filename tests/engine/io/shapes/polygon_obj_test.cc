#include <gable/engine/io/scans/obj_reader.h>
#include <gable/engine/io/shapes/polygon_obj.h>

#include <Eigen/Geometry>

#include "engine/io/sample_shapes.h"
#include "engine/io/scratch.h"

namespace gable {
namespace {

/// The signed area of all facets against a normal.
double area_along(const Scan& scan, const Eigen::Vector3d& normal) {
  double area = 0.0;
  for (size_t f = 0; f < scan.facets.size(); ++f) {
    const auto corners = scan.facets[f];
    const Eigen::Vector3d& first = scan.points[corners[0]];
    for (size_t i = 1; i + 1 < corners.size(); ++i) {
      area +=
          0.5 *
          normal.dot((scan.points[corners[i]] - first).cross(scan.points[corners[i + 1]] - first));
    }
  }
  return area;
}

TEST(PolygonObj, CoversThePolygonsButNotTheirHoles) {
  const ScaleShapes shapes = sample_shapes();
  const ScratchFolder scratch;
  write_polygon_obj(scratch.path("shapes.obj"), shapes);
  const std::string text = file_bytes(scratch.path("shapes.obj"));
  const Scan scan = read_obj(text, "shapes.obj").scan;
  EXPECT_EQ(scan.points.size(), 12u);
  EXPECT_EQ(scan.facets.size(), 9u);  // 8 triangles around the hole, a quadrilateral
  const double second = 1.5;          // of (0, 0), (2, 0), (1, 2), (0.75, 0.5)
  EXPECT_NEAR(area_along(scan, shapes.shapes[1].plane.normal()), 80.0 - 4.0 + second, 1e-6);
  EXPECT_THAT(text, testing::HasSubstr("g shape_1\n"));
  EXPECT_THAT(text, testing::Not(testing::HasSubstr("g shape_0\n")));
}

TEST(PolygonObj, StatesTheOriginThatLargeCoordinatesAreRelativeTo) {
  const ScaleShapes shapes = sample_shapes();
  const std::string text = polygon_obj(shapes);
  EXPECT_THAT(text, testing::HasSubstr("# local origin: 85062 447412 12\n"));
  const Eigen::Vector3d origin(85062, 447412, 12);
  EXPECT_EQ(read_obj(text, "").scan.points[0] + origin, shapes.shapes[1].polygons[0].outer[0]);
}

TEST(PolygonObj, KeepsSmallCoordinatesAsTheyAre) {
  ScaleShapes shapes;
  PlanarShape& shape = shapes.shapes.emplace_back();
  shape.polygons.push_back({{{-1, 0.1, 2}, {1, 0, 2}, {0, 1, 2}}, {}});
  const std::string text = polygon_obj(shapes);
  EXPECT_THAT(text, testing::HasSubstr("# local origin: 0 0 0\n"));
  EXPECT_THAT(text, testing::HasSubstr("v -1 0.1 2\n"));
  EXPECT_THAT(text, testing::HasSubstr("f 1 2 3\n"));
}

}  // namespace
}  // namespace gable
