#include <gable/engine/io/models/build_model.h>
#include <gable/engine/io/models/model_writer.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "engine/io/plain_house.h"
#include "engine/io/sample_building.h"
#include "engine/io/scratch.h"

namespace gable {
namespace {

std::string write_gpkg(const std::string& path, const std::vector<Building>& buildings) {
  ModelWriterOptions options;
  options.crs = crs_from_text("EPSG:28992");
  const auto writer = open_model_writer(path, options);
  for (const Building& building : buildings) writer->append(building, build_model(building));
  writer->close();
  return path;
}

GDALDatasetUniquePtr open(const std::string& path) {
  GDALAllRegister();
  return GDALDatasetUniquePtr(GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR));
}

TEST(GeoPackageWriter, BuildingsCarryPlansAndAttributes) {
  const ScratchFolder scratch;
  Building house = plain_house();
  house.deviations.assign(house.house->derivation().size(), {});
  house.deviations[0] = {0.01};
  house.deviations[house.house->roof_block(0)] = {0.03, 0.05};
  const auto dataset = open(write_gpkg(scratch.path("a.gpkg"), {house, sample_extrusion("2")}));
  ASSERT_TRUE(dataset);
  OGRLayer* layer = dataset->GetLayerByName("buildings");
  ASSERT_TRUE(layer);
  EXPECT_EQ(wkbFlatten(layer->GetGeomType()), wkbMultiPolygon);
  EXPECT_STREQ(layer->GetSpatialRef()->GetAuthorityCode(nullptr), "28992");
  ASSERT_EQ(layer->GetFeatureCount(), 2);
  const OGRFeatureUniquePtr first(layer->GetNextFeature()), second(layer->GetNextFeature());
  EXPECT_STREQ(first->GetFieldAsString("id"), "1");
  EXPECT_STREQ(first->GetFieldAsString("gable_status"), "grammar");
  EXPECT_STREQ(first->GetFieldAsString("gable_roofs"), "gable");
  EXPECT_FALSE(first->IsFieldSetAndNotNull(first->GetFieldIndex("gable_reason")));
  EXPECT_NEAR(first->GetFieldAsDouble("gable_ridge_m"), 5.5, 1e-9);
  EXPECT_EQ(first->GetFieldAsInteger("gable_garages"), 1);
  EXPECT_NEAR(first->GetFieldAsDouble("gable_azimuth_sd_deg"), 0.01 * 180 / M_PI, 1e-9);
  EXPECT_NEAR(first->GetFieldAsDouble("gable_eaves_sd_m"), 0.03, 1e-12);
  EXPECT_NEAR(first->GetFieldAsDouble("gable_plan_area_m2"), 98.0, 1e-6);
  // The house, the garage, and the chimney above the slope.
  EXPECT_NEAR(first->GetFieldAsDouble("gable_volume_m3"), 360.0 + 54.0 + 2.0, 1e-3);
  const auto derivation = nlohmann::json::parse(first->GetFieldAsString("gable_derivation"));
  EXPECT_EQ(derivation["foundation"], "I");
  const OGRMultiPolygon* plan = first->GetGeometryRef()->toMultiPolygon();
  EXPECT_EQ(plan->getNumGeometries(), 1);  // house and garage touch
  EXPECT_NEAR(plan->get_Area(), 98.0, 1e-6);
  OGREnvelope box;
  plan->getEnvelope(&box);
  EXPECT_NEAR(box.MinX, 995.0, 1e-6);
  EXPECT_NEAR(box.MaxY, 2004.0, 1e-6);
  EXPECT_STREQ(second->GetFieldAsString("gable_foundation"), "C");
  EXPECT_STREQ(second->GetFieldAsString("gable_reason"), "its outline has a courtyard");
  EXPECT_NEAR(second->GetGeometryRef()->toMultiPolygon()->get_Area(), 100.0 - 9.15, 1e-6);
}

TEST(GeoPackageWriter, RoofsCarrySlopeAspectAndTheAreaThatIsSeen) {
  const ScratchFolder scratch;
  Building house = plain_house();  // the ridge runs east, 4 m from the eaves and 2 m above them
  house.house->garages.clear();
  house.house->chimneys[0].values = {0.0, 2.0, 1.0, 6.0};
  const auto dataset = open(write_gpkg(scratch.path("a.gpkg"), {house}));
  OGRLayer* layer = dataset->GetLayerByName("roofs");
  ASSERT_TRUE(layer);
  EXPECT_TRUE(OGR_GT_HasZ(layer->GetGeomType()));
  ASSERT_EQ(layer->GetFeatureCount(), 3);
  const double stretch = std::sqrt(1.25);
  double north = 0.0, south = 0.0;
  for (const OGRFeatureUniquePtr& roof : layer) {
    EXPECT_STREQ(roof->GetFieldAsString("building"), "1");
    const double slope = roof->GetFieldAsDouble("slope_deg");
    const OGRPolygon* polygon = *roof->GetGeometryRef()->toMultiPolygon()->begin();
    if (std::string(roof->GetFieldAsString("part")) == "chimney-1") {
      EXPECT_NEAR(slope, 0.0, 1e-6);
      EXPECT_FALSE(roof->IsFieldSetAndNotNull(roof->GetFieldIndex("aspect_deg")));
      EXPECT_NEAR(polygon->getExteriorRing()->getZ(0), 16.0, 1e-6);
      continue;
    }
    EXPECT_STREQ(roof->GetFieldAsString("part"), "main-1");
    EXPECT_NEAR(slope, std::atan(0.5) * 180 / M_PI, 1e-6);
    const double aspect = roof->GetFieldAsDouble("aspect_deg");
    (std::abs(aspect - 180.0) < 1.0 ? south : north) = roof->GetFieldAsDouble("area_m2");
    EXPECT_NEAR(std::remainder(aspect, 180.0), 0.0, 1e-6);
    for (const OGRPoint& p : *polygon->getExteriorRing()) {
      EXPECT_NEAR(p.getZ(), 10.0 + 3.0 + 0.5 * (4.0 - std::abs(p.getY() - 2000.0)), 1e-6);
    }
  }
  // The chimney of 1 m2 stands on the north side.
  EXPECT_NEAR(south, 40.0 * stretch, 1e-6);
  EXPECT_NEAR(north, 39.0 * stretch, 1e-6);
}

TEST(GeoPackageWriter, TheSameModelsGiveTheSameBytes) {
  const ScratchFolder scratch;
  const std::vector<Building> buildings = {plain_house(), sample_extrusion("2")};
  const std::string bytes = file_bytes(write_gpkg(scratch.path("a.gpkg"), buildings));
  EXPECT_EQ(bytes.substr(0, 15), "SQLite format 3");
  EXPECT_EQ(bytes, file_bytes(write_gpkg(scratch.path("b.gpkg"), buildings)));
  EXPECT_EQ(scratch.num_files(), 2);
}

TEST(GeoPackageWriter, NoBuildingsStillMakeTables) {
  const ScratchFolder scratch;
  const auto dataset = open(write_gpkg(scratch.path("a.gpkg"), {}));
  ASSERT_TRUE(dataset);
  ASSERT_EQ(dataset->GetLayerCount(), 2);
  EXPECT_GE(dataset->GetLayer(0)->GetLayerDefn()->GetFieldIndex("gable_reason"), 0);
}

TEST(GeoPackageWriter, AFolderThatDoesNotExistIsNamedAtOnce) {
  const ScratchFolder scratch;
  const std::string path = scratch.path("none/a.gpkg");
  EXPECT_EQ(error_of([&] { open_model_writer(path, {}); }, path).code(), ExitCode::kCannotWrite);
}

}  // namespace
}  // namespace gable
