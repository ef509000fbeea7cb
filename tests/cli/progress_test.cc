#include "examples/cli/progress.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>
#include <thread>
#include <vector>

namespace gable {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

TEST(Progress, DurationsAreReadable) {
  EXPECT_EQ(duration_text(0.2), "0 s");
  EXPECT_EQ(duration_text(59.4), "59 s");
  EXPECT_EQ(duration_text(200.0), "3 min 20 s");
  EXPECT_EQ(duration_text(3720.0), "1 h 02 min");
}

TEST(Progress, TimeLeftFollowsFromTheRateSoFar) {
  EXPECT_EQ(rate_and_time_left(0, 10, 3.0), "");
  EXPECT_EQ(rate_and_time_left(5, 20, 2.0), "2.50/s, 6 s left");
  EXPECT_EQ(rate_and_time_left(50, 2450, 2.5), "20.0/s, 2 min 00 s left");
  EXPECT_EQ(rate_and_time_left(20, 20, 2.0), "10.0/s");
}

TEST(Progress, SilentPrintsNothing) {
  std::ostringstream out;
  {
    Progress progress("houses", 3, ProgressStyle::kSilent, out);
    progress.advance();
    progress.say("a line");
    progress.set_done(3);
  }
  EXPECT_EQ(out.str(), "");
}

TEST(Progress, LinesComePerTenthOfTheWork) {
  std::ostringstream out;
  {
    Progress progress("houses", 1000, ProgressStyle::kLines, out);
    for (int i = 0; i < 1000; ++i) progress.advance();
  }
  std::istringstream lines(out.str());
  std::string line;
  std::vector<std::string> all;
  while (std::getline(lines, line)) all.push_back(line);
  ASSERT_EQ(all.size(), 11u) << out.str();
  EXPECT_EQ(all.front(), "0/1000 houses");
  EXPECT_THAT(all[3], StartsWith("300/1000 houses"));
  EXPECT_THAT(all.back(), StartsWith("1000/1000 houses in 0 s"));
}

TEST(Progress, BarStaysOnOneLineAndEndsFull) {
  std::ostringstream out;
  {
    Progress progress("houses", 40, ProgressStyle::kBar, out);
    for (int i = 0; i < 40; ++i) progress.advance();
  }
  const std::string text = out.str();
  EXPECT_EQ(text.find('\n'), text.size() - 1);
  EXPECT_THAT(text, HasSubstr("[########################] 40/40 houses"));
}

TEST(Progress, CountsEveryItemOfSeveralThreads) {
  std::ostringstream out;
  {
    Progress progress("houses", 4000, ProgressStyle::kLines, out);
    std::vector<std::thread> threads;
    for (int t = 0; t < 4; ++t) {
      threads.emplace_back([&progress] {
        for (int i = 0; i < 1000; ++i) progress.advance();
      });
    }
    for (std::thread& thread : threads) thread.join();
  }
  EXPECT_THAT(out.str(), HasSubstr("\n4000/4000 houses in "));
}

TEST(Progress, ReportsOutOfOrderNeverGoBack) {
  std::ostringstream out;
  {
    Progress progress("houses", 10, ProgressStyle::kLines, out);
    progress.set_done(7);
    progress.set_done(3);
  }
  EXPECT_THAT(out.str(), HasSubstr("7/10"));
  EXPECT_THAT(out.str(), ::testing::Not(HasSubstr("3/10")));
}

}  // namespace
}  // namespace gable
