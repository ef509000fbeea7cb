#include <gable/engine/error.h>
#include <gable/engine/io/content_hash.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <vector>

namespace gable {
namespace {

constexpr size_t kPieceSize = size_t{1} << 16;
constexpr uint64_t kPrime = 0x100000001b3u;

[[noreturn]] void cannot_read(const std::string& path) {
  throw Error(ExitCode::kNoInput, path + ": cannot be read; check the path and its permissions");
}

/// Adds up to `most` bytes from where the stream stands and returns how many there were.
size_t add_piece(std::ifstream* stream, std::vector<char>* piece, ContentHash* hash) {
  stream->read(piece->data(), static_cast<std::streamsize>(piece->size()));
  const auto count = static_cast<size_t>(stream->gcount());
  hash->add({piece->data(), count});
  return count;
}

}  // namespace

void ContentHash::add(std::string_view bytes) {
  for (const char c : bytes) state_ = (state_ ^ static_cast<unsigned char>(c)) * kPrime;
}

std::string ContentHash::text() const {
  std::string digits(16, '0');
  for (int i = 0; i < 16; ++i) digits[i] = "0123456789abcdef"[(state_ >> (60 - 4 * i)) & 15];
  return digits;
}

std::string hash_of_file(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) cannot_read(path);
  std::vector<char> piece(kPieceSize);
  ContentHash hash;
  while (add_piece(&stream, &piece, &hash) > 0) {
  }
  if (stream.bad()) cannot_read(path);
  return hash.text();
}

FileIdentity identity_of_file(const std::string& path) {
  std::error_code error;
  FileIdentity identity;
  identity.bytes = std::filesystem::file_size(path, error);
  std::ifstream stream(path, std::ios::binary);
  if (error || !stream) cannot_read(path);
  std::vector<char> piece(kPieceSize);
  ContentHash hash;
  add_piece(&stream, &piece, &hash);
  if (identity.bytes > kPieceSize) {
    stream.clear();
    stream.seekg(static_cast<std::streamoff>(
        identity.bytes - std::min<uint64_t>(identity.bytes - kPieceSize, kPieceSize)));
    add_piece(&stream, &piece, &hash);
  }
  if (stream.bad()) cannot_read(path);
  identity.hash = hash.text();
  return identity;
}

}  // namespace gable
