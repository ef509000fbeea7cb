#include <gable/engine/io/models/building_file.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/village_folder.h"

namespace gable {
namespace {

using ::testing::HasSubstr;

std::vector<std::string> refine(const VillageFolder& village, const std::string& out,
                                const std::vector<std::string>& more) {
  std::vector<std::string> arguments = {"refine",      village.dsm(), "--dtm",
                                        village.dtm(), "--init",      village.truth(),
                                        "-o",          out,           "--quiet"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

TEST(ModelOutputs, RoofSlabsAreAddedToEveryHouseAndLeaveTheRestAsItIs) {
  const VillageFolder village(2);
  const std::string plain = village.path("a.city.json"), thick = village.path("b.city.json");
  ASSERT_EQ(run_gable(refine(village, plain, {})).exit_code, 0);
  const ProgramRun run =
      run_gable(refine(village, thick, {"--thickness", "0.35", "--overhang", "0.15"}));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto before = nlohmann::json::parse(file_bytes(plain))["CityObjects"];
  const auto after = nlohmann::json::parse(file_bytes(thick))["CityObjects"];
  int slabs = 0;
  for (const auto& [id, object] : after.items()) slabs += id.find("-roof-") != std::string::npos;
  EXPECT_GE(slabs, 2);
  for (const auto& [id, object] : before.items()) {
    ASSERT_TRUE(after.contains(id));
    EXPECT_EQ(after[id].value("attributes", nlohmann::json()),
              object.value("attributes", nlohmann::json()));
  }
}

TEST(ModelOutputs, GlobeAndGisFilesAppearWithTheModels) {
  const VillageFolder village(2);
  const std::string kmz = village.path("a.kmz"), gpkg = village.path("a.gpkg");
  const ProgramRun run =
      run_gable(refine(village, village.path("a.city.jsonl"), {"--kml", kmz, "--gpkg", gpkg}));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(file_bytes(kmz).substr(0, 2), "PK");
  EXPECT_EQ(file_bytes(gpkg).substr(0, 15), "SQLite format 3");
}

TEST(ModelOutputs, WhatCannotBeDoneIsRefusedBeforeAnythingIsWritten) {
  const VillageFolder village(1);
  const std::string out = village.path("out.city.jsonl");
  const struct {
    std::vector<std::string> options;
    std::string line;
  } cases[] = {{{"--overhang", "0.2"}, "an overhang needs a thickness"},
               {{"--thickness", "3"}, "thickness must be 0 or lie in [0.05, 1] m"},
               {{"--kml", village.path("a.xml")}, "end the name with .kml or .kmz"},
               {{"--gpkg", village.path("a.db")}, "end the name with .gpkg"}};
  for (const auto& [options, line] : cases) {
    const ProgramRun run = run_gable(refine(village, out, options));
    EXPECT_EQ(run.exit_code, 2) << line;
    EXPECT_EQ(num_lines(run.err), 1) << run.err;
    EXPECT_THAT(run.err, HasSubstr(line));
    EXPECT_EQ(village.num_files(), 1) << line;
  }
}

}  // namespace
}  // namespace gable
