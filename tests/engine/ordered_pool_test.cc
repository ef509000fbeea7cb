#include <gable/engine/ordered_pool.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <numeric>
#include <stdexcept>
#include <string>

namespace gable {
namespace {

TEST(OrderedPool, ResultsAreDeliveredInOrderWhateverTheirTiming) {
  for (const int threads : {1, 2, 7}) {
    std::vector<size_t> delivered;
    const bool done = run_in_order<size_t>(
        200, threads, {},
        [](size_t i) {
          std::this_thread::sleep_for(std::chrono::microseconds((i * 7919) % 300));
          return i * i;
        },
        [&](size_t&& result) { delivered.push_back(result); });
    EXPECT_TRUE(done);
    ASSERT_EQ(delivered.size(), 200u);
    for (size_t i = 0; i < delivered.size(); ++i) EXPECT_EQ(delivered[i], i * i);
  }
}

TEST(OrderedPool, ExceptionsOfTheLowestIndexComeThrough) {
  std::vector<size_t> delivered;
  try {
    run_in_order<size_t>(
        100, 4, {},
        [](size_t i) {
          if (i % 10 == 5) throw std::runtime_error(std::to_string(i));
          return i;
        },
        [&](size_t&& result) { delivered.push_back(result); });
    FAIL() << "nothing was thrown";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "5");
  }
  EXPECT_EQ(delivered.size(), 5u);
}

TEST(OrderedPool, ExceptionsOfTheDeliveryComeThrough) {
  EXPECT_THROW(run_in_order<size_t>(
                   100, 4, {}, [](size_t i) { return i; },
                   [](size_t&& result) {
                     if (result == 3) throw std::runtime_error("full");
                   }),
               std::runtime_error);
}

TEST(OrderedPool, AStopEndsItEarlyWithoutAGap) {
  std::stop_source source;
  std::vector<size_t> delivered;
  std::atomic<size_t> started = 0;
  const bool done = run_in_order<size_t>(
      100000, 3, source.get_token(),
      [&](size_t i) {
        ++started;
        return i;
      },
      [&](size_t&& result) {
        delivered.push_back(result);
        if (delivered.size() == 10) source.request_stop();
      });
  EXPECT_FALSE(done);
  EXPECT_EQ(delivered.size(), started);
  EXPECT_LT(delivered.size(), 1000u);
  for (size_t i = 0; i < delivered.size(); ++i) EXPECT_EQ(delivered[i], i);
}

TEST(OrderedPool, NothingToDoIsDone) {
  EXPECT_TRUE(run_in_order<int>(
      0, 2, {}, [](size_t) { return 0; }, [](int&&) {}));
}

}  // namespace
}  // namespace gable
