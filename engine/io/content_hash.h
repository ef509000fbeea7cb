#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace gable {

/// Tells whether bytes are the same as once before: FNV-1a (Fowler, Noll, Vo) of 64 bits, no
/// protection against somebody who wants two files to have the same.
class ContentHash {
 public:
  void add(std::string_view bytes);
  /// 16 hexadecimal digits.
  std::string text() const;

 private:
  uint64_t state_ = 0xcbf29ce484222325u;
};

/// Of a whole file. Throws Error (kNoInput) where it cannot be read.
std::string hash_of_file(const std::string& path);

/// What tells one file from another without reading all of it: its size, its first and its last
/// 64 KiB. Throws Error (kNoInput) where it cannot be read.
struct FileIdentity {
  uint64_t bytes = 0;
  std::string hash;
};
FileIdentity identity_of_file(const std::string& path);

}  // namespace gable
