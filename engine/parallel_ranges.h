#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

namespace gable {

/// Calls work(begin, end) for consecutive ranges that cover [0, count), on `threads` threads. The
/// ranges do not depend on the number of threads, so what is made per range is the same for any.
template <typename Work>
void for_ranges(size_t count, int threads, const Work& work, size_t range = 4096) {
  const size_t num_ranges = (count + range - 1) / range;
  std::atomic<size_t> next{0};
  const auto run = [&] {
    for (size_t i = next++; i < num_ranges; i = next++) {
      work(i * range, std::min(count, (i + 1) * range));
    }
  };
  std::vector<std::jthread> others;
  for (int i = 1; i < threads && static_cast<size_t>(i) < num_ranges; ++i) others.emplace_back(run);
  run();
}

}  // namespace gable
