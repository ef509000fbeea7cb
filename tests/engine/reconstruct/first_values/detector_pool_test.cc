#include <gable/engine/reconstruct/first_values/detector_pool.h>
#include <gtest/gtest.h>

#include "engine/detectors/tiny_nets.h"

namespace gable {
namespace {

TEST(DetectorPool, NoTwoBorrowersShareAnInstanceAndReturnedOnesAreLentAgain) {
  const ScratchFolder folder;
  write_tiny_nets(folder);
  DetectorPool pool(folder.path(""));
  const DetectorNets* first = nullptr;
  {
    const DetectorPool::Loan a = pool.lend(), b = pool.lend();
    first = a.get();
    ASSERT_NE(first, nullptr);
    ASSERT_NE(b.get(), nullptr);
    EXPECT_NE(b.get(), first);
  }
  const DetectorPool::Loan a = pool.lend(), b = pool.lend();
  EXPECT_TRUE(a.get() == first || b.get() == first);
}

TEST(DetectorPool, FilesThatAreMissingAreKnownAtOnce) {
  const ScratchFolder folder;
  const Error error = error_of([&] { DetectorPool pool(folder.path("")); }, kHouseNet);
  EXPECT_EQ(error.code(), ExitCode::kNoInput);
}

}  // namespace
}  // namespace gable
