#include <gable/engine/io/models/build_model.h>
#include <gable/engine/io/models/building_file.h>
#include <gable/engine/io/models/model_writer.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "engine/io/plain_house.h"
#include "engine/io/sample_building.h"
#include "engine/io/scratch.h"

namespace gable {
namespace {

double volume(const Solid& solid) {
  double sum = 0.0;
  for (const Face& face : solid.faces) {
    for (const std::vector<int>& ring : face.rings) {
      for (size_t i = 2; i < ring.size(); ++i) {
        sum +=
            solid.vertices[ring[0]].dot(solid.vertices[ring[i - 1]].cross(solid.vertices[ring[i]]));
      }
    }
  }
  return sum / 6.0;
}

TEST(BuildModel, PartsCarryTheLevelsTheyExistAt) {
  const BuildingModel model = build_model(plain_house());
  EXPECT_EQ(model.origin, Eigen::Vector3d(1000.0, 2000.0, 10.0));
  ASSERT_EQ(model.parts.size(), 3u);
  EXPECT_EQ(model.parts[0].role, PartRole::kMain);
  EXPECT_EQ(model.parts[1].role, PartRole::kGarage);
  EXPECT_EQ(model.parts[2].role, PartRole::kChimney);
  EXPECT_EQ(model.parts[0].solids.size(), 3u);
  EXPECT_EQ(model.parts[1].solids.size(), 3u);
  ASSERT_EQ(model.parts[2].solids.size(), 1u);
  EXPECT_EQ(model.parts[2].solids[0].lod, Lod::k22);
  EXPECT_NEAR(volume(finest_solid(model.parts[0])), 10.0 * 8.0 * 4.5, 1e-3);
  EXPECT_NEAR(volume(finest_solid(model.parts[1])), 6.0 * 3.0 * 3.0, 1e-3);
}

TEST(BuildModel, LevelsThatAreAskedForAreThoseOfTheWhole) {
  const BuildingModel whole = build_model(plain_house());
  const BuildingModel finest = build_model(plain_house(), std::array{Lod::k22});
  ASSERT_EQ(finest.parts.size(), whole.parts.size());
  EXPECT_EQ(finest.dropped, whole.dropped);
  for (size_t i = 0; i < whole.parts.size(); ++i) {
    ASSERT_EQ(finest.parts[i].solids.size(), 1u);
    EXPECT_EQ(finest.parts[i].role, whole.parts[i].role);
    EXPECT_EQ(finest.parts[i].solids[0].solid.vertices, finest_solid(whole.parts[i]).vertices);
  }
}

TEST(BuildModel, ExtrusionIsOneSolidAtTheCoarsestLevel) {
  const BuildingModel model = build_model(sample_extrusion("1"));
  ASSERT_EQ(model.parts.size(), 1u);
  ASSERT_EQ(model.parts[0].solids.size(), 1u);
  EXPECT_EQ(model.parts[0].solids[0].lod, Lod::k12);
  EXPECT_NEAR(volume(model.parts[0].solids[0].solid), (100.0 - 9.15) * (8.0 / 3.0 + 0.25), 1e-6);
}

TEST(BuildModel, ClosedPlanesAreAnExtrusionAtTheCoarsestLevelAndTheirRoofAtTheOthers) {
  const BuildingModel model = build_model(sample_planes("1"));
  ASSERT_EQ(model.parts.size(), 1u);
  ASSERT_EQ(model.parts[0].solids.size(), 3u);
  EXPECT_EQ(model.parts[0].solids[0].lod, Lod::k12);
  EXPECT_EQ(model.parts[0].solids[2].lod, Lod::k22);
  EXPECT_NEAR(volume(model.parts[0].solids[0].solid), 84.0 * (11.0 / 3.0 + 0.25), 1e-6);
  EXPECT_NEAR(volume(finest_solid(model.parts[0])), 60.0 * 4.25 + 24.0 * 2.75, 1e-6);
}

TEST(BuildModel, RoofThatComesDownToItsBaseIsLeftOut) {
  Building building = sample_planes("1");
  building.roof->planes[2].c = building.base;
  const BuildingModel model = build_model(building);
  ASSERT_EQ(model.parts.size(), 1u);
  EXPECT_EQ(model.parts[0].solids.size(), 1u);
  EXPECT_EQ(model.dropped,
            std::vector<std::string>{"the planes of the roof enclose no valid solid"});
}

TEST(BuildModel, OutlineWithoutAreaSaysSo) {
  Building flat = sample_extrusion("1");
  flat.outline.holes.clear();
  flat.outline.outer = {{0, 0}, {1, 0}, {2, 0}};
  const BuildingModel model = build_model(flat);
  EXPECT_TRUE(model.parts.empty());
  EXPECT_EQ(model.dropped.size(), 1u);
}

TEST(BuildModel, ABuildingReadBackIsWrittenAsTheSameBytes) {
  const ScratchFolder scratch;
  const std::string path = scratch.path("out.city.jsonl");
  const auto write = [&path](const std::vector<Building>& buildings) {
    const auto writer = open_model_writer(path, {Crs(), {1000.0, 2000.0, 0.0}});
    for (const Building& building : buildings) writer->append(building, build_model(building));
    writer->close();
    return file_bytes(path);
  };
  const std::string first = write({plain_house(), sample_extrusion("2"), sample_planes("3")});
  EXPECT_EQ(write(read_buildings(path).buildings), first);
}

}  // namespace
}  // namespace gable
