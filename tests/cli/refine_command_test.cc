#include <gable/engine/io/models/build_model.h>
#include <gable/engine/io/models/building_file.h>
#include <gable/engine/io/models/model_writer.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>

#include "cli/village_folder.h"

namespace gable {
namespace {

/// Moves every house by a metre, turns it by three degrees, and lifts its roofs by half a metre.
void write_disturbed(std::vector<Building> buildings, const std::string& path) {
  ModelWriterOptions options;
  options.crs = crs_from_text("EPSG:27700");
  options.anchor = buildings.front().house->origin;
  const std::unique_ptr<ModelWriter> writer = open_model_writer(path, options);
  for (Building& building : buildings) {
    building.house->origin += Eigen::Vector3d(0.8, -0.6, 0.0);
    building.house->azimuth[0] += 3.0 * M_PI / 180.0;
    for (Rule& roof : building.house->roofs) roof[0] += 0.5;
    writer->append(building, build_model(building));
  }
  writer->close();
}

TEST(RefineCommand, DisturbedHousesComeBack) {
  const VillageFolder village;
  const std::string start = village.path("start.city.jsonl");
  const std::string out = village.path("out.city.jsonl");
  const std::vector<Building> truth = read_buildings(village.truth()).buildings;
  write_disturbed(truth, start);
  const ProgramRun run = run_gable(
      {"refine", village.dsm(), "--dtm", village.dtm(), "--init", start, "-o", out, "--quiet"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const std::vector<Building> refined = read_buildings(out).buildings;
  ASSERT_EQ(refined.size(), truth.size());
  for (size_t i = 0; i < truth.size(); ++i) {
    EXPECT_EQ(refined[i].id, truth[i].id);
    EXPECT_EQ(refined[i].reason, "");
    // The truth's own figure is its fit to the noisy heights over the whole model.
    EXPECT_LT(refined[i].quality.mad, truth[i].quality.mad + 0.1) << truth[i].id;
    EXPECT_EQ(refined[i].deviations.size(), refined[i].house->derivation().size());
  }
}

TEST(RefineCommand, AFileThatIsNoModelIsRefused) {
  const VillageFolder village(1);
  const std::string out = village.path("out.city.jsonl");
  const ProgramRun run = run_gable(
      {"refine", village.dsm(), "--dtm", village.dtm(), "--init", village.dsm(), "-o", out});
  EXPECT_EQ(run.exit_code, 4);
  EXPECT_EQ(num_lines(run.err), 1) << run.err;
  EXPECT_EQ(village.num_files(), 1);
}

}  // namespace
}  // namespace gable
