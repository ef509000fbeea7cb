#include <gable/engine/io/raster/raster_file.h>
#include <gable/engine/io/raster/raster_writer.h>

#include <cmath>
#include <limits>
#include <thread>

#include "engine/io/scratch.h"

namespace gable {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// 6 columns, 4 rows, 0.5 m; height = 10 row + col, one cell without.
HeightRaster sample() {
  HeightRaster raster({{1000.0, 2000.0}, 0.5, 4, 6}, 0.0f);
  for (int r = 0; r < 4; ++r) {
    for (int c = 0; c < 6; ++c) raster.at(r, c) = 10.0f * r + c;
  }
  raster.at(1, 2) = kNan;
  return raster;
}

std::string write(const ScratchFolder& scratch, const HeightRaster& raster,
                  const std::string& crs = "EPSG:28992") {
  const std::string path = scratch.path("dsm.tif");
  write_raster(path, raster, crs.empty() ? Crs() : crs_from_text(crs));
  return path;
}

/// An ASC file; `header` may be damaged.
std::string asc(const ScratchFolder& scratch, const std::string& cells,
                const std::string& header =
                    "ncols 3\nnrows 2\nxllcorner 10\nyllcorner 20\ncellsize 2\n"
                    "NODATA_value -9999\n") {
  return scratch.write("dsm.asc", header + cells);
}

RasterFileOptions with_crs(const std::string& crs) {
  RasterFileOptions options;
  options.crs = crs;
  return options;
}

Error opening_error(const std::string& path, const RasterFileOptions& options = {}) {
  return error_of([&] { RasterFile(path, options); }, path);
}

void expect_same(const HeightRaster& a, const HeightRaster& b) {
  EXPECT_EQ(a.grid, b.grid);
  ASSERT_EQ(a.values.size(), b.values.size());
  for (size_t i = 0; i < a.values.size(); ++i) {
    EXPECT_TRUE(a.values[i] == b.values[i] || (std::isnan(a.values[i]) && std::isnan(b.values[i])))
        << i << ": " << a.values[i] << " " << b.values[i];
  }
}

TEST(RasterFile, WhatIsWrittenIsReadBack) {
  const ScratchFolder scratch;
  const RasterFile file(write(scratch, sample()));
  EXPECT_EQ(file.crs().epsg, 28992);
  expect_same(file.read(), sample());
}

TEST(RasterFile, WindowsAreCutFromTheWhole) {
  const ScratchFolder scratch;
  const RasterFile file(write(scratch, sample()));
  const HeightRaster window = file.read(1, 2, 3, 4);
  EXPECT_EQ(window.grid.center_of(0, 0), sample().grid.center_of(1, 2));
  EXPECT_TRUE(std::isnan(window.at(0, 0)));
  EXPECT_EQ(window.at(2, 3), 35.0f);
}

TEST(RasterFile, WritingTwiceGivesTheSameBytes) {
  const ScratchFolder scratch;
  const std::string once = file_bytes(write(scratch, sample()));
  EXPECT_EQ(once, file_bytes(write(scratch, sample())));
  EXPECT_EQ(scratch.num_files(), 1);
}

TEST(RasterFile, InfiniteAndAbsurdHeightsAreNoHeights) {
  const ScratchFolder scratch;
  const RasterFile file(asc(scratch, "1 inf 3\n-32767 1e38 6\n"), with_crs("EPSG:27700"));
  const HeightRaster heights = file.read();
  EXPECT_EQ(file.grid(), (Grid{{10.0, 24.0}, 2.0, 2, 3}));
  EXPECT_EQ(heights.at(0, 0), 1.0f);
  EXPECT_TRUE(std::isnan(heights.at(0, 1)));
  EXPECT_TRUE(std::isnan(heights.at(1, 0)));
  EXPECT_TRUE(std::isnan(heights.at(1, 1)));
  EXPECT_EQ(heights.at(1, 2), 6.0f);
}

TEST(RasterFile, VrtScalesOffsetsAndFeetBecomeMetres) {
  const ScratchFolder scratch;
  write(scratch, sample());
  const std::string vrt = scratch.write("dsm.vrt", R"(<VRTDataset rasterXSize="6" rasterYSize="4">
    <SRS>EPSG:27700</SRS><GeoTransform>1000, 0.5, 0, 2000, 0, -0.5</GeoTransform>
    <VRTRasterBand dataType="Float32" band="1"><UnitType>ft</UnitType>
    <Offset>100</Offset><Scale>2</Scale><SimpleSource>
    <SourceFilename relativeToVRT="1">dsm.tif</SourceFilename><SourceBand>1</SourceBand>
    </SimpleSource></VRTRasterBand></VRTDataset>)");
  const RasterFile file(vrt);
  EXPECT_NEAR(file.read().at(2, 3), (2.0 * 23.0 + 100.0) * 0.3048, 1e-5);
}

TEST(RasterFile, CompoundSystemsAreAcceptedAndMatchTheirHorizontalPart) {
  const ScratchFolder scratch;
  const RasterFile file(write(scratch, sample(), "EPSG:7415"));
  EXPECT_EQ(file.crs().epsg, 7415);
  EXPECT_TRUE(same_horizontal_crs(file.crs(), crs_from_text("EPSG:28992")));
  EXPECT_FALSE(same_horizontal_crs(file.crs(), crs_from_text("EPSG:27700")));
}

TEST(RasterFile, CompoundSystemInFeetAboveMetresConvertsHeights) {
  const ScratchFolder scratch;
  const RasterFile file(write(scratch, sample(), "EPSG:6347+6360"));
  EXPECT_NEAR(file.read().at(2, 3), 23.0 * 1200.0 / 3937.0, 1e-5);
  EXPECT_EQ(file.crs().epsg, 6347);
}

TEST(RasterFile, SystemWithoutACodeIsRecognised) {
  const Crs rd = crs_from_text("EPSG:28992");
  std::string wkt = rd.wkt;
  const size_t id = wkt.rfind(",ID[\"EPSG\",28992]");
  ASSERT_NE(id, std::string::npos);
  EXPECT_EQ(crs_from_text(wkt.erase(id, 17)).epsg, 28992);
}

TEST(RasterFile, MissingFile) {
  const ScratchFolder scratch;
  EXPECT_EQ(opening_error(scratch.path("no.tif")).code(), ExitCode::kNoInput);
}

TEST(RasterFile, TextAndEmptyFilesAreNoRasters) {
  const ScratchFolder scratch;
  for (const char* text : {"", "this is a letter\n", "II*"}) {
    const Error error = opening_error(scratch.write("dsm.tif", text));
    EXPECT_EQ(error.code(), ExitCode::kBadInput);
    EXPECT_THAT(error.what(), testing::HasSubstr("is not a raster"));
  }
}

TEST(RasterFile, TruncatedRasterIsDamaged) {
  const ScratchFolder scratch;
  HeightRaster large({{0, 0}, 1.0, 600, 600}, 0.0f);
  for (size_t i = 0; i < large.values.size(); ++i) large.values[i] = std::sin(0.1f * i);
  const std::string path = write(scratch, large);
  std::filesystem::resize_file(path, std::filesystem::file_size(path) / 2);
  const Error error = error_of([&] { RasterFile(path).read(); }, path);
  EXPECT_EQ(error.code(), ExitCode::kBadInput);
}

TEST(RasterFile, AllNodata) {
  const ScratchFolder scratch;
  const Error error = opening_error(write(scratch, HeightRaster({{0, 0}, 1.0, 700, 30}, kNan)));
  EXPECT_EQ(error.code(), ExitCode::kBadInput);
  EXPECT_THAT(error.what(), testing::HasSubstr("every cell is nodata"));
}

TEST(RasterFile, OneLastHeightIsEnough) {
  const ScratchFolder scratch;
  HeightRaster raster({{0, 0}, 1.0, 700, 30}, kNan);
  raster.values.back() = 3.0f;
  EXPECT_EQ(RasterFile(write(scratch, raster)).read().values.back(), 3.0f);
}

TEST(RasterFile, OneCell) {
  const ScratchFolder scratch;
  const Error error = opening_error(write(scratch, HeightRaster({{0, 0}, 1.0, 1, 1}, 3.0f)));
  EXPECT_EQ(error.code(), ExitCode::kBadInput);
  EXPECT_THAT(error.what(), testing::HasSubstr("1 x 1 cells"));
}

TEST(RasterFile, NoReferenceSystemNamesBothRemedies) {
  const ScratchFolder scratch;
  const std::string path = write(scratch, sample(), "");
  const Error error = opening_error(path);
  EXPECT_EQ(error.code(), ExitCode::kBadInput);
  EXPECT_THAT(error.what(), testing::HasSubstr("--crs EPSG:NNNN"));
  EXPECT_THAT(error.what(), testing::HasSubstr("gdal_edit.py -a_srs EPSG:NNNN " + path));
  EXPECT_EQ(RasterFile(path, with_crs("EPSG:27700")).crs().epsg, 27700);
  EXPECT_EQ(error_of([&] { RasterFile(path, with_crs("EPSG:0")); }).code(), ExitCode::kUsage);
  EXPECT_EQ(opening_error(path, with_crs("EPSG:4326")).code(), ExitCode::kBadInput);
}

TEST(RasterFile, DegreesAreRefusedWithTheZoneToWarpTo) {
  const ScratchFolder scratch;
  HeightRaster raster = sample();
  raster.grid.north_west = {4.36, 52.0};
  raster.grid.gsd = 1e-5;
  const Error error = opening_error(write(scratch, raster, "EPSG:4326"));
  EXPECT_EQ(error.code(), ExitCode::kBadInput);
  EXPECT_THAT(error.what(), testing::HasSubstr("gdalwarp -t_srs EPSG:32631"));
}

TEST(RasterFile, FeetAreRefusedWithTheZoneToWarpTo) {
  const ScratchFolder scratch;
  HeightRaster raster = sample();
  raster.grid.north_west = {1000000.0, 200000.0};
  const Error error = opening_error(write(scratch, raster, "EPSG:2263"));
  EXPECT_EQ(error.code(), ExitCode::kBadInput);
  EXPECT_THAT(error.what(), testing::HasSubstr("US survey foot"));
  EXPECT_THAT(error.what(), testing::HasSubstr("gdalwarp -t_srs EPSG:32618"));
}

TEST(RasterFile, TurnedSkewedFlippedAndOblongGridsAreRefused) {
  const ScratchFolder scratch;
  write(scratch, sample());
  const std::pair<const char*, const char*> cases[] = {
      {"1000, 0.4, 0.3, 2000, 0.3, -0.4", "is turned"},
      {"1000, 0.5, 0, 2000, 0, 0.5", "do not run from north to south"},
      {"1000, 0.5, 0, 2000, 0, -0.75", "-tr 0.5 0.5"},
  };
  for (const auto& [transform, expected] : cases) {
    const Error error = opening_error(
        scratch.write("dsm.vrt", std::string(R"(<VRTDataset rasterXSize="6" rasterYSize="4">
        <SRS>EPSG:27700</SRS><GeoTransform>)") +
                                     transform + R"(</GeoTransform>
        <VRTRasterBand dataType="Float32" band="1"><SimpleSource>
        <SourceFilename relativeToVRT="1">dsm.tif</SourceFilename><SourceBand>1</SourceBand>
        </SimpleSource></VRTRasterBand></VRTDataset>)"));
    EXPECT_EQ(error.code(), ExitCode::kBadInput);
    EXPECT_THAT(error.what(), testing::HasSubstr(expected));
    EXPECT_THAT(error.what(), testing::HasSubstr("gdalwarp"));
  }
}

TEST(RasterFile, SeveralBandsAreRefused) {
  const ScratchFolder scratch;
  const std::string path = scratch.write("photo.ppm", "P6 2 2 255\n123123123123");
  const Error error = opening_error(path);
  EXPECT_EQ(error.code(), ExitCode::kBadInput);
  EXPECT_THAT(error.what(), testing::HasSubstr("gdal_translate -b 1"));
}

TEST(RasterFile, TerrainOnAnotherGridIsResampledOntoTheSurface) {
  const ScratchFolder scratch;
  HeightRaster plane({{990.0, 2010.0}, 2.0, 20, 20}, 0.0f);
  for (int r = 0; r < 20; ++r) {
    for (int c = 0; c < 20; ++c) {
      const Eigen::Vector2d p = plane.grid.center_of(r, c);
      plane.at(r, c) = static_cast<float>(0.5 * (p.x() - 1000.0) - 0.25 * (p.y() - 2000.0));
    }
  }
  const RasterFile file(write(scratch, plane));
  const HeightRaster onto = file.read_onto(sample().grid);
  EXPECT_EQ(onto.grid, sample().grid);
  for (int r = 0; r < 4; ++r) {
    for (int c = 0; c < 6; ++c) {
      const Eigen::Vector2d p = onto.grid.center_of(r, c);
      EXPECT_NEAR(onto.at(r, c), 0.5 * (p.x() - 1000.0) - 0.25 * (p.y() - 2000.0), 1e-5);
    }
  }
  expect_same(file.read_onto(plane.grid), plane);
  EXPECT_TRUE(std::isnan(file.read_onto({{0, 0}, 1.0, 2, 2}).at(0, 0)));
}

TEST(RasterFile, SurfaceAndTerrainMustMatch) {
  const ScratchFolder scratch;
  HeightRaster far = sample();
  far.grid.north_west.x() += 3.0;
  const auto put = [&](const char* name, const HeightRaster& raster, const char* crs) {
    write_raster(scratch.path(name), raster, crs_from_text(crs));
    return RasterFile(scratch.path(name));
  };
  const RasterFile dsm = put("dsm.tif", sample(), "EPSG:28992");
  const RasterFile same = put("same.tif", sample(), "EPSG:7415");
  const RasterFile other = put("other.tif", sample(), "EPSG:27700");
  const RasterFile beside = put("beside.tif", far, "EPSG:28992");
  EXPECT_NO_THROW(require_matching(dsm, same));
  const Error crs = error_of([&] { require_matching(dsm, other); }, "other.tif");
  EXPECT_EQ(crs.code(), ExitCode::kBadInput);
  EXPECT_THAT(crs.what(), testing::HasSubstr("gdalwarp -t_srs EPSG:28992"));
  const Error extent = error_of([&] { require_matching(dsm, beside); }, "beside.tif");
  EXPECT_EQ(extent.code(), ExitCode::kBadInput);
  EXPECT_THAT(extent.what(), testing::HasSubstr("does not overlap"));
}

TEST(RasterFile, ReadingFromTwoThreadsGivesTheSame) {
  const ScratchFolder scratch;
  HeightRaster large({{0, 0}, 1.0, 512, 512}, 0.0f);
  for (size_t i = 0; i < large.values.size(); ++i) large.values[i] = i % 977;
  const RasterFile file(write(scratch, large));
  const auto check = [&] {
    for (int i = 0; i < 50; ++i) {
      const HeightRaster window = file.read(7 * i, 3 * i, 100, 100);
      ASSERT_EQ(window.at(99, 99), large.at(7 * i + 99, 3 * i + 99));
    }
  };
  std::thread other(check);
  check();
  other.join();
}

TEST(RasterWriter, UnwritableFolderAndFullDisk) {
  const ScratchFolder scratch;
  const std::string path = scratch.path("none/dsm.tif");
  EXPECT_EQ(error_of([&] { write_raster(path, sample(), {}); }, path).code(),
            ExitCode::kCannotWrite);
  if (!std::filesystem::is_character_file("/dev/full")) return;
  EXPECT_EQ(error_of([&] { write_raster("/dev/full", sample(), {}); }, "/dev/full").code(),
            ExitCode::kCannotWrite);
}

}  // namespace
}  // namespace gable
