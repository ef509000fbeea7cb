#include <gable/engine/io/models/building_file.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <set>
#include <string>

#include "cli/village_folder.h"
#include "engine/detectors/tiny_nets.h"

namespace gable {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::set<std::string> ids_of(const std::vector<Building>& buildings) {
  std::set<std::string> ids;
  for (const Building& building : buildings) ids.insert(building.id);
  return ids;
}

TEST(ReconstructCommand, EveryFootprintComesOutUnderItsId) {
  const VillageFolder village;
  const std::string out = village.path("out.city.jsonl");
  const ProgramRun run =
      run_gable({"reconstruct", village.dsm(), "--dtm", village.dtm(), "--footprints",
                 village.footprints(), "-o", out, "--obj", village.path("out.obj"), "--glb",
                 village.path("out.glb"), "--report", village.path("report"), "--quiet"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.out + run.err, "");
  const BuildingFile file = read_buildings(out);
  EXPECT_EQ(ids_of(file.buildings), ids_of(read_buildings(village.truth()).buildings));
  EXPECT_EQ(file.epsg, 27700);
  for (const Building& building : file.buildings) {
    EXPECT_EQ(building.status, BuildingStatus::kGrammar) << building.id << building.reason;
    EXPECT_LT(building.quality.mad, 0.4) << building.id;
    EXPECT_LE(building.base, 0.0) << building.id;
  }
  EXPECT_THAT(file_bytes(village.path("out.obj")), HasSubstr("\nf "));
  EXPECT_EQ(file_bytes(village.path("out.glb")).substr(0, 4), "glTF");
  EXPECT_TRUE(std::filesystem::exists(village.path("report/index.html")));
}

TEST(ReconstructCommand, WithoutFootprintsTheSameHousesAreFound) {
  const VillageFolder village;
  const std::string out = village.path("out.city.json");
  const ProgramRun run =
      run_gable({"reconstruct", village.dsm(), "--dtm", village.dtm(), "-o", out, "--quiet"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const ProgramRun judged = run_gable({"evaluate", out, "--dsm", village.dsm(), "--dtm",
                                       village.dtm(), "--truth", village.truth()});
  EXPECT_EQ(judged.exit_code, 0) << judged.err;
  EXPECT_THAT(judged.out, HasSubstr("4, 4 matched, 0 missed; 0 invented")) << judged.out;
}

TEST(ReconstructCommand, WithoutTerrainOneIsDerivedAndSaidSo) {
  const VillageFolder village;
  const std::string out = village.path("out.city.jsonl");
  const ProgramRun run = run_gable({"reconstruct", village.dsm(), "-o", out});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("the terrain is derived"));
  EXPECT_EQ(read_buildings(out).buildings.size(), 4u);
}

TEST(ReconstructCommand, TheSpreadOfHeightsIsToldUnlessGiven) {
  const VillageFolder village;
  const auto models = [&](const std::vector<std::string>& more) {
    const std::string out = village.path("spread.city.jsonl");
    std::vector<std::string> arguments = {"reconstruct", village.dsm(), "--dtm",  village.dtm(),
                                          "-o",          out,           "--quiet"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const ProgramRun run = run_gable(arguments);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return file_bytes(out);
  };
  EXPECT_EQ(models({}), models({"--spread", "0"})) << "its heights are of single surfaces";
  EXPECT_NE(models({}), models({"--spread", "1.5"}));
  const ProgramRun told = run_gable({"reconstruct", village.dsm(), "--dtm", village.dtm(), "-o",
                                     village.path("told.city.jsonl"), "--spread", "1.5"});
  EXPECT_THAT(told.err, HasSubstr("surface heights are means over 1.50 m, as given"));
  const ProgramRun refused = run_gable(
      {"reconstruct", village.dsm(), "-o", village.path("no.city.jsonl"), "--spread", "-1"});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.err, HasSubstr("--spread"));
}

TEST(ReconstructCommand, OneAndTwoThreadsGiveTheSameBytes) {
  const VillageFolder village;
  for (const std::string threads : {"1", "2"}) {
    const ProgramRun run =
        run_gable({"reconstruct", village.dsm(), "--dtm", village.dtm(), "-o",
                   village.path(threads + ".city.jsonl"), "--obj", village.path(threads + ".obj"),
                   "--glb", village.path(threads + ".glb"), "--threads", threads, "--quiet"});
    ASSERT_EQ(run.exit_code, 0) << run.err;
  }
  for (const std::string end : {".city.jsonl", ".obj", ".glb"}) {
    const std::string bytes = file_bytes(village.path("1" + end));
    EXPECT_FALSE(bytes.empty()) << end;
    EXPECT_TRUE(bytes == file_bytes(village.path("2" + end))) << end;
  }
  EXPECT_THAT(file_bytes(village.path("1.city.jsonl")), Not(HasSubstr("gable_time_ms")));
}

/// Sets GABLE_MODELS for the programs that are run, until it is dropped.
class ModelsIn {
 public:
  explicit ModelsIn(const std::string& folder) { setenv("GABLE_MODELS", folder.c_str(), 1); }
  ~ModelsIn() { unsetenv("GABLE_MODELS"); }
};

TEST(ReconstructCommand, WithoutDetectorsNoModelFileIsNeeded) {
  const VillageFolder village(1);
  std::filesystem::create_directory(village.path("models"));
  const ModelsIn models(village.path("models"));
  const std::string out = village.path("out.city.jsonl");
  const ProgramRun run = run_gable({"reconstruct", village.dsm(), "--dtm", village.dtm(), "-o", out,
                                    "--no-detectors", "--quiet"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.out + run.err, "");
  EXPECT_EQ(read_buildings(out).buildings.size(), 1u);
}

TEST(ReconstructCommand, InstalledDetectorsAreUsedUnlessForbidden) {
  const VillageFolder village(1);
  std::filesystem::create_directories(village.path("models/detectors"));
  village.write("models/detectors/house.onnx", "no network");
  const ModelsIn models(village.path("models"));
  const std::vector<std::string> arguments = {
      "reconstruct", village.dsm(), "--dtm", village.dtm(), "-o", village.path("out.city.jsonl"),
      "--quiet"};
  const ProgramRun used = run_gable(arguments);
  EXPECT_EQ(used.exit_code, 4);
  EXPECT_THAT(used.err, HasSubstr("models/detectors/house.onnx"));
  std::vector<std::string> forbidden = arguments;
  forbidden.push_back("--no-detectors");
  EXPECT_EQ(run_gable(forbidden).exit_code, 0);
}

TEST(ReconstructCommand, DetectorsOfAnyFolderGiveTheSameBytesOnAnyNumberOfThreads) {
  const VillageFolder village(3);
  write_tiny_nets(village);
  for (const std::string threads : {"1", "3"}) {
    const ProgramRun run = run_gable({"reconstruct", village.dsm(), "--dtm", village.dtm(), "-o",
                                      village.path(threads + ".city.jsonl"), "--detectors",
                                      village.path(""), "--threads", threads, "--quiet"});
    ASSERT_EQ(run.exit_code, 0) << run.err;
  }
  const std::string bytes = file_bytes(village.path("1.city.jsonl"));
  EXPECT_FALSE(bytes.empty());
  EXPECT_TRUE(bytes == file_bytes(village.path("3.city.jsonl")));
}

TEST(ReconstructCommand, BuildingsAreExplainedOnRequestAndNoOthers) {
  const VillageFolder village(3);
  const std::string out = village.path("out.city.jsonl");
  const std::vector<std::string> arguments = {
      "reconstruct", village.dsm(), "--dtm", village.dtm(), "-o", out, "--no-detectors", "--quiet"};
  ASSERT_EQ(run_gable(arguments).exit_code, 0);
  const std::string bytes = file_bytes(out);
  const std::vector<Building> buildings = read_buildings(out).buildings;
  ASSERT_EQ(buildings.size(), 3u);
  std::vector<std::string> asking = arguments;
  asking.insert(asking.end(), {"--explain", buildings[2].id, "--explain", buildings[0].id});
  const ProgramRun run = run_gable(asking);
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  EXPECT_TRUE(run.out.starts_with(buildings[0].id + "\n")) << run.out;
  EXPECT_THAT(run.out, HasSubstr("\n\n" + buildings[2].id + "\n"));
  EXPECT_THAT(run.out, Not(HasSubstr(buildings[1].id)));
  EXPECT_THAT(run.out, HasSubstr("finalists by J"));
  EXPECT_THAT(run.out, HasSubstr(", 0 from the detectors, "));
  EXPECT_THAT(run.out, HasSubstr("outcome: a house of the grammar"));
  EXPECT_TRUE(file_bytes(out) == bytes);
}

TEST(ReconstructCommand, DetectorsThatAreAskedAreExplained) {
  const VillageFolder village(1);
  write_tiny_nets(village);
  const std::string out = village.path("out.city.jsonl");
  const std::string id = read_buildings(village.truth()).buildings[0].id;
  const ProgramRun run = run_gable({"reconstruct", village.dsm(), "--dtm", village.dtm(),
                                    "--footprints", village.footprints(), "-o", out, "--detectors",
                                    village.path(""), "--explain", id, "--quiet"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("the detectors' probabilities of the foundation: I 0."));
}

TEST(ReconstructCommand, AnIdToExplainThatNoBuildingHasIsNamedAfterTheModelsAreWritten) {
  const VillageFolder village(1);
  const std::string out = village.path("out.city.jsonl");
  const ProgramRun run = run_gable({"reconstruct", village.dsm(), "--dtm", village.dtm(), "-o", out,
                                    "--no-detectors", "--explain", "nowhere", "--quiet"});
  EXPECT_EQ(run.exit_code, 4);
  EXPECT_EQ(run.out, "");
  EXPECT_THAT(run.err, HasSubstr("--explain nowhere: no building has this id"));
  EXPECT_EQ(read_buildings(out).buildings.size(), 1u);
}

TEST(ReconstructCommand, TimesAreWrittenOnRequest) {
  const VillageFolder village(1);
  const std::string out = village.path("out.city.jsonl");
  const ProgramRun run = run_gable(
      {"reconstruct", village.dsm(), "--dtm", village.dtm(), "-o", out, "--times", "--quiet"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(file_bytes(out), HasSubstr("gable_time_ms"));
}

}  // namespace
}  // namespace gable
