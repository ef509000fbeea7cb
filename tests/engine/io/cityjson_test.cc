#include <gable/engine/io/models/building_file.h>
#include <gable/engine/io/models/model_writer.h>

#include <nlohmann/json.hpp>
#include <set>

#include "engine/io/sample_building.h"
#include "engine/io/scratch.h"

namespace gable {
namespace {

using nlohmann::json;

ModelWriterOptions options() {
  ModelWriterOptions options;
  options.crs = crs_from_text("EPSG:28992");
  options.anchor = {84900.7, 447500.2, 0.5};
  return options;
}

std::string write_samples(const std::string& path) {
  const auto writer = open_model_writer(path, options());
  const Building house = sample_house("house \"1\"");
  writer->append(house, sample_model(house.house->origin));
  const Building extrusion = sample_extrusion("2");
  writer->append(extrusion, sample_model(extrusion.origin));
  writer->close();
  return path;
}

void expect_same(const Building& a, const Building& b) {
  EXPECT_EQ(a.id, b.id);
  EXPECT_EQ(a.status, b.status);
  EXPECT_EQ(a.reason, b.reason);
  EXPECT_EQ(a.quality.mad, b.quality.mad);
  EXPECT_EQ(a.quality.rmse, b.quality.rmse);
  EXPECT_EQ(a.quality.time_ms, b.quality.time_ms);
  EXPECT_EQ(a.base, b.base);
  EXPECT_EQ(a.deviations, b.deviations);
  ASSERT_EQ(a.house.has_value(), b.house.has_value());
  if (!a.house) {
    EXPECT_EQ(a.origin, b.origin);
    EXPECT_EQ(a.height, b.height);
    EXPECT_EQ(a.outline.outer, b.outline.outer);
    EXPECT_EQ(a.outline.holes, b.outline.holes);
    return;
  }
  EXPECT_EQ(a.house->foundation, b.house->foundation);
  EXPECT_EQ(a.house->origin, b.house->origin);
  EXPECT_EQ(a.walls.polygon.outer, b.walls.polygon.outer);
  EXPECT_EQ(a.walls.polygon.holes, b.walls.polygon.holes);
  EXPECT_EQ(a.walls.reach, b.walls.reach);
  const auto first = a.house->derivation(), second = b.house->derivation();
  ASSERT_EQ(first.size(), second.size());
  for (size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i]->kind, second[i]->kind);
    EXPECT_EQ(first[i]->component, second[i]->component);
    EXPECT_EQ(first[i]->ridge, second[i]->ridge);
    for (int k = 0; k < first[i]->size(); ++k) EXPECT_EQ((*first[i])[k], (*second[i])[k]);
  }
}

class CityJsonRoundTrip : public testing::TestWithParam<const char*> {};

TEST_P(CityJsonRoundTrip, ReadingGivesTheSameBuildingsToTheLastBit) {
  const ScratchFolder scratch;
  const BuildingFile file = read_buildings(write_samples(scratch.path(GetParam())));
  EXPECT_EQ(file.epsg, 28992);
  ASSERT_EQ(file.buildings.size(), 2u);
  expect_same(file.buildings[0], sample_house("house \"1\""));
  expect_same(file.buildings[1], sample_extrusion("2"));
}

TEST_P(CityJsonRoundTrip, KnownWallsAreReadToTheLastBit) {
  const ScratchFolder scratch;
  Building house = sample_house("4");
  house.walls.polygon = {{{-6.1, -4.0}, {6.0, -4.0 / 3.0}, {5.0, 4.2}},
                         {{{0.0, 0.0}, {0.1, 1.0}, {1.0, 0.5}}}};
  house.walls.reach = 1.5;
  const std::string path = scratch.path(GetParam());
  const auto writer = open_model_writer(path, options());
  writer->append(house, sample_model(house.house->origin));
  writer->close();
  const BuildingFile file = read_buildings(path);
  ASSERT_EQ(file.buildings.size(), 1u);
  expect_same(file.buildings[0], house);
}

TEST_P(CityJsonRoundTrip, ClosedPlanesAreReadToTheLastBit) {
  const ScratchFolder scratch;
  const std::string path = scratch.path(GetParam());
  const Building planes = sample_planes("3");
  const auto writer = open_model_writer(path, options());
  writer->append(planes, sample_model(planes.origin));
  writer->close();
  const BuildingFile file = read_buildings(path);
  ASSERT_EQ(file.buildings.size(), 1u);
  expect_same(file.buildings[0], planes);
  ASSERT_TRUE(file.buildings[0].roof);
  const RoofPartition& roof = *file.buildings[0].roof;
  ASSERT_EQ(roof.planes.size(), 3u);
  EXPECT_EQ(roof.planes[1].b, planes.roof->planes[1].b);
  ASSERT_EQ(roof.regions.size(), 3u);
  for (size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(roof.regions[i].plane, planes.roof->regions[i].plane);
    EXPECT_EQ(roof.regions[i].polygon.outer, planes.roof->regions[i].polygon.outer);
  }
}

TEST_P(CityJsonRoundTrip, HousesOfManyBlocksComeBackAsSuch) {
  const ScratchFolder scratch;
  Building many = sample_house("many");
  many.house = make_house(Foundation::kMany);
  many.house->origin = {84893.1234567891, 447512.7654321, 1.0 / 3.0};
  for (int i = 0; i < 4; ++i) many.house->footprints[i][0] = 1.7 * i;
  many.deviations.clear();
  const std::string path = scratch.path(GetParam());
  const auto writer = open_model_writer(path, options());
  writer->append(many, sample_model(many.house->origin));
  writer->close();
  const BuildingFile file = read_buildings(path);
  ASSERT_EQ(file.buildings.size(), 1u);
  expect_same(file.buildings[0], many);
  EXPECT_NE(file_bytes(path).find("\"gable_foundation\":\"N\""), std::string::npos);
}

TEST_P(CityJsonRoundTrip, WritingTwiceGivesTheSameBytes) {
  const ScratchFolder scratch;
  const std::string once = file_bytes(write_samples(scratch.path(GetParam())));
  EXPECT_EQ(once, file_bytes(write_samples(scratch.path(GetParam()))));
  EXPECT_FALSE(once.empty());
}

TEST_P(CityJsonRoundTrip, NothingIsLeftOfAFileThatIsNotClosed) {
  const ScratchFolder scratch;
  {
    const auto writer = open_model_writer(scratch.path(GetParam()), options());
    const Building house = sample_house("1");
    writer->append(house, sample_model(house.house->origin));
  }
  EXPECT_EQ(scratch.num_files(), 0);
}

INSTANTIATE_TEST_SUITE_P(Formats, CityJsonRoundTrip,
                         testing::Values("out.city.json", "out.city.jsonl"));

TEST(CityJson, HoldsPartsLevelsSemanticsAndTheReferenceSystem) {
  const ScratchFolder scratch;
  const json file = json::parse(file_bytes(write_samples(scratch.path("out.city.json"))));
  EXPECT_EQ(file["version"], "2.0");
  EXPECT_EQ(file["metadata"]["referenceSystem"], "https://www.opengis.net/def/crs/EPSG/0/28992");
  EXPECT_EQ(file["transform"]["translate"], json({84900.0, 447500.0, 0.0}));
  const json& house = file["CityObjects"]["house \"1\""];
  EXPECT_EQ(house["type"], "Building");
  EXPECT_EQ(house["children"], json({"house \"1\"-main-1", "house \"1\"-chimney-1"}));
  const json& attributes = house["attributes"];
  EXPECT_EQ(attributes["gable_foundation"], "L");
  EXPECT_EQ(attributes["gable_roofs"], json({"mansard", "hip"}));
  EXPECT_NEAR(attributes["gable_azimuth_deg"], 90.0 - 2.0 / 7.0 * 180.0 / M_PI, 1e-12);
  EXPECT_DOUBLE_EQ(attributes["gable_eaves_m"], 2.9 + 0.4);
  EXPECT_DOUBLE_EQ(attributes["gable_ridge_m"], 2.9 + 2.1 + 0.4);
  EXPECT_EQ(attributes["gable_garages"], 2);
  const json& main = file["CityObjects"]["house \"1\"-main-1"];
  EXPECT_EQ(main["type"], "BuildingPart");
  EXPECT_EQ(main["parents"], json({"house \"1\""}));
  ASSERT_EQ(main["geometry"].size(), 3u);
  EXPECT_EQ(main["geometry"][1]["lod"], "2.0");
  EXPECT_EQ(main["geometry"][1]["semantics"]["surfaces"][2]["type"], "RoofSurface");
  EXPECT_EQ(main["geometry"][1]["semantics"]["values"], json({{0, 2, 1, 1, 1, 1, 1, 1, 1, 1}}));
  EXPECT_EQ(file["CityObjects"]["house \"1\"-chimney-1"]["type"], "BuildingInstallation");
  EXPECT_FALSE(file["CityObjects"]["2"]["attributes"].contains("gable_time_ms"));
}

TEST(CityJson, VerticesAreSharedUsedAndWhereTheSolidsAre) {
  const ScratchFolder scratch;
  const json file = json::parse(file_bytes(write_samples(scratch.path("out.city.json"))));
  std::set<std::vector<int64_t>> distinct;
  for (const json& v : file["vertices"]) distinct.insert(v.get<std::vector<int64_t>>());
  // Two buildings of 16 + 8 vertices, whatever the number of levels.
  EXPECT_EQ(distinct.size(), 48u);
  EXPECT_EQ(file["vertices"].size(), 48u);
  const json& extent = file["metadata"]["geographicalExtent"];
  EXPECT_NEAR(extent[0], 84893.1234567891, 1e-4);
  EXPECT_NEAR(extent[5], 5.0 + 1.0 / 3.0, 1e-4);
}

TEST(CityJson, AzimuthIsABearingWithinTheCircle) {
  const ScratchFolder scratch;
  for (const double azimuth : {-40.0, -1e-18, 0.5 * M_PI, 3.0, 400.0}) {
    Building house = sample_house("1");
    house.house->azimuth[0] = azimuth;
    const std::string path = scratch.path("out.city.json");
    const auto writer = open_model_writer(path, options());
    writer->append(house, {});
    writer->close();
    const double bearing =
        json::parse(file_bytes(path))["CityObjects"]["1"]["attributes"]["gable_azimuth_deg"];
    EXPECT_GE(bearing, 0.0);
    EXPECT_LT(bearing, 360.0);
    EXPECT_NEAR(std::sin(bearing * M_PI / 180.0), std::cos(azimuth), 1e-9);
    EXPECT_NEAR(std::cos(bearing * M_PI / 180.0), std::sin(azimuth), 1e-9);
  }
}

TEST(CityJson, SeqKeepsOneTransformAndOwnVerticesPerFeature) {
  const ScratchFolder scratch;
  std::ifstream stream(write_samples(scratch.path("out.city.jsonl")));
  std::vector<json> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(json::parse(line));
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[0]["CityObjects"], json::object());
  EXPECT_EQ(lines[0]["vertices"], json::array());
  EXPECT_EQ(lines[1]["type"], "CityJSONFeature");
  EXPECT_FALSE(lines[1].contains("transform"));
  EXPECT_EQ(lines[1]["vertices"].size(), 24u);
  EXPECT_EQ(lines[2]["id"], "2");
}

TEST(CityJson, FacesThinnerThanTheGridStepVanish) {
  const ScratchFolder scratch;
  BuildingModel model;
  model.parts.push_back({PartRole::kMain, 0, 0, {{Lod::k22, box({0, 0, 0}, {10, 10, 1e-5})}}});
  const auto writer = open_model_writer(scratch.path("out.city.json"), {});
  writer->append(sample_house("1"), model);
  writer->close();
  const json file = json::parse(file_bytes(scratch.path("out.city.json")));
  const json& geometry = file["CityObjects"]["1-main-1"]["geometry"][0];
  EXPECT_EQ(geometry["boundaries"][0].size(), 2u);
  EXPECT_EQ(geometry["semantics"]["values"][0].size(), 2u);
  EXPECT_EQ(file["vertices"].size(), 4u);
  EXPECT_FALSE(file["metadata"].contains("referenceSystem"));
}

TEST(ModelWriter, UnknownNameIsAUsageError) {
  EXPECT_EQ(error_of([] { open_model_writer("out.xyz", {}); }, "out.xyz").code(), ExitCode::kUsage);
}

TEST(ModelWriter, FullDiskIsAnError) {
  if (!std::filesystem::is_character_file("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  const ScratchFolder scratch;
  const std::string path = scratch.path("out.city.jsonl");
  std::filesystem::create_symlink("/dev/full", path);
  const Error error = error_of([&] { write_samples(path); }, path);
  EXPECT_EQ(error.code(), ExitCode::kCannotWrite);
}

}  // namespace
}  // namespace gable
