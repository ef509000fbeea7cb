#include <gable/engine/detectors/crop_sums.h>
#include <gable/engine/detectors/garage_candidates.h>
#include <glog/logging.h>

#include <algorithm>

namespace gable {
namespace {

// Everything within a step of a pixel of `bits`, diagonals included.
CropBits grown(const CropBits& bits) {
  CropBits out;
  for (int row = 0; row < kCropSize; ++row) {
    const uint64_t line = bits.row(row) | bits.row(row) << 1 | bits.row(row) >> 1;
    for (int r = std::max(0, row - 1); r <= std::min(kCropSize - 1, row + 1); ++r) {
      out.row(r) |= line;
    }
  }
  return out;
}

CropGarage fit(const CropBits& pixels, const GarageOptions& options) {
  const CropRectangle box = bounds_of(pixels);
  const CropSums sums(pixels);
  const int count = pixels.count();
  const int x0 = static_cast<int>(box.x0), x1 = static_cast<int>(box.x1);
  const int y0 = static_cast<int>(box.y0), y1 = static_cast<int>(box.y1);
  const int area = (x1 - x0) * (y1 - y0);
  CropGarage best;
  best.rectangles = {box};
  best.iou = static_cast<double>(count) / area;
  double to_beat = best.iou + options.l_gain;
  for (int x = x0 + options.least_inset; x <= x1 - options.least_inset; ++x) {
    for (int y = y0 + options.least_inset; y <= y1 - options.least_inset; ++y) {
      for (const bool right : {false, true}) {
        for (const bool bottom : {false, true}) {
          // The notch, at the corner opposite to the outer one.
          const int nx0 = right ? x : x0, nx1 = right ? x1 : x;
          const int ny0 = bottom ? y : y0, ny1 = bottom ? y1 : y;
          const int lost = sums.count(nx0, nx1, ny0, ny1);
          const double iou =
              static_cast<double>(count - lost) / (area - (nx1 - nx0) * (ny1 - ny0) + lost);
          if (iou <= to_beat) continue;
          to_beat = best.iou = iou;
          const double left_x = right ? x0 : x, right_x = right ? x : x1;
          const double top_y = bottom ? y0 : y, bottom_y = bottom ? y : y1;
          best.rectangles = {{box.x0, box.x1, top_y, bottom_y}, {left_x, right_x, box.y0, box.y1}};
          // House y runs against crop y.
          best.side = {right ? -1.0 : 1.0, bottom ? 1.0 : -1.0};
        }
      }
    }
  }
  return best;
}

}  // namespace

std::string check(const GarageOptions& options) {
  if (!(options.threshold > 0.0 && options.threshold <= 1.0)) return "threshold must be in (0, 1]";
  if (!(options.least_diameter >= 1 && options.least_diameter <= kCropSize)) {
    return "least_diameter must be in [1, 64]";
  }
  if (!(options.least_inset >= 1 && options.least_inset <= kCropSize / 2)) {
    return "least_inset must be in [1, 32]";
  }
  if (!(options.l_gain >= 0.0 && options.l_gain <= 1.0)) return "l_gain must be in [0, 1]";
  return {};
}

CropBits pixels_above(std::span<const float> map, double threshold) {
  CHECK_EQ(map.size(), kCropPixels);
  CropBits bits;
  for (int row = 0; row < kCropSize; ++row) {
    for (int col = 0; col < kCropSize; ++col) {
      if (map[static_cast<size_t>(row) * kCropSize + col] >= threshold) bits.set(row, col);
    }
  }
  return bits;
}

std::vector<CropBits> connected_pieces(const CropBits& bits) {
  std::vector<CropBits> pieces;
  CropBits rest = bits;
  for (int row = 0; row < kCropSize; ++row) {
    while (rest.row(row)) {
      CropBits piece;
      piece.set(row, std::countr_zero(rest.row(row)));
      for (CropBits next = grown(piece) & rest; next != piece; next = grown(piece) & rest) {
        piece = next;
      }
      for (int r = 0; r < kCropSize; ++r) rest.row(r) &= ~piece.row(r);
      pieces.push_back(piece);
    }
  }
  return pieces;
}

std::vector<CropGarage> garage_candidates(std::span<const float> map, const CropBits& mask,
                                          const GarageOptions& options) {
  CHECK(check(options).empty()) << check(options);
  std::vector<CropGarage> out;
  for (const CropBits& piece : connected_pieces(pixels_above(map, options.threshold))) {
    const CropBits within = piece & mask;
    const CropBits& pixels = 2 * within.count() > piece.count() ? within : piece;
    const CropRectangle box = bounds_of(pixels);
    if (std::max(box.width(), box.height()) < options.least_diameter) continue;
    out.push_back(fit(pixels, options));
  }
  return out;
}

}  // namespace gable
