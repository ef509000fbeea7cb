#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/run_program.h"

namespace gable {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

TEST(Program, PrintsItsVersion) {
  const ProgramRun run = run_gable({"--version"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_THAT(run.out, StartsWith("gable "));
  EXPECT_EQ(num_lines(run.out), 1);
  EXPECT_EQ(run.err, "");
}

TEST(Program, HelpListsTheExitCodes) {
  const ProgramRun run = run_gable({"--help"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_THAT(run.out, HasSubstr("Exit codes"));
  EXPECT_EQ(run.err, "");
}

TEST(Program, WrongUsageIsOneLineAndExitCode2) {
  for (const std::vector<std::string>& arguments :
       std::vector<std::vector<std::string>>{{}, {"--frobnicate"}, {"frobnicate"}}) {
    const ProgramRun run = run_gable(arguments);
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_THAT(run.err, StartsWith("gable: "));
    EXPECT_EQ(num_lines(run.err), 1) << run.err;
    EXPECT_EQ(run.out, "");
  }
}

}  // namespace
}  // namespace gable
