#include <gable/training/scans/cityjson_solids.h>
#include <gable/training/scans/cityjson_surfaces.h>
#include <gable/training/scans/face_plane.h>

#include <Eigen/Geometry>
#include <cstdlib>
#include <set>

#include "engine/io/scratch.h"

namespace gable {
namespace {

/// A box of 6 x 4 m, 5 m high, as the coarse model; as the detailed one the same with a saddle roof
/// whose ridge runs along x at 7 m and whose west wall is cut into two coplanar polygons.
constexpr const char* kHouse = R"({"type": "CityJSON", "version": "2.0",
"transform": {"scale": [0.001, 0.001, 0.001], "translate": [1000.0, 2000.0, 10.0]},
"vertices": [[0,0,0], [6000,0,0], [6000,4000,0], [0,4000,0],
             [0,0,5000], [6000,0,5000], [6000,4000,5000], [0,4000,5000],
             [0,2000,7000], [6000,2000,7000]],
"CityObjects": {"house-1": {"type": "BuildingPart", "geometry": [
{"type": "Solid", "lod": "1.2",
 "boundaries": [[[[0,3,2,1]], [[0,1,5,4]], [[1,2,6,5]], [[2,3,7,6]], [[3,0,4,7]], [[4,5,6,7]]]]},
{"type": "Solid", "lod": "2.2",
 "boundaries": [[[[0,3,2,1]], [[0,1,5,4]], [[1,2,6,9,5]], [[2,3,7,6]], [[3,0,4,7]], [[4,8,7]],
                 [[4,5,9,8]], [[6,7,8,9]]]],
 "semantics": {"surfaces": [{"type": "GroundSurface"}, {"type": "WallSurface"},
                            {"type": "RoofSurface"}],
               "values": [[0,1,1,1,1,1,2,2]]}}]}}})";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

double area_of(const LabelledSurface& surface, size_t triangle) {
  const auto& [a, b, c] = surface.triangles[triangle];
  return 0.5 * (surface.vertices[b] - surface.vertices[a])
                   .cross(surface.vertices[c] - surface.vertices[a])
                   .norm();
}

TEST(CityJsonSurfaces, AHouseKnowsItsPlanesAtEveryScale) {
  const ScratchFolder folder;
  const CityJsonSurfaces read = read_cityjson_surfaces(folder.write("house.city.json", kHouse));
  ASSERT_EQ(read.buildings.size(), 1u);
  const BuildingSurface& house = read.buildings[0];
  EXPECT_EQ(house.id, "house-1");
  EXPECT_EQ(house.origin, Eigen::Vector3d(1000.0, 2000.0, 10.0));
  EXPECT_THAT(house.num_planes, testing::ElementsAre(7, 7, 6));
  // Ground, walls (gables and their walls are one), slopes, in the order of the file.
  const double slope = 6.0 * std::hypot(2.0, 2.0);
  const std::vector<double> truth = {24, 30, 24, 30, 24, slope, slope};
  const std::vector<double> hull_truth = {24, 30, 24, 30, 24, 2 * slope};
  std::vector<double> area(7, 0.0), hull_area(6, 0.0);
  for (size_t i = 0; i < house.surface.triangles.size(); ++i) {
    EXPECT_EQ(house.surface.planes[i][0], house.surface.planes[i][1]);
    area[house.surface.planes[i][1]] += area_of(house.surface, i);
    hull_area[house.surface.planes[i][2]] += area_of(house.surface, i);
  }
  EXPECT_THAT(area, testing::Pointwise(testing::DoubleNear(1e-9), truth));
  EXPECT_THAT(hull_area, testing::Pointwise(testing::DoubleNear(1e-9), hull_truth));
}

TEST(CityJsonSurfaces, LevelsMayBeNumbersAndCoordinatesMetres) {
  std::string text = replaced(kHouse, "\"1.2\"", "1.2");
  text = replaced(text, "\"2.2\"", "2.2");
  text = replaced(text,
                  R"("transform": {"scale": [0.001, 0.001, 0.001], )"
                  R"("translate": [1000.0, 2000.0, 10.0]},)",
                  "");
  const ScratchFolder folder;
  const CityJsonSurfaces read = read_cityjson_surfaces(folder.write("house.city.json", text));
  ASSERT_EQ(read.buildings.size(), 1u);
  EXPECT_EQ(read.buildings[0].surface.vertices[3], Eigen::Vector3d(6000, 0, 0));
}

TEST(CityJsonSurfaces, OpenAndSimpleBuildingsAreCountedAndLeftOut) {
  const ScratchFolder folder;
  const std::string open = replaced(kHouse, "[[4,8,7]],", "");
  const CityJsonSurfaces holed = read_cityjson_surfaces(
      folder.write("open.city.json", replaced(open, "[[0,1,1,1,1,1,2,2]]", "[[0,1,1,1,1,2,2]]")));
  EXPECT_EQ(holed.with_both_levels, 1);
  EXPECT_EQ(holed.invalid, 1);
  EXPECT_TRUE(holed.buildings.empty());
  CityJsonSurfaceOptions options;
  options.least_planes = 8;
  const CityJsonSurfaces simple =
      read_cityjson_surfaces(folder.write("house.city.json", kHouse), options);
  EXPECT_EQ(simple.too_simple, 1);
  EXPECT_TRUE(simple.buildings.empty());
}

TEST(CityJsonSurfaces, BadFilesNameTheFileAndTheReason) {
  const ScratchFolder folder;
  const auto reason = [&](const std::string& text) {
    const std::string path = folder.write("bad.city.json", text);
    const Error error = error_of([&] { read_cityjson_surfaces(path); }, path);
    EXPECT_EQ(error.code(), ExitCode::kBadInput);
    return std::string(error.what());
  };
  EXPECT_THAT(reason(std::string(kHouse).substr(0, 200)), testing::HasSubstr("cut short"));
  EXPECT_THAT(reason("{}"), testing::HasSubstr("is not CityJSON"));
  EXPECT_THAT(reason(replaced(kHouse, "[[0,3,2,1]]", "[[0,3,2,10]]")),
              testing::HasSubstr("vertex 10 of 10"));
  EXPECT_THAT(reason(replaced(kHouse, "[[0,3,2,1]]", "[[0,3,\"a\",1]]")),
              testing::HasSubstr("not well-formed"));
  EXPECT_THAT(reason(replaced(kHouse, "\"lod\": \"1.2\"", "\"lod\": \"1.3\"")),
              testing::HasSubstr("levels of detail 2.2 and 1.2"));
  EXPECT_EQ(error_of([&] { read_cityjson_surfaces(folder.path("none")); }).code(),
            ExitCode::kNoInput);
}

/// Real buildings: their triangles have the polygons' areas, and lie in their planes.
TEST(CityJsonSurfaces, TrianglesOfRealBuildingsCoverTheirPolygons) {
  const char* data = std::getenv("GABLE_DATA");
  const std::string path =
      (data ? std::string(data) : std::string(GABLE_SOURCE_DIR) + "/../shared/data") +
      "/3dbag-delft/tile_5910.city.json";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no real data at " << path;
  const CityJsonSurfaces read = read_cityjson_surfaces(path);
  EXPECT_EQ(read.with_both_levels, 430);
  EXPECT_GT(read.buildings.size(), 400u);
  std::map<std::string, const BuildingSurface*> by_id;
  for (const BuildingSurface& building : read.buildings) by_id[building.id] = &building;
  for (const CityJsonObject& object : read_cityjson_solids(path)) {
    if (!by_id.contains(object.id)) continue;
    const LabelledSurface& surface = by_id[object.id]->surface;
    double polygons = 0.0, triangles = 0.0;
    for (const Face& face : object.solids.at("2.2").faces) {
      polygons += face_plane(object.solids.at("2.2"), face).area;
    }
    std::set<int> hull_planes;
    for (size_t i = 0; i < surface.triangles.size(); ++i) {
      triangles += area_of(surface, i);
      hull_planes.insert(surface.planes[i][2]);
    }
    EXPECT_NEAR(triangles, polygons, 1e-3 * polygons) << object.id;
    const auto& num_planes = by_id[object.id]->num_planes;
    EXPECT_LE(num_planes[2], num_planes[0]) << object.id;
    EXPECT_EQ(static_cast<int>(hull_planes.size()), num_planes[2]);
  }
}

}  // namespace
}  // namespace gable
