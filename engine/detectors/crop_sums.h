#pragma once

#include <gable/engine/detectors/crop_bits.h>

#include <array>

namespace gable {

/// Counts the pixels of a set in any rectangle of whole pixels at once (an integral image).
class CropSums {
 public:
  explicit CropSums(const CropBits& bits) {
    for (int row = 0; row < kCropSize; ++row) {
      int in_row = 0;
      for (int col = 0; col < kCropSize; ++col) {
        in_row += bits.at(row, col);
        sums_[row + 1][col + 1] = sums_[row][col + 1] + in_row;
      }
    }
  }

  /// Pixels of columns [x0, x1) and rows [y0, y1), all in [0, 64].
  int count(int x0, int x1, int y0, int y1) const {
    return sums_[y1][x1] - sums_[y0][x1] - sums_[y1][x0] + sums_[y0][x0];
  }

 private:
  std::array<std::array<int, kCropSize + 1>, kCropSize + 1> sums_{};
};

}  // namespace gable
