#pragma once

#include <atomic>
#include <stop_token>
#include <thread>

namespace gable {

/// Turns Ctrl-C (SIGINT) and SIGTERM into a stop request for as long as it lives, so that the work
/// in progress can end in order and leave nothing half-written. A second signal ends the program at
/// once. Construct it before any other thread: threads inherit the blocked signals.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  /// To be looked at by long work, which then throws Error with ExitCode::kInterrupted.
  std::stop_token token() const { return source_.get_token(); }

 private:
  void watch();

  std::stop_source source_;
  std::atomic<bool> over_ = false;
  std::thread watcher_;
};

}  // namespace gable
