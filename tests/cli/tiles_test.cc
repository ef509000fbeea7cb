#include <gable/engine/io/models/building_file.h>
#include <gable/engine/io/raster/raster_file.h>
#include <gable/engine/io/raster/raster_writer.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <map>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "cli/village_folder.h"

namespace gable {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

/// A village whose rasters are cut into tiles, and runs of `gable reconstruct` over them.
class Tiles : public testing::Test {
 protected:
  Tiles() {
    cut(village_.dsm(), "dsm");
    cut(village_.dtm(), "dtm");
  }

  /// Cuts a raster into 2 x 2 tiles in a folder.
  void cut(const std::string& path, const std::string& folder) const {
    fs::create_directory(village_.path(folder));
    const RasterFile file(path);
    const int rows[3] = {0, file.grid().rows / 2 + 3, file.grid().rows};
    const int cols[3] = {0, file.grid().cols / 2 - 5, file.grid().cols};
    for (int i = 0; i < 2; ++i) {
      for (int j = 0; j < 2; ++j) {
        write_raster(tile(folder, i, j),
                     file.read(rows[i], cols[j], rows[i + 1] - rows[i], cols[j + 1] - cols[j]),
                     file.crs());
      }
    }
  }

  std::string tile(const std::string& folder, int row, int col) const {
    return village_.path(folder + "/" + std::to_string(row) + std::to_string(col) + ".tif");
  }

  std::vector<std::string> arguments(const std::vector<std::string>& more) const {
    std::vector<std::string> all = {"reconstruct",     tile("dsm", 0, 0), tile("dsm", 0, 1),
                                    tile("dsm", 1, 0), tile("dsm", 1, 1), "--no-detectors",
                                    "--quiet"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }

  /// The arguments that give a folder with several windows.
  std::vector<std::string> by_window(const std::string& folder, bool resume = false) const {
    std::vector<std::string> all = arguments(
        {"--dtm-dir", village_.path("dtm"), "--window", "64", "-o", village_.path(folder) + "/"});
    if (resume) all.push_back("--resume");
    return all;
  }

  std::map<std::string, std::string> files_of(const std::string& folder) const {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::directory_iterator(village_.path(folder))) {
      files[entry.path().filename().string()] = file_bytes(entry.path().string());
    }
    return files;
  }

  void refused(const std::vector<std::string>& arguments, ExitCode code,
               const std::string& names) const {
    const ProgramRun run = run_gable(arguments);
    EXPECT_EQ(run.exit_code, static_cast<int>(code)) << run.err;
    EXPECT_THAT(run.err, HasSubstr(names));
    EXPECT_EQ(num_lines(run.err), 1) << run.err;
  }

  const VillageFolder village_;
};

TEST_F(Tiles, GiveTheBytesOfTheRasterThatTheyWereCutFrom) {
  const std::string whole = village_.path("whole.city.jsonl");
  const std::string tiles = village_.path("tiles.city.jsonl");
  ASSERT_EQ(run_gable({"reconstruct", village_.dsm(), "--dtm", village_.dtm(), "--no-detectors",
                       "--quiet", "-o", whole})
                .exit_code,
            0);
  const ProgramRun run = run_gable(arguments({"--dtm-dir", village_.path("dtm"), "-o", tiles}));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(read_buildings(whole).buildings.size(), 4u);
  EXPECT_TRUE(file_bytes(tiles) == file_bytes(whole));
}

TEST_F(Tiles, AFolderHoldsEveryBuildingOnceAndLinesOfOneFile) {
  const std::string one = village_.path("one.city.jsonl");
  ASSERT_EQ(run_gable(arguments({"--dtm-dir", village_.path("dtm"), "--window", "64", "-o", one}))
                .exit_code,
            0);
  const ProgramRun run = run_gable(by_window("models"));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.out + run.err, "");
  std::string lines;
  for (const auto& [name, bytes] : files_of("models")) {
    if (!name.starts_with("window_")) continue;
    const size_t first = bytes.find('\n') + 1;
    if (lines.empty()) lines = bytes.substr(0, first);
    EXPECT_EQ(lines.substr(0, first), bytes.substr(0, first));
    lines += bytes.substr(first);
  }
  EXPECT_TRUE(lines == file_bytes(one));
  EXPECT_EQ(read_buildings(one).buildings.size(), 4u);
}

TEST_F(Tiles, KilledAndResumedRunsGiveTheBytesOfAnUndisturbedOne) {
  ASSERT_EQ(run_gable(by_window("undisturbed")).exit_code, 0);
  std::mt19937 random(7);
  for (int i = 0; i < 3; ++i) {
    run_gable_for(0.02 + 0.001 * static_cast<double>(random() % 400), "KILL",
                  by_window("killed", true));
  }
  const ProgramRun run = run_gable(by_window("killed", true));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(files_of("killed"), files_of("undisturbed"));
}

TEST_F(Tiles, AnInterruptedRunKeepsItsWindowsAndSaysHowToGoOn) {
  // Before it watches for signals the program just ends, and it may also be done by then.
  for (double seconds = 0.1; seconds < 20.0; seconds *= 1.5) {
    const ProgramRun run = run_gable_for(seconds, "INT", by_window("models", true));
    if (run.exit_code == 0) break;
    EXPECT_EQ(run.exit_code, static_cast<int>(ExitCode::kInterrupted));
    if (run.err.empty()) continue;
    EXPECT_THAT(run.err, HasSubstr("windows are done and kept, go on with --resume"));
    break;
  }
  const ProgramRun rest = run_gable(by_window("models", true));
  ASSERT_EQ(rest.exit_code, 0) << rest.err;
  size_t num_buildings = 0;
  for (const auto& [name, bytes] : files_of("models")) {
    if (!name.starts_with("window_")) continue;
    num_buildings += read_buildings(village_.path("models/" + name)).buildings.size();
  }
  EXPECT_EQ(num_buildings, 4u);
}

TEST_F(Tiles, AFolderOfModelsIsNeitherOverwrittenNorGoneOnWithFromOtherInputs) {
  ASSERT_EQ(run_gable(by_window("models")).exit_code, 0);
  const auto before = files_of("models");
  refused(by_window("models"), ExitCode::kUsage, "--resume");
  std::vector<std::string> others = by_window("models", true);
  *std::find(others.begin(), others.end(), "64") = "128";
  refused(others, ExitCode::kUsage, "--window is \"128\", but was \"64\"");
  others = by_window("models", true);
  others.erase(others.begin() + 1);
  refused(others, ExitCode::kUsage, "cannot be resumed, the surface");
  EXPECT_EQ(files_of("models"), before);
}

TEST_F(Tiles, ThatDoNotFitAreNamed) {
  const std::string coarse = village_.path("coarse.tif"), rd = village_.path("rd.tif");
  HeightRaster heights = RasterFile(tile("dsm", 0, 0)).read();
  heights.grid.gsd = 1.0;
  write_raster(coarse, heights, crs_from_text("EPSG:27700"));
  write_raster(rd, RasterFile(tile("dsm", 0, 0)).read(), crs_from_text("EPSG:28992"));
  const std::string out = village_.path("out.city.jsonl");
  refused(arguments({coarse, "-o", out}), ExitCode::kBadInput, coarse + ": has cells of 1 m");
  refused(arguments({rd, "-o", out}), ExitCode::kBadInput, rd + ": is in Amersfoort");
  refused(arguments({village_.path("a.las"), "-o", out}), ExitCode::kUsage, "a.las");
  refused(arguments({"--dtm-dir", village_.path("nowhere"), "-o", out}), ExitCode::kNoInput,
          "nowhere");
}

TEST_F(Tiles, WhatAFolderOfModelsHasNot) {
  const std::string folder = village_.path("models/");
  refused(arguments({"-o", folder, "--obj", village_.path("a.obj")}), ExitCode::kUsage, "--obj");
  refused(arguments({"-o", folder, "--report", village_.path("r")}), ExitCode::kUsage, "--report");
  refused(arguments({"-o", folder, "--resume", "--explain", "b1_2"}), ExitCode::kUsage,
          "--explain");
  refused(arguments({"-o", village_.path("a.city.jsonl"), "--resume"}), ExitCode::kUsage,
          "--resume");
  EXPECT_FALSE(fs::exists(folder));
}

/// A LAS 1.2 file of a surface's cells, points of class 1, and of a terrain's, class 2.
std::string las_of(const HeightRaster& dsm, const HeightRaster& dtm) {
  constexpr double kStep = 0.001;
  std::string header(227, '\0'), points;
  uint32_t count = 0;
  const auto put = [&header](size_t at, auto value) {
    std::memcpy(header.data() + at, &value, sizeof value);  // both are little-endian
  };
  const Eigen::Vector2d corner = dsm.grid.north_west;
  for (const HeightRaster* raster : {&dsm, &dtm}) {
    for (int row = 0; row < raster->grid.rows; ++row) {
      for (int col = 0; col < raster->grid.cols; ++col) {
        if (std::isnan(raster->at(row, col))) continue;
        const Eigen::Vector2d at = raster->grid.center_of(row, col) - corner;
        std::string record(20, '\0');
        const int32_t x = static_cast<int32_t>(std::lround(at.x() / kStep));
        const int32_t y = static_cast<int32_t>(std::lround(at.y() / kStep));
        const int32_t z = static_cast<int32_t>(std::lround(raster->at(row, col) / kStep));
        std::memcpy(record.data(), &x, 4);
        std::memcpy(record.data() + 4, &y, 4);
        std::memcpy(record.data() + 8, &z, 4);
        record[15] = raster == &dsm ? 1 : 2;
        points += record;
        ++count;
      }
    }
  }
  header.replace(0, 4, "LASF");
  put(24, uint8_t{1});
  put(25, uint8_t{2});
  put(94, uint16_t{227});
  put(96, uint32_t{227});
  put(105, uint16_t{20});
  put(107, count);
  for (int k = 0; k < 3; ++k) put(131 + 8 * k, kStep);
  put(155, corner.x());
  put(163, corner.y());
  return header + points;
}

TEST_F(Tiles, PointsGiveTheHousesOfTheirHeights) {
  if (std::endian::native != std::endian::little) GTEST_SKIP() << "the file is written as it lies";
  const RasterFile dsm(village_.dsm()), dtm(village_.dtm());
  const std::string las = village_.write("village.las", las_of(dsm.read(), dtm.read()));
  const std::string out = village_.path("out.city.jsonl");
  const ProgramRun run = run_gable(
      {"reconstruct", las, "--crs", "EPSG:27700", "--gsd", "0.5", "--no-detectors", "-o", out});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("village.las: the surface is made of"));
  EXPECT_THAT(run.err, HasSubstr("the terrain of class 2"));
  const ProgramRun judged = run_gable({"evaluate", out, "--dsm", village_.dsm(), "--dtm",
                                       village_.dtm(), "--truth", village_.truth()});
  EXPECT_THAT(judged.out, HasSubstr("4, 4 matched, 0 missed; 0 invented")) << judged.out;
}

}  // namespace
}  // namespace gable
