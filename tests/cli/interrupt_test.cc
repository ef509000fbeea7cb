#include "examples/cli/interrupt.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <thread>

namespace gable {
namespace {

bool stops_within_seconds(const Interrupt& interrupt, int seconds) {
  for (int i = 0; i < 1000 * seconds; ++i) {
    if (interrupt.token().stop_requested()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return false;
}

TEST(Interrupt, SignalBecomesAStopRequest) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const Interrupt interrupt;
    EXPECT_FALSE(interrupt.token().stop_requested());
    kill(getpid(), signal);
    EXPECT_TRUE(stops_within_seconds(interrupt, 10));
  }
}

TEST(InterruptDeathTest, SecondSignalEndsTheProgramAtOnce) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(
      {
        const Interrupt interrupt;
        kill(getpid(), SIGINT);
        stops_within_seconds(interrupt, 10);
        kill(getpid(), SIGINT);
        std::this_thread::sleep_for(std::chrono::seconds(10));
      },
      ::testing::ExitedWithCode(130), "stopping");
}

}  // namespace
}  // namespace gable
