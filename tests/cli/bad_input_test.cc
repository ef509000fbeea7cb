#include <gable/engine/error.h>
#include <gable/engine/io/footprint_file.h>
#include <gable/engine/io/raster/raster_writer.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "cli/village_folder.h"

namespace gable {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

/// One slab of 10 x 10 m and 5 m height on flat ground of 32 x 32 m.
HeightRaster slab(double easting) {
  HeightRaster raster({{easting, 300000.0}, 0.5, 64, 64}, 0.0f);
  for (int row = 20; row < 40; ++row) {
    for (int col = 20; col < 40; ++col) raster.at(row, col) = 5.0f;
  }
  return raster;
}

class BadInput : public testing::Test {
 protected:
  BadInput() {
    dsm_ = folder_.path("dsm.tif");
    dtm_ = folder_.path("dtm.tif");
    write_raster(dsm_, slab(400000.0), crs_);
    write_raster(dtm_, HeightRaster(slab(400000.0).grid, 0.0f), crs_);
  }

  std::string raster(const std::string& name, const HeightRaster& heights) {
    write_raster(folder_.path(name), heights, crs_);
    return folder_.path(name);
  }

  ProgramRun reconstruct(const std::string& dsm, const std::string& dtm,
                         const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments = {"reconstruct", dsm, "--dtm", dtm, "-o", out(), "--quiet"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_gable(arguments);
  }

  /// One line that names the file, the exit code, and nothing written.
  void expect_refused(const ProgramRun& run, ExitCode code, const std::string& named) {
    EXPECT_EQ(run.exit_code, static_cast<int>(code)) << run.err;
    EXPECT_EQ(run.out, "");
    EXPECT_THAT(run.err, StartsWith("gable: "));
    EXPECT_THAT(run.err, HasSubstr(named));
    EXPECT_EQ(num_lines(run.err), 1) << run.err;
    for (const auto& entry : std::filesystem::directory_iterator(folder_.path(""))) {
      EXPECT_THAT(entry.path().filename().string(), testing::Not(StartsWith("out")));
    }
  }

  std::string out() const { return folder_.path("out.city.jsonl"); }

  const ScratchFolder folder_;
  const Crs crs_ = crs_from_text("EPSG:27700");
  std::string dsm_, dtm_;
};

TEST_F(BadInput, GoodInputPasses) {
  const ProgramRun run = reconstruct(dsm_, dtm_);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(std::filesystem::exists(out()));
}

TEST_F(BadInput, MissingFiles) {
  const std::string none = folder_.path("none.tif");
  expect_refused(reconstruct(none, dtm_), ExitCode::kNoInput, none);
  expect_refused(reconstruct(dsm_, none), ExitCode::kNoInput, none);
  expect_refused(reconstruct(dsm_, dtm_, {"--footprints", none}), ExitCode::kNoInput, none);
}

TEST_F(BadInput, FilesThatAreNoRasters) {
  const std::string text = folder_.write("text.tif", "no raster at all\n");
  const std::string empty = folder_.write("empty.tif", "");
  expect_refused(reconstruct(text, dtm_), ExitCode::kBadInput, text);
  expect_refused(reconstruct(empty, dtm_), ExitCode::kBadInput, empty);
  expect_refused(reconstruct(dsm_, text), ExitCode::kBadInput, text);
}

TEST_F(BadInput, NothingButNodata) {
  const std::string nothing = raster(
      "nothing.tif", HeightRaster(slab(400000.0).grid, std::numeric_limits<float>::quiet_NaN()));
  expect_refused(reconstruct(nothing, dtm_), ExitCode::kBadInput, nothing);
  expect_refused(reconstruct(dsm_, nothing), ExitCode::kBadInput, nothing);
}

TEST_F(BadInput, NanAndInfiniteHeightsAreCellsWithoutHeights) {
  HeightRaster heights = slab(400000.0);
  heights.at(25, 25) = std::numeric_limits<float>::quiet_NaN();
  heights.at(30, 30) = std::numeric_limits<float>::infinity();
  heights.at(5, 5) = -std::numeric_limits<float>::infinity();
  const ProgramRun run = reconstruct(raster("holes.tif", heights), dtm_);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(file_bytes(out()), HasSubstr("\"gable_status\":\"grammar\""));
}

TEST_F(BadInput, NoReferenceSystem) {
  const std::string plain = folder_.path("plain.tif");
  write_raster(plain, slab(400000.0), Crs());
  expect_refused(reconstruct(plain, dtm_), ExitCode::kBadInput, "--crs");
  const ProgramRun run = reconstruct(plain, dtm_, {"--crs", "EPSG:27700"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
}

TEST_F(BadInput, SurfaceAndTerrainThatDoNotOverlap) {
  const std::string far = raster("far.tif", slab(500000.0));
  expect_refused(reconstruct(dsm_, far), ExitCode::kBadInput, far);
}

TEST_F(BadInput, ASingleCell) {
  const std::string cell =
      raster("cell.tif", HeightRaster({{400000.0, 300000.0}, 0.5, 1, 1}, 5.0f));
  expect_refused(reconstruct(cell, dtm_), ExitCode::kBadInput, cell);
}

TEST_F(BadInput, FootprintsWithoutPolygons) {
  const std::string none = folder_.path("none.gpkg");
  write_footprints(none, {}, crs_);
  expect_refused(reconstruct(dsm_, dtm_, {"--footprints", none}), ExitCode::kBadInput, none);
}

TEST_F(BadInput, DetectorsThatAreMissingOrDamaged) {
  const std::string nowhere = folder_.path("nowhere");
  expect_refused(reconstruct(dsm_, dtm_, {"--detectors", nowhere}), ExitCode::kNoInput,
                 nowhere + "/house.onnx");
  std::filesystem::create_directory(folder_.path("nets"));
  const std::string damaged = folder_.write("nets/house.onnx", "no network");
  expect_refused(reconstruct(dsm_, dtm_, {"--detectors", folder_.path("nets")}),
                 ExitCode::kBadInput, damaged);
  expect_refused(reconstruct(dsm_, dtm_, {"--detectors", ""}), ExitCode::kUsage, "--detectors");
}

TEST_F(BadInput, DetectorsAreNamedAndForbiddenAtOnce) {
  expect_refused(reconstruct(dsm_, dtm_, {"--detectors", folder_.path(""), "--no-detectors"}),
                 ExitCode::kUsage, "--no-detectors");
}

TEST_F(BadInput, OutputsThatCannotBeWritten) {
  const std::string nowhere = folder_.path("nowhere/model.obj");
  expect_refused(reconstruct(dsm_, dtm_, {"--obj", nowhere}), ExitCode::kCannotWrite, nowhere);
  expect_refused(reconstruct(dsm_, dtm_, {"--report", "/dev/null/report"}), ExitCode::kCannotWrite,
                 "/dev/null/report");
}

TEST_F(BadInput, AFullDisk) {
  const std::string full = folder_.path("full.obj");
  std::filesystem::create_symlink("/dev/full", full);
  expect_refused(reconstruct(dsm_, dtm_, {"--obj", full}), ExitCode::kCannotWrite, full);
}

TEST_F(BadInput, OutputsOfUnknownKinds) {
  expect_refused(reconstruct(dsm_, dtm_, {"--obj", folder_.path("out.ply")}), ExitCode::kUsage,
                 "out.ply");
}

}  // namespace
}  // namespace gable
