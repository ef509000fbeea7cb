#include <gable/engine/error.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "cli/village_folder.h"

namespace gable {
namespace {

using ::testing::HasSubstr;

TEST(LabelCommand, WritesShardsOfWhatReconstructionIsSureOf) {
  const VillageFolder village;
  const std::string folder = village.path("crops");
  const ProgramRun run =
      run_gable({"label", village.dsm(), "--dtm", village.dtm(), "--footprints",
                 village.footprints(), "--no-detectors", "--least-gap", "0", "-o", folder});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("crops: "));
  EXPECT_TRUE(std::filesystem::exists(folder + "/dataset.json"));
  EXPECT_TRUE(std::filesystem::exists(folder + "/crops_0000.npy"));
}

TEST(LabelCommand, NamesAnnotationsThatDoNotExist) {
  const VillageFolder village;
  const ProgramRun run = run_gable({"label", village.dsm(), "--no-detectors", "--annotations",
                                    village.path("none.json"), "-o", village.path("crops")});
  EXPECT_EQ(run.exit_code, static_cast<int>(ExitCode::kNoInput));
  EXPECT_THAT(run.err, HasSubstr("none.json"));
  EXPECT_FALSE(std::filesystem::exists(village.path("crops") + "/dataset.json"));
}

TEST(SynthesizeDataset, TheSameSeedGivesTheSameFilesForAnyNumberOfThreads) {
  const VillageFolder scratch;
  const auto make = [&](const std::string& name, const std::string& threads) {
    const ProgramRun run = run_gable({"synthesize", "--dataset", "--count", "24", "--seed", "9",
                                      "--threads", threads, "-o", scratch.path(name)});
    EXPECT_EQ(run.exit_code, 0) << run.err;
  };
  make("one", "1");
  make("two", "2");
  size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(scratch.path("one"))) {
    const std::string name = entry.path().filename().string();
    EXPECT_EQ(file_bytes(scratch.path("one") + "/" + name),
              file_bytes(scratch.path("two") + "/" + name))
        << name;
    ++files;
  }
  EXPECT_EQ(files, 13u);
}

TEST(EvaluateDetectorsCommand, NamesAFolderWithoutNetworks) {
  const VillageFolder scratch;
  const ProgramRun run = run_gable({"evaluate-detectors", "--models", scratch.path("nowhere")});
  EXPECT_EQ(run.exit_code, static_cast<int>(ExitCode::kNoInput));
  EXPECT_THAT(run.err, HasSubstr("nowhere"));
}

}  // namespace
}  // namespace gable
