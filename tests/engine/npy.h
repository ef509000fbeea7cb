#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

namespace gable {

/// An array read from an NPY file: C order, of T alone.
template <typename T>
struct NpyArray {
  std::vector<size_t> shape;
  std::vector<T> values;

  size_t row_size() const { return shape.empty() ? 0 : values.size() / shape[0]; }
  const T* row(size_t i) const { return values.data() + i * row_size(); }
};

/// Reads version 1 or 2 with the type `descr` as NumPy writes it ("|u1", "<f4"). Throws
/// std::runtime_error where the file is anything else.
template <typename T>
NpyArray<T> read_npy(const std::string& file, const std::string& descr) {
  static_assert(std::endian::native == std::endian::little);
  const auto require = [&](bool condition, const char* what) {
    if (!condition) throw std::runtime_error(file + ": " + what);
  };
  std::ifstream stream(file, std::ios::binary);
  require(static_cast<bool>(stream), "cannot be opened");
  const std::string bytes(std::istreambuf_iterator<char>(stream), {});
  require(bytes.size() > 12 && bytes.substr(0, 6) == "\x93NUMPY", "is no NPY file");
  const auto byte = [&](size_t i) { return static_cast<size_t>(static_cast<uint8_t>(bytes[i])); };
  const bool first_version = byte(6) == 1;
  const size_t length = first_version ? byte(8) | byte(9) << 8
                                      : byte(8) | byte(9) << 8 | byte(10) << 16 | byte(11) << 24;
  const size_t start = first_version ? 10 : 12;
  require(bytes.size() >= start + length, "is cut");
  const std::string header = bytes.substr(start, length);
  require(header.find("'descr': '" + descr + "'") != std::string::npos, "is of another type");
  require(header.find("'fortran_order': False") != std::string::npos, "is in Fortran order");
  NpyArray<T> array;
  size_t count = 1;
  const size_t open = header.find('('), close = header.find(')');
  require(open != std::string::npos && close != std::string::npos, "has no shape");
  for (size_t at = open + 1; at < close;) {
    const size_t digit = header.find_first_of("0123456789", at);
    if (digit == std::string::npos || digit >= close) break;
    size_t used = 0;
    array.shape.push_back(std::stoul(header.substr(digit), &used));
    count *= array.shape.back();
    at = digit + used;
  }
  require(bytes.size() - start - length == count * sizeof(T), "has another size than its shape");
  array.values.resize(count);
  std::memcpy(array.values.data(), bytes.data() + start + length, count * sizeof(T));
  return array;
}

}  // namespace gable
