#include <gable/engine/error.h>
#include <gable/engine/io/model_folder.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "engine/io/scratch.h"

namespace gable {
namespace {

class ModelFolder : public testing::Test {
 protected:
  ModelFolder() {
    std::filesystem::create_directories(scratch_.path("scales"));
    setenv("GABLE_MODELS", scratch_.path("").c_str(), 1);
  }
  ~ModelFolder() override { unsetenv("GABLE_MODELS"); }

  ScratchFolder scratch_;
};

TEST_F(ModelFolder, ANameIsLookedUpInTheFolderOfTheEnvironmentFirst) {
  const std::string file = scratch_.write("scales/buildings.scales", "mine");
  EXPECT_TRUE(std::filesystem::equivalent(find_scale_model("buildings"), file));
  EXPECT_TRUE(std::filesystem::equivalent(model_folders().front(), scratch_.path("")));
}

TEST_F(ModelFolder, APathIsTakenAsItIs) {
  EXPECT_EQ(find_scale_model("my-model/buildings"), "my-model/buildings");
  EXPECT_EQ(find_scale_model("buildings.scales"), "buildings.scales");
}

TEST_F(ModelFolder, AnUnknownNameIsAnsweredWithTheKnownOnes) {
  scratch_.write("scales/sheds.scales", "");
  scratch_.write("scales/notes.txt", "");
  EXPECT_THAT(scale_model_names(), testing::Contains("sheds"));
  EXPECT_THAT(scale_model_names(), testing::Not(testing::Contains("notes")));
  const Error error = error_of([] { find_scale_model("boats"); }, "boats");
  EXPECT_EQ(error.code(), ExitCode::kNoInput);
  EXPECT_THAT(error.what(), testing::HasSubstr("sheds"));
}

TEST_F(ModelFolder, DetectorsAreLookedUpInTheFolderOfTheEnvironmentFirst) {
  std::filesystem::create_directories(scratch_.path("detectors"));
  EXPECT_TRUE(std::filesystem::equivalent(find_detector_models(), scratch_.path("detectors")));
  EXPECT_EQ(installed_detector_models(), find_detector_models());
}

TEST_F(ModelFolder, FoldersThatDoNotExistAreLeftOut) {
  setenv("GABLE_MODELS", scratch_.path("nowhere").c_str(), 1);
  for (const std::string& folder : model_folders()) {
    EXPECT_TRUE(std::filesystem::is_directory(folder)) << folder;
  }
}

}  // namespace
}  // namespace gable
