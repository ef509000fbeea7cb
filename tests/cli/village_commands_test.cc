#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "cli/run_program.h"

namespace gable {
namespace {

using ::testing::HasSubstr;

/// A fresh folder of the running test.
std::string scratch(const std::string& name) {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const auto folder =
      std::filesystem::path(testing::TempDir()) / (std::string("gable-cli-") + test->name()) / name;
  std::filesystem::remove_all(folder);
  return folder.string();
}

std::string bytes_of(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(SynthesizeCommand, TheSameSeedGivesTheSameFiles) {
  const std::string a = scratch("a"), b = scratch("b");
  for (const std::string& folder : {a, b}) {
    const ProgramRun run =
        run_gable({"synthesize", "--count", "5", "--seed", "3", "--quiet", "-o", folder});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(run.out + run.err, "");
  }
  for (const std::string file : {"dsm.tif", "dtm.tif", "footprints.gpkg", "truth.city.jsonl"}) {
    const std::string bytes = bytes_of(a + "/" + file);
    EXPECT_FALSE(bytes.empty()) << file;
    EXPECT_TRUE(bytes == bytes_of(b + "/" + file)) << file;
  }
}

TEST(SynthesizeCommand, AFolderThatCannotBeMadeIsOneLine) {
  const ProgramRun run = run_gable({"synthesize", "--count", "1", "-o", "/dev/null/village"});
  EXPECT_EQ(run.exit_code, 5);
  EXPECT_EQ(num_lines(run.err), 1) << run.err;
  EXPECT_THAT(run.err, HasSubstr("/dev/null/village"));
}

TEST(EvaluateCommand, TheTruthIsPerfectAgainstItself) {
  const std::string village = scratch("village");
  ASSERT_EQ(run_gable({"synthesize", "--count", "5", "-o", village}).exit_code, 0);
  const std::string truth = village + "/truth.city.jsonl";
  const ProgramRun run = run_gable({"evaluate", truth, "--dsm", village + "/dsm.tif", "--dtm",
                                    village + "/dtm.tif", "--truth", truth});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("footprint IoU, mean               1.000"));
  EXPECT_THAT(run.out, HasSubstr("foundation type                   100.0 % right"));
  EXPECT_THAT(run.out, HasSubstr("median MAD 0.000 m, 100.0 % below"));
}

TEST(EvaluateCommand, AMissingFileIsNamed) {
  const ProgramRun run =
      run_gable({"evaluate", "none.jsonl", "--dsm", "none-dsm.tif", "--dtm", "none-dtm.tif"});
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_EQ(num_lines(run.err), 1) << run.err;
  EXPECT_THAT(run.err, HasSubstr("none-dsm.tif"));
}

}  // namespace
}  // namespace gable
