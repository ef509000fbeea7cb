#pragma once

#include <chrono>
#include <cstddef>
#include <iosfwd>
#include <mutex>
#include <string>

namespace gable {

/// How progress is shown.
enum class ProgressStyle {
  kBar,     ///< one line, drawn over and over: for a terminal
  kLines,   ///< a new line per tenth of the work or per half minute: for a log
  kSilent,  ///< nothing
};

/// kSilent where `quiet`, kBar where stderr is a terminal, otherwise kLines.
ProgressStyle progress_style(bool quiet);

/// "12.5/s, 3 min 20 s left": the rate of `done` of `total` items after `seconds`, and at that rate
/// the time that the rest takes. Empty before the first item.
std::string rate_and_time_left(size_t done, size_t total, double seconds);

/// "1 h 02 min", "3 min 20 s" or "45 s".
std::string duration_text(double seconds);

/// Shows how far a long piece of work has come. Safe to advance from several threads.
class Progress {
 public:
  /// `what` names the items in the plural: "houses".
  Progress(std::string what, size_t total, ProgressStyle style, std::ostream& out);
  /// Ends the line of a bar.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Sets how many items are done; a smaller number than before is not shown (threads report out of
  /// order).
  void set_done(size_t done);
  /// One more item is done.
  void advance();
  /// Prints a line of its own without tearing the bar. Nothing where kSilent.
  void say(const std::string& line);

 private:
  using Clock = std::chrono::steady_clock;

  // All with the mutex held.
  void update(size_t done);
  void show(Clock::time_point now);
  std::string text(Clock::time_point now) const;

  const std::string what_;
  const size_t total_;
  const ProgressStyle style_;
  std::ostream& out_;
  const Clock::time_point start_;
  std::mutex mutex_;
  size_t done_ = 0;
  Clock::time_point shown_at_;
  size_t shown_tenths_ = 0;
  size_t shown_width_ = 0;  ///< characters of the bar on the terminal
};

}  // namespace gable
