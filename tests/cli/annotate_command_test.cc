#include <gable/engine/error.h>
#include <gable/engine/io/answers/annotations_file.h>
#include <gable/engine/io/answers/answers_file.h>
#include <gable/engine/io/models/building_file.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>

#include "cli/village_folder.h"

namespace gable {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

class AnnotateCommand : public testing::Test {
 protected:
  ProgramRun propose(const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments = {"annotate", village_.dsm(), "--dtm",  village_.dtm(),
                                          "-o",       folder(),       "--quiet"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_gable(arguments);
  }

  void expect_refused(const ProgramRun& run, ExitCode code, const std::string& said) {
    EXPECT_EQ(run.exit_code, static_cast<int>(code)) << run.err;
    EXPECT_THAT(run.err, StartsWith("gable: "));
    EXPECT_THAT(run.err, HasSubstr(said));
    EXPECT_EQ(num_lines(run.err), 1) << run.err;
  }

  std::string folder() const { return village_.path("sheets"); }
  std::string list() const { return folder() + "/answers.json"; }
  bool exists(const std::string& path) const { return std::filesystem::exists(path); }

  VillageFolder village_;
};

TEST_F(AnnotateCommand, ProposesCorrectsAndShowsTheVillage) {
  ASSERT_EQ(propose({"--footprints", village_.footprints()}).exit_code, 0);
  EXPECT_TRUE(exists(folder() + "/sheet_001.png"));
  HouseAnswers answers = read_answers(list());
  EXPECT_EQ(answers.source.crs, "EPSG:27700");
  EXPECT_EQ(answers.source.tile, "dsm.tif");
  ASSERT_EQ(answers.houses.size(), 4u);
  for (HouseAnswer& house : answers.houses) {
    EXPECT_FALSE(house.reviewed);
    house.reviewed = true;
    house.confidence = Confidence::kHigh;
  }
  answers.houses.back().reviewed = false;
  write_answers(list(), answers);

  const std::string file = village_.path("validation.json");
  const ProgramRun applied = run_gable({"annotate", "--apply", list(), "-o", file});
  ASSERT_EQ(applied.exit_code, 0) << applied.err;
  EXPECT_THAT(applied.err, HasSubstr("3 of 4 buildings"));
  const AnnotatedTile tile = read_annotations(file);
  ASSERT_EQ(tile.houses.size(), 3u);
  for (const AnnotatedHouse& house : tile.houses) {
    double nearest = 1e9;
    for (const Building& truth : read_buildings(village_.truth()).buildings) {
      nearest = std::min(nearest, (truth.house->origin.head<2>() - house.center).norm());
    }
    EXPECT_LT(nearest, 10.0) << house.id;
  }

  const ProgramRun shown = run_gable({"annotate", "--show", file, village_.dsm(), "-o",
                                      village_.path("shown"), "--columns", "1", "--rows", "1"});
  ASSERT_EQ(shown.exit_code, 0) << shown.err;
  EXPECT_TRUE(exists(village_.path("shown/sheet_003.png")));
  EXPECT_FALSE(exists(village_.path("shown/sheet_004.png")));
}

TEST_F(AnnotateCommand, WhatIsReviewedStaysWhenProposedAnew) {
  ASSERT_EQ(propose().exit_code, 0);
  HouseAnswers answers = read_answers(list());
  HouseAnswer& house = answers.houses[1];
  house.reviewed = true;
  house.confidence = Confidence::kMedium;
  house.foundation = Foundation::kI;
  house.polygon.clear();
  house.rectangles = {{1.5, 33.0, 2.5, 44.0}};
  house.roofs = {RoofType::kFlat};
  answers.houses[0].roofs.assign(answers.houses[0].roofs.size(), RoofType::kFlat);
  const std::vector<RoofType> not_reviewed = answers.houses[0].roofs;
  write_answers(list(), answers);
  ASSERT_EQ(propose().exit_code, 0);
  const HouseAnswers again = read_answers(list());
  EXPECT_EQ(again.houses[1].rectangles.at(0).x0, 1.5);
  EXPECT_TRUE(again.houses[1].reviewed);
  EXPECT_NE(again.houses[0].roofs, not_reviewed);
}

TEST_F(AnnotateCommand, OneAndTwoThreadsGiveTheSameBytes) {
  ASSERT_EQ(propose({"--threads", "1"}).exit_code, 0);
  const std::string first = file_bytes(list()), sheet = file_bytes(folder() + "/sheet_001.png");
  ASSERT_EQ(propose({"--threads", "2"}).exit_code, 0);
  EXPECT_TRUE(first == file_bytes(list()));
  EXPECT_TRUE(sheet == file_bytes(folder() + "/sheet_001.png"));
}

TEST_F(AnnotateCommand, BadInputIsOneLine) {
  expect_refused(run_gable({"annotate", "-o", folder()}), ExitCode::kUsage, "DSM");
  expect_refused(run_gable({"annotate", village_.path("no.tif"), "-o", folder()}),
                 ExitCode::kNoInput, "no.tif");
  expect_refused(run_gable({"annotate", "--apply", list(), "-o", village_.path("v.json")}),
                 ExitCode::kNoInput, "answers.json");
  expect_refused(propose({"--extent", "0", "0", "1", "1"}), ExitCode::kBadInput, "--extent");
  EXPECT_FALSE(exists(folder()));

  ASSERT_EQ(propose().exit_code, 0);
  expect_refused(run_gable({"annotate", "--apply", list(), "-o", village_.path("v.json")}),
                 ExitCode::kBadInput, "none of its 4 buildings is reviewed");
  HouseAnswers answers = read_answers(list());
  answers.houses[2].reviewed = true;
  write_answers(list(), answers);
  expect_refused(run_gable({"annotate", "--apply", list(), "-o", village_.path("v.json")}),
                 ExitCode::kBadInput, answers.houses[2].id);
  EXPECT_FALSE(exists(village_.path("v.json")));
  answers.source.tile = "other.tif";
  write_answers(list(), answers);
  expect_refused(propose(), ExitCode::kBadInput, "other.tif");
  EXPECT_EQ(read_answers(list()).source.tile, "other.tif");

  const std::string broken = village_.write("broken.json", "{\"format\":");
  expect_refused(run_gable({"annotate", "--show", broken, village_.dsm(), "-o", folder()}),
                 ExitCode::kBadInput, "broken.json");
}

}  // namespace
}  // namespace gable
