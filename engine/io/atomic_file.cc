#include <fcntl.h>
#include <gable/engine/error.h>
#include <gable/engine/io/atomic_file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>

namespace gable {
namespace {

namespace fs = std::filesystem;

constexpr size_t kBufferSize = 1 << 20;
constexpr int kMaxTemporaryNames = 1000;

}  // namespace

AtomicFile::AtomicFile(const std::string& path) : path_(path), final_(path) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  if (fs::is_directory(status)) fail(EISDIR);
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    descriptor_ = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor_ < 0) fail(errno);
    return;
  }
  if (fs::is_symlink(fs::symlink_status(path, ignored))) {
    final_ = fs::weakly_canonical(path, ignored).string();
  }
  // A name of its own for every process and attempt; O_EXCL never takes over somebody else's file.
  for (int i = 0; descriptor_ < 0 && i < kMaxTemporaryNames; ++i) {
    temporary_ = final_ + "." + std::to_string(::getpid()) + "-" + std::to_string(i) + ".part";
    descriptor_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor_ < 0 && errno != EEXIST) {
      const int error_number = errno;
      temporary_.clear();
      fail(error_number);
    }
  }
  if (descriptor_ < 0) {
    temporary_.clear();
    fail(EEXIST);
  }
}

AtomicFile::~AtomicFile() { discard(); }

void AtomicFile::write(std::string_view bytes) {
  buffer_.append(bytes);
  if (buffer_.size() >= kBufferSize) flush();
}

void AtomicFile::flush() {
  size_t done = 0;
  while (done < buffer_.size()) {
    const ssize_t n = ::write(descriptor_, buffer_.data() + done, buffer_.size() - done);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) fail(n < 0 ? errno : ENOSPC);
    done += static_cast<size_t>(n);
  }
  buffer_.clear();
}

void AtomicFile::commit() {
  flush();
  // Delayed write errors (quota, network folders) show at fsync or close, not at write.
  if (!temporary_.empty() && ::fsync(descriptor_) != 0) fail(errno);
  if (::close(std::exchange(descriptor_, -1)) != 0) fail(errno);
  if (temporary_.empty()) return;
  if (std::rename(temporary_.c_str(), final_.c_str()) != 0) fail(errno);
  temporary_.clear();
}

void AtomicFile::discard() {
  if (descriptor_ >= 0) ::close(std::exchange(descriptor_, -1));
  if (!temporary_.empty()) ::unlink(std::exchange(temporary_, {}).c_str());
}

void AtomicFile::fail(int error_number) {
  discard();
  throw Error(ExitCode::kCannotWrite, path_ + ": cannot be written: " + strerror(error_number));
}

void write_file_atomically(const std::string& path, std::string_view bytes) {
  AtomicFile file(path);
  file.write(bytes);
  file.commit();
}

}  // namespace gable
