#pragma once

#include <string>
#include <string_view>

namespace gable {

/// An output file that appears under its name only when it is complete: bytes go to a temporary
/// name in the same folder, `commit` renames it. Without `commit` nothing is left behind. A path
/// that exists and is no regular file (a device, a pipe) is written directly; a symbolic link is
/// followed.
class AtomicFile {
 public:
  /// Opens the temporary file at once, so that a folder that cannot be written is known before any
  /// work is done. Throws Error (kCannotWrite).
  explicit AtomicFile(const std::string& path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// Appends bytes. Throws Error (kCannotWrite), for instance on a full disk.
  void write(std::string_view bytes);

  /// Flushes, closes and renames to the final name. Throws Error (kCannotWrite).
  void commit();

  const std::string& path() const { return path_; }

 private:
  void flush();
  void discard();
  [[noreturn]] void fail(int error_number);

  std::string path_;       ///< as given, for messages
  std::string final_;      ///< links resolved
  std::string temporary_;  ///< empty when written directly
  std::string buffer_;
  int descriptor_ = -1;
};

/// Writes a whole file atomically. Throws Error (kCannotWrite).
void write_file_atomically(const std::string& path, std::string_view bytes);

}  // namespace gable
