#pragma once

#include <gable/engine/detectors/house_crop.h>

#include <array>
#include <bit>
#include <cstdint>

namespace gable {

/// A set of pixels of a crop: one word per row, bit `col` of word `row`.
class CropBits {
 public:
  bool at(int row, int col) const { return rows_[row] >> col & 1u; }
  void set(int row, int col) { rows_[row] |= uint64_t{1} << col; }
  /// Adds the pixels [first, last) of a row; both within [0, 64].
  void set_row(int row, int first, int last) {
    if (first < last) rows_[row] |= (~uint64_t{0} >> (kCropSize - (last - first))) << first;
  }

  int count() const {
    int sum = 0;
    for (const uint64_t row : rows_) sum += std::popcount(row);
    return sum;
  }
  bool empty() const { return *this == CropBits(); }

  uint64_t& row(int r) { return rows_[r]; }
  uint64_t row(int r) const { return rows_[r]; }

  CropBits& operator|=(const CropBits& other) {
    for (int r = 0; r < kCropSize; ++r) rows_[r] |= other.rows_[r];
    return *this;
  }
  CropBits& operator&=(const CropBits& other) {
    for (int r = 0; r < kCropSize; ++r) rows_[r] &= other.rows_[r];
    return *this;
  }
  friend CropBits operator|(CropBits a, const CropBits& b) { return a |= b; }
  friend CropBits operator&(CropBits a, const CropBits& b) { return a &= b; }
  bool operator==(const CropBits&) const = default;

 private:
  static_assert(kCropSize == 64);
  std::array<uint64_t, kCropSize> rows_{};
};

/// The pixels of the building.
inline CropBits mask_bits(const HouseCrop& crop) {
  CropBits bits;
  for (int row = 0; row < kCropSize; ++row) {
    for (int col = 0; col < kCropSize; ++col) {
      if (crop.mask[static_cast<size_t>(row) * kCropSize + col]) bits.set(row, col);
    }
  }
  return bits;
}

/// Number of pixels in both sets.
inline int common_pixels(const CropBits& a, const CropBits& b) {
  int sum = 0;
  for (int r = 0; r < kCropSize; ++r) sum += std::popcount(a.row(r) & b.row(r));
  return sum;
}

/// Intersection over union; 0 where both sets are empty.
inline double intersection_over_union(const CropBits& a, const CropBits& b) {
  int both = 0, either = 0;
  for (int r = 0; r < kCropSize; ++r) {
    both += std::popcount(a.row(r) & b.row(r));
    either += std::popcount(a.row(r) | b.row(r));
  }
  return either > 0 ? static_cast<double>(both) / either : 0.0;
}

}  // namespace gable
