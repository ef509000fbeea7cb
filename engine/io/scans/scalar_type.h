#pragma once

#include <bit>
#include <climits>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace gable {

/// The numbers that binary scan formats are made of.
enum class ScalarType {
  kInt8,
  kUint8,
  kInt16,
  kUint16,
  kInt32,
  kUint32,
  kInt64,
  kUint64,
  kFloat32,
  kFloat64
};

inline int size_of(ScalarType type) {
  switch (type) {
    case ScalarType::kInt8:
    case ScalarType::kUint8:
      return 1;
    case ScalarType::kInt16:
    case ScalarType::kUint16:
      return 2;
    case ScalarType::kInt32:
    case ScalarType::kUint32:
    case ScalarType::kFloat32:
      return 4;
    default:
      return 8;
  }
}

inline bool is_integer(ScalarType type) {
  return type != ScalarType::kFloat32 && type != ScalarType::kFloat64;
}

/// A number from bytes at any address, in the order of this machine or, `swapped`, the other one.
template <typename T>
T load(const char* bytes, bool swapped = false) {
  unsigned char raw[sizeof(T)];
  for (size_t i = 0; i < sizeof(T); ++i) {
    raw[i] = static_cast<unsigned char>(bytes[swapped ? sizeof(T) - 1 - i : i]);
  }
  T value;
  std::memcpy(&value, raw, sizeof(T));
  return value;
}

/// A number from little-endian bytes.
template <typename T>
T load_little(const char* bytes) {
  return load<T>(bytes, std::endian::native == std::endian::big);
}

/// Any number as a double, which is exact for all but large 64-bit integers.
inline double load_scalar(ScalarType type, const char* bytes, bool swapped = false) {
  switch (type) {
    case ScalarType::kInt8:
      return load<int8_t>(bytes, swapped);
    case ScalarType::kUint8:
      return load<uint8_t>(bytes, swapped);
    case ScalarType::kInt16:
      return load<int16_t>(bytes, swapped);
    case ScalarType::kUint16:
      return load<uint16_t>(bytes, swapped);
    case ScalarType::kInt32:
      return load<int32_t>(bytes, swapped);
    case ScalarType::kUint32:
      return load<uint32_t>(bytes, swapped);
    case ScalarType::kInt64:
      return static_cast<double>(load<int64_t>(bytes, swapped));
    case ScalarType::kUint64:
      return static_cast<double>(load<uint64_t>(bytes, swapped));
    case ScalarType::kFloat32:
      return load<float>(bytes, swapped);
    default:
      return load<double>(bytes, swapped);
  }
}

/// An integer of a file as a label of a scan: -1 for what is negative, no whole number, or too
/// large.
inline int label_of(double value) {
  return value >= 0.0 && value <= INT_MAX && value == std::floor(value) ? static_cast<int>(value)
                                                                        : -1;
}

}  // namespace gable
