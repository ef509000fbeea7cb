#include <fcntl.h>
#include <gable/engine/error.h>
#include <gable/engine/io/scans/whole_file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace gable {
namespace {

/// Closes a file on every way out.
struct Descriptor {
  int number = -1;
  ~Descriptor() {
    if (number >= 0) close(number);
  }
};

[[noreturn]] void cannot_read(const std::string& path, int error_number) {
  throw Error(ExitCode::kNoInput, error_number == ENOENT
                                      ? path + ": no such file; check the path"
                                      : path + ": cannot be read: " + std::strerror(error_number));
}

}  // namespace

std::string read_whole_file(const std::string& path) {
  Descriptor file{open(path.c_str(), O_RDONLY | O_CLOEXEC)};
  struct stat status = {};
  if (file.number < 0 || fstat(file.number, &status) != 0) cannot_read(path, errno);
  if (S_ISDIR(status.st_mode)) {
    throw Error(ExitCode::kNoInput, path + ": is a folder; give a file in it");
  }
  constexpr size_t kChunk = size_t{1} << 20;
  std::string bytes;
  // One byte more than the size, so that the end is seen without growing.
  bytes.resize(S_ISREG(status.st_mode) ? static_cast<size_t>(status.st_size) + 1 : kChunk);
  size_t size = 0;
  while (true) {
    if (size == bytes.size()) bytes.resize(size + std::max(kChunk, size / 2));
    const ssize_t count = read(file.number, bytes.data() + size, bytes.size() - size);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) cannot_read(path, errno);
    if (count == 0) break;
    size += static_cast<size_t>(count);
  }
  bytes.resize(size);
  return bytes;
}

}  // namespace gable
