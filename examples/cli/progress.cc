#include "examples/cli/progress.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <utility>

namespace gable {
namespace {

constexpr std::chrono::milliseconds kBarInterval{100};
constexpr std::chrono::seconds kLineInterval{30};
constexpr int kBarWidth = 24;

std::string bar(size_t done, size_t total) {
  const size_t filled = total == 0 ? kBarWidth : std::min(done, total) * kBarWidth / total;
  return "[" + std::string(filled, '#') + std::string(kBarWidth - filled, ' ') + "] ";
}

template <typename... Args>
std::string format(const char* pattern, Args... args) {
  char buffer[64];
  std::snprintf(buffer, sizeof(buffer), pattern, args...);
  return buffer;
}

}  // namespace

ProgressStyle progress_style(bool quiet) {
  if (quiet) return ProgressStyle::kSilent;
  return isatty(STDERR_FILENO) ? ProgressStyle::kBar : ProgressStyle::kLines;
}

std::string duration_text(double seconds) {
  const long s = std::lround(std::clamp(seconds, 0.0, 1e9));
  if (s >= 3600) return format("%ld h %02ld min", s / 3600, s / 60 % 60);
  if (s >= 60) return format("%ld min %02ld s", s / 60, s % 60);
  return format("%ld s", s);
}

std::string rate_and_time_left(size_t done, size_t total, double seconds) {
  if (done == 0 || seconds <= 0.0) return "";
  const double rate = static_cast<double>(done) / seconds;
  std::string text = format(rate < 10.0 ? "%.2f/s" : "%.1f/s", rate);
  if (done < total)
    text += ", " + duration_text(static_cast<double>(total - done) / rate) + " left";
  return text;
}

Progress::Progress(std::string what, size_t total, ProgressStyle style, std::ostream& out)
    : what_(std::move(what)), total_(total), style_(style), out_(out), start_(Clock::now()) {
  const std::lock_guard lock(mutex_);
  if (style_ != ProgressStyle::kSilent) show(start_);
}

Progress::~Progress() {
  const std::lock_guard lock(mutex_);
  if (style_ != ProgressStyle::kBar) return;
  show(Clock::now());
  out_ << std::endl;
}

void Progress::set_done(size_t done) {
  const std::lock_guard lock(mutex_);
  update(done);
}

void Progress::advance() {
  const std::lock_guard lock(mutex_);
  update(done_ + 1);
}

void Progress::update(size_t done) {
  if (done <= done_) return;
  done_ = done;
  if (style_ == ProgressStyle::kSilent) return;
  const auto now = Clock::now();
  const auto since = now - shown_at_;
  const size_t tenths = total_ == 0 ? 0 : done_ * 10 / total_;
  const bool due = style_ == ProgressStyle::kBar ? since >= kBarInterval || done_ == total_
                                                 : since >= kLineInterval || tenths > shown_tenths_;
  if (due) show(now);
}

void Progress::say(const std::string& line) {
  const std::lock_guard lock(mutex_);
  if (style_ == ProgressStyle::kSilent) return;
  if (style_ == ProgressStyle::kBar) out_ << '\r' << std::string(shown_width_, ' ') << '\r';
  out_ << line << std::endl;
  if (style_ == ProgressStyle::kBar) show(Clock::now());
}

std::string Progress::text(Clock::time_point now) const {
  std::string text = std::to_string(done_) + "/" + std::to_string(total_) + " " + what_;
  const double seconds = std::chrono::duration<double>(now - start_).count();
  if (done_ == total_ && done_ > 0) {
    return text + " in " + duration_text(seconds) + ", " +
           rate_and_time_left(done_, total_, seconds);
  }
  const std::string rest = rate_and_time_left(done_, total_, seconds);
  return rest.empty() ? text : text + ", " + rest;
}

void Progress::show(Clock::time_point now) {
  std::string line = text(now);
  if (style_ == ProgressStyle::kBar) {
    line = bar(done_, total_) + line;
    const size_t width = line.size();
    if (width < shown_width_) line += std::string(shown_width_ - width, ' ');
    shown_width_ = width;
    out_ << '\r' << line << std::flush;
  } else {
    out_ << line << std::endl;
  }
  shown_at_ = now;
  shown_tenths_ = total_ == 0 ? 0 : done_ * 10 / total_;
}

}  // namespace gable
