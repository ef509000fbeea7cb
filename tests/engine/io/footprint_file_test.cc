#include <gable/engine/io/footprint_file.h>
#include <gable/engine/io/footprint_writer.h>

#include <cmath>
#include <cstdlib>

#include "engine/io/scratch.h"

namespace gable {
namespace {

const Grid kGrid = {{1000.0, 2100.0}, 0.5, 200, 200};  // [1000, 1100] x [2000, 2100]

Crs rd() { return crs_from_text("EPSG:28992"); }

std::vector<Eigen::Vector2d> square(double x, double y, double size) {
  return {{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}};
}

/// A GeoJSON whose coordinates are RD metres.
std::string geojson(const ScratchFolder& scratch, const std::string& features) {
  return scratch.write("fp.geojson",
                       R"({"type":"FeatureCollection","crs":{"type":"name","properties":{"name":
      "urn:ogc:def:crs:EPSG::28992"}},"features":[)" +
                           features + "]}");
}

std::string feature(const std::string& properties, const std::string& type,
                    const std::string& coordinates) {
  return R"({"type":"Feature","properties":{)" + properties + R"(},"geometry":{"type":")" + type +
         R"(","coordinates":)" + coordinates + "}}";
}

double area(const std::vector<Eigen::Vector2d>& ring) {
  double twice = 0.0;
  for (size_t i = 0; i < ring.size(); ++i) {
    const Eigen::Vector2d &a = ring[i], &b = ring[(i + 1) % ring.size()];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return std::abs(0.5 * twice);
}

Error reading_error(const std::string& path) {
  return error_of([&] { read_footprints(path, rd(), kGrid); }, path);
}

constexpr const char* kSquareText =
    "[[[1010,2010],[1020,2010],[1020,2020],[1010,2020],[1010,2010]]]";

TEST(FootprintFile, WhatIsWrittenIsReadBack) {
  const ScratchFolder scratch;
  const std::string path = scratch.path("fp.gpkg");
  const std::vector<Footprint> written = {
      {"a", {square(1010.125, 2020.25, 10), {square(1012, 2022, 3)}}},
      {"b 2", {square(1050, 2050, 8), {}}}};
  write_footprints(path, written, rd());
  const FootprintFile file = read_footprints(path, rd(), kGrid);
  ASSERT_EQ(file.footprints.size(), 2u);
  EXPECT_EQ(file.footprints[1].id, "b 2");
  EXPECT_EQ(file.footprints[1].polygon.outer.size(), 4u);
  EXPECT_EQ(area(file.footprints[0].polygon.outer), 100.0);
  ASSERT_EQ(file.footprints[0].polygon.holes.size(), 1u);
  EXPECT_EQ(area(file.footprints[0].polygon.holes[0]), 9.0);
  EXPECT_TRUE(file.skipped.empty());
  EXPECT_TRUE(file.repaired.empty());

  const std::string bytes = file_bytes(path);
  write_footprints(path, written, rd());
  EXPECT_EQ(file_bytes(path), bytes);
  EXPECT_EQ(scratch.num_files(), 1);
}

TEST(FootprintFile, EveryPartOfAMultiPolygonIsABuildingWithItsOwnId) {
  const ScratchFolder scratch;
  const std::string other = "[[[1030,2010],[1040,2010],[1040,2020],[1030,2020],[1030,2010]]]";
  const FootprintFile file = read_footprints(
      geojson(scratch, feature(R"("lokaalid":"x")", "MultiPolygon",
                               "[" + std::string(kSquareText) + "," + other + "]") +
                           "," + feature(R"("lokaalid":"x")", "Polygon", kSquareText) + "," +
                           feature(R"("lokaalid":"x-2")", "Polygon", kSquareText) + "," +
                           feature(R"("lokaalid":null)", "Polygon", kSquareText)),
      rd(), kGrid);
  ASSERT_EQ(file.footprints.size(), 5u);
  EXPECT_EQ(file.footprints[0].id, "x");
  EXPECT_EQ(file.footprints[1].id, "x-2");
  EXPECT_EQ(file.footprints[2].id, "x-3");
  EXPECT_EQ(file.footprints[3].id, "x-2-2");
  EXPECT_EQ(file.footprints[4].id, "3");
}

TEST(FootprintFile, BadFeaturesAreRepairedOrSkippedWithTheirReason) {
  const ScratchFolder scratch;
  const FootprintFile file = read_footprints(
      geojson(scratch,
              feature(R"("id":"good")", "Polygon", kSquareText) + "," +
                  // Two triangles of different size that touch where the outline crosses itself.
                  feature(R"("id":"bow tie")", "Polygon",
                          "[[[1010,2010],[1030,2040],[1030,2010],[1010,2030],[1010,2010]]]") +
                  "," +
                  feature(R"("id":"line")", "Polygon",
                          "[[[1010,2010],[1020,2010],[1030,2010],[1010,2010]]]") +
                  "," + feature(R"("id":"point")", "Point", "[1010,2010]") + "," +
                  R"({"type":"Feature","properties":{"id":"none"},"geometry":null},)" +
                  feature(R"("id":"far")", "Polygon", "[[[0,0],[10,0],[10,10],[0,0]]]")),
      rd(), kGrid);
  ASSERT_EQ(file.footprints.size(), 2u);
  EXPECT_EQ(file.footprints[0].id, "good");
  EXPECT_EQ(file.footprints[1].id, "bow tie");
  // The crossing is at (1018, 2022): the larger triangle has base 30 and height 12.
  EXPECT_NEAR(area(file.footprints[1].polygon.outer), 180.0, 1e-9);
  EXPECT_EQ(file.num_outside, 1);
  EXPECT_THAT(file.repaired, testing::ElementsAre(testing::StartsWith("bow tie: was not valid")));
  EXPECT_THAT(file.skipped, testing::ElementsAre("line: encloses no area", "point: is no polygon",
                                                 "none: has no geometry"));
}

TEST(FootprintFile, DegreesAreBroughtIntoTheRastersSystem) {
  const ScratchFolder scratch;
  // The spire of Amersfoort, origin of the Dutch grid, is at 155000 463000.
  const std::string path = scratch.write(
      "fp.geojson",
      R"({"type":"FeatureCollection","features":[)" +
          feature("", "Polygon",
                  "[[[5.3871,52.1551],[5.3873,52.1551],[5.3873,52.1553],[5.3871,52.1551]]]") +
          "]}");
  const FootprintFile file =
      read_footprints(path, crs_from_text("EPSG:7415"), {{154900.0, 463100.0}, 0.5, 500, 500});
  ASSERT_EQ(file.footprints.size(), 1u);
  EXPECT_NEAR(file.footprints[0].polygon.outer[0].x(), 155000.0, 60.0);
  EXPECT_NEAR(file.footprints[0].polygon.outer[0].y(), 463000.0, 60.0);
}

TEST(FootprintFile, FilesThatHoldNoFootprintsAreRefused) {
  const ScratchFolder scratch;
  EXPECT_EQ(reading_error(scratch.path("no.gpkg")).code(), ExitCode::kNoInput);
  EXPECT_EQ(reading_error(scratch.path("")).code(), ExitCode::kNoInput);
  EXPECT_EQ(reading_error(scratch.write("a.gpkg", "text")).code(), ExitCode::kBadInput);

  const Error points = reading_error(geojson(scratch, feature("", "Point", "[1010,2010]")));
  EXPECT_EQ(points.code(), ExitCode::kBadInput);
  EXPECT_THAT(points.what(), testing::HasSubstr("holds no polygons"));
  EXPECT_THAT(reading_error(geojson(scratch, "")).what(), testing::HasSubstr("holds no polygons"));

  const Error far =
      reading_error(geojson(scratch, feature("", "Polygon", "[[[0,0],[10,0],[10,10],[0,0]]]")));
  EXPECT_EQ(far.code(), ExitCode::kBadInput);
  EXPECT_THAT(far.what(), testing::HasSubstr("none of its polygons lies on the raster"));

  const Error flat = reading_error(
      geojson(scratch, feature("", "Polygon", "[[[1010,2010],[1020,2010],[1030,2010]]]")));
  EXPECT_EQ(flat.code(), ExitCode::kBadInput);
  EXPECT_THAT(flat.what(), testing::HasSubstr("none of its polygons can be used"));
}

TEST(FootprintFile, UnwritableFolder) {
  const ScratchFolder scratch;
  const std::string path = scratch.path("none/fp.gpkg");
  EXPECT_EQ(error_of([&] { write_footprints(path, {}, rd()); }, path).code(),
            ExitCode::kCannotWrite);
}

TEST(FootprintFile, EveryPolygonOfADutchTownIsRead) {
  const char* data = std::getenv("GABLE_DATA");
  const std::string path =
      std::string(data ? data : GABLE_SOURCE_DIR "/../shared/data") + "/delft-ahn3/footprints.gpkg";
  if (!std::filesystem::exists(path)) {
    GTEST_SKIP() << "no real data at " << path << "; set GABLE_DATA";
  }
  const FootprintFile file = read_footprints(path, rd(), {{84808.0, 447641.5}, 0.5, 458, 529});
  EXPECT_EQ(file.footprints.size() + file.skipped.size(), 160u);
  EXPECT_TRUE(file.skipped.empty());
}

}  // namespace
}  // namespace gable
