#include <gable/engine/io/shapes/shapes_json.h>

#include <nlohmann/json.hpp>

#include "engine/io/sample_shapes.h"
#include "engine/io/scratch.h"

namespace gable {
namespace {

using nlohmann::json;

json point(const Eigen::Vector3d& p) { return {p.x(), p.y(), p.z()}; }

TEST(ShapesJson, HoldsEveryNumberExactly) {
  const ScaleShapes shapes = sample_shapes();
  const ScratchFolder scratch;
  write_shapes_json(scratch.path("shapes.json"), shapes);
  const json got = json::parse(file_bytes(scratch.path("shapes.json")));
  EXPECT_EQ(got["configuration"], 118);
  EXPECT_EQ(got["elements"], 4);
  EXPECT_EQ(got["coverage"], 0.75);
  EXPECT_EQ(got["rms"], 0.02);
  ASSERT_EQ(got["shapes"].size(), 2u);
  EXPECT_EQ(got["shapes"][0]["polygons"], json::array());
  const json& roof = got["shapes"][1];
  const PlanarShape& want = shapes.shapes[1];
  EXPECT_EQ(roof["shape"], 1);
  EXPECT_EQ(roof["normal"], point(want.plane.normal()));
  EXPECT_EQ(roof["offset"], want.plane.offset());
  EXPECT_EQ(roof["centroid"], point(want.centroid));
  EXPECT_EQ(roof["inliers"], 1200);
  EXPECT_EQ(roof["area"], 76.0);
  EXPECT_EQ(roof["rms"], want.rms);
  ASSERT_EQ(roof["polygons"].size(), 2u);
  EXPECT_EQ(roof["polygons"][0]["outer"][2], point(want.polygons[0].outer[2]));
  EXPECT_EQ(roof["polygons"][0]["holes"][0][3], point(want.polygons[0].holes[0][3]));
  EXPECT_EQ(roof["polygons"][1]["holes"], json::array());
}

TEST(ShapesJson, OfNoShapesIsStillJson) {
  EXPECT_EQ(json::parse(shapes_json({}))["shapes"], json::array());
}

}  // namespace
}  // namespace gable
