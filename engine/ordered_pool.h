#pragma once

#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <map>
#include <mutex>
#include <stop_token>
#include <thread>
#include <utility>
#include <vector>

namespace gable {

/// Calls work(0), ..., work(count - 1) on `threads` threads, in any order, and deliver(result) on
/// the calling thread in the order of the indices, as soon as each is ready. At most a few results
/// per thread wait for their turn. An exception of either ends the rest and is thrown again, that
/// of the lowest index; after a stop request the results so far are delivered and false returned.
template <typename Result>
bool run_in_order(size_t count, int threads, const std::stop_token& stop,
                  const std::function<Result(size_t)>& work,
                  const std::function<void(Result&&)>& deliver) {
  std::mutex mutex;
  std::condition_variable changed;
  std::map<size_t, Result> ready;
  std::map<size_t, std::exception_ptr> failed;
  size_t next = 0, delivered = 0;
  bool over = false;
  const size_t most_waiting = 16 * static_cast<size_t>(threads);

  const auto run = [&] {
    std::unique_lock lock(mutex);
    while (true) {
      changed.wait(lock, [&] { return over || next >= count || next < delivered + most_waiting; });
      if (over || next >= count || stop.stop_requested()) break;
      const size_t index = next++;
      lock.unlock();
      try {
        Result result = work(index);
        lock.lock();
        ready.emplace(index, std::move(result));
      } catch (...) {
        if (!lock.owns_lock()) lock.lock();
        failed.emplace(index, std::current_exception());
      }
      changed.notify_all();
    }
    changed.notify_all();
  };
  std::vector<std::jthread> workers;
  for (int i = 0; i < threads; ++i) workers.emplace_back(run);

  std::unique_lock lock(mutex);
  std::exception_ptr error;
  while (delivered < count && !error) {
    // Indices are handed out in order: with nothing handed out and a stop, no more will come.
    changed.wait(lock, [&] {
      return ready.contains(delivered) || failed.contains(delivered) ||
             (stop.stop_requested() && delivered >= next);
    });
    if (failed.contains(delivered)) {
      error = failed[delivered];
    } else if (ready.contains(delivered)) {
      Result result = std::move(ready.extract(delivered).mapped());
      lock.unlock();
      try {
        deliver(std::move(result));
      } catch (...) {
        error = std::current_exception();
      }
      lock.lock();
      ++delivered;
      changed.notify_all();
    } else {
      break;
    }
  }
  over = true;
  changed.notify_all();
  lock.unlock();
  workers.clear();
  if (error) std::rethrow_exception(error);
  return delivered == count;
}

}  // namespace gable
