#include <gable/engine/io/models/add_roof_slabs.h>
#include <gable/engine/io/models/build_model.h>
#include <gable/engine/io/models/model_writer.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "engine/io/plain_house.h"
#include "engine/io/sample_building.h"
#include "engine/io/scratch.h"

namespace gable {
namespace {

/// In the Netherlands.
Building house_on_the_map(const std::string& id) {
  Building building = plain_house();
  building.id = id;
  building.house->origin = {85000.0, 447500.0, 12.5};
  return building;
}

std::string write_kml(const std::string& path, const std::vector<Building>& buildings,
                      bool on_terrain = false) {
  ModelWriterOptions options;
  options.crs = crs_from_text("EPSG:28992");
  options.kml_on_terrain = on_terrain;
  const auto writer = open_model_writer(path, options);
  for (const Building& building : buildings) writer->append(building, build_model(building));
  writer->close();
  return path;
}

/// Numbers between <coordinates> tags, in threes.
std::vector<Eigen::Vector3d> coordinates(const std::string& text) {
  std::vector<Eigen::Vector3d> points;
  const std::string open = "<coordinates>";
  for (size_t at = text.find(open); at != std::string::npos; at = text.find(open, at + 1)) {
    const char* p = text.c_str() + at + open.size();
    while (*p != '<') {
      Eigen::Vector3d& point = points.emplace_back();
      int used = 0;
      if (std::sscanf(p, "%lf,%lf,%lf%n", &point.x(), &point.y(), &point.z(), &used) != 3) {
        ADD_FAILURE() << std::string(p, 30);
        return points;
      }
      p += used;
      while (*p == ' ') ++p;
    }
  }
  return points;
}

TEST(KmlWriter, VerticesComeBackToTheMapWithinACentimetre) {
  const ScratchFolder scratch;
  const Building building = house_on_the_map("1");
  const std::vector<Eigen::Vector3d> points =
      coordinates(file_bytes(write_kml(scratch.path("a.kml"), {building})));
  ASSERT_GT(points.size(), 60u);
  OGRSpatialReference globe, map;
  globe.SetWellKnownGeogCS("WGS84");
  globe.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  map.importFromEPSG(28992);
  map.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  const std::unique_ptr<OGRCoordinateTransformation> back(
      OGRCreateCoordinateTransformation(&globe, &map));
  const BuildingModel model = build_model(building);
  for (const Eigen::Vector3d& point : points) {
    EXPECT_NEAR(point.x(), 4.38, 0.02);  // longitude comes first
    EXPECT_NEAR(point.y(), 52.01, 0.02);
    Eigen::Vector3d world = point;
    ASSERT_TRUE(back->Transform(1, &world.x(), &world.y()));
    double nearest = 1e9;
    for (const PartModel& part : model.parts) {
      for (const Eigen::Vector3d& p : finest_solid(part).vertices) {
        nearest = std::min(nearest, (model.origin + p - world).norm());
      }
    }
    EXPECT_LT(nearest, 0.01);
  }
}

TEST(KmlWriter, AViewerFindsFoldersPlacemarksAttributesAndPolygonsInSpace) {
  const ScratchFolder scratch;
  Building second = sample_extrusion("<&\">");
  const std::string path = write_kml(scratch.path("a.kml"), {house_on_the_map("house 1"), second});
  GDALAllRegister();
  const GDALDatasetUniquePtr dataset(GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR));
  ASSERT_TRUE(dataset);
  ASSERT_EQ(dataset->GetLayerCount(), 2);
  EXPECT_STREQ(dataset->GetLayer(0)->GetName(), "house 1");
  std::map<std::string, int> names;
  double area = 0.0;
  for (const OGRFeatureUniquePtr& feature : dataset->GetLayer(0)) {
    ++names[feature->GetFieldAsString("Name")];
    const OGRGeometry* geometry = feature->GetGeometryRef();
    ASSERT_TRUE(geometry);
    EXPECT_TRUE(OGR_GT_HasZ(geometry->getGeometryType()));
    area += geometry->IsEmpty() ? 0.0 : 1.0;
    if (feature->GetFieldIndex("gable_foundation") >= 0) {  // the driver that reads attributes
      EXPECT_STREQ(feature->GetFieldAsString("gable_foundation"), "I");
      EXPECT_NEAR(feature->GetFieldAsDouble("gable_plan_area_m2"), 80.0 + 18.0, 1e-3);
    }
  }
  EXPECT_GE(names["house 1"], 3);
  EXPECT_GT(area, 0.0);
}

TEST(KmlWriter, HeightsAreTheRastersOrAboveTheTerrain) {
  const ScratchFolder scratch;
  const auto highest = [&](bool on_terrain) {
    const std::string text =
        file_bytes(write_kml(scratch.path("a.kml"), {house_on_the_map("1")}, on_terrain));
    EXPECT_NE(text.find(on_terrain ? ">relativeToGround<" : ">absolute<"), std::string::npos);
    EXPECT_EQ(text.find(on_terrain ? ">absolute<" : ">relativeToGround<"), std::string::npos);
    double z = -1e9;
    for (const Eigen::Vector3d& p : coordinates(text)) z = std::max(z, p.z());
    return z;
  };
  EXPECT_NEAR(highest(false), 12.5 + 6.0, 1e-3);
  EXPECT_NEAR(highest(true), 6.0, 1e-3);
}

TEST(KmlWriter, TheSameModelsGiveTheSameBytesZippedOrNot) {
  const ScratchFolder scratch;
  for (const char* name : {"a.kml", "a.kmz"}) {
    const std::string once = file_bytes(write_kml(scratch.path(name), {house_on_the_map("1")}));
    EXPECT_EQ(once, file_bytes(write_kml(scratch.path(name), {house_on_the_map("1")}))) << name;
    EXPECT_FALSE(once.empty());
  }
  const std::string kml = file_bytes(scratch.path("a.kml"));
  const std::string kmz = file_bytes(scratch.path("a.kmz"));
  EXPECT_EQ(kmz.substr(0, 4), std::string("PK\x03\x04", 4));
  EXPECT_LT(kmz.size(), kml.size() / 3);
  // No time of day in the archive: its modification time and date are zero.
  EXPECT_EQ(kmz.substr(10, 4), std::string(4, '\0'));
  const std::string inside = "/vsizip/" + scratch.path("a.kmz") + "/doc.kml";
  VSILFILE* file = VSIFOpenL(inside.c_str(), "rb");
  ASSERT_TRUE(file);
  std::string text(kml.size() + 1, '\0');
  text.resize(VSIFReadL(text.data(), 1, text.size(), file));
  VSIFCloseL(file);
  EXPECT_EQ(text, kml);
}

TEST(KmlWriter, WithoutAReferenceSystemTheRemedyIsNamed) {
  const ScratchFolder scratch;
  const std::string path = scratch.path("a.kml");
  const Error error = error_of([&] { open_model_writer(path, {}); }, path);
  EXPECT_EQ(error.code(), ExitCode::kUsage);
  EXPECT_THAT(error.what(), testing::HasSubstr("--crs EPSG:NNNN"));
  EXPECT_EQ(scratch.num_files(), 0);
}

}  // namespace
}  // namespace gable
