#include <gable/engine/detectors/crop_foundation.h>

#include <bit>
#include <cmath>
#include <string>

namespace gable {
namespace {

// The first pixel whose centre lies at or beyond an edge, in [0, 64].
int first_pixel(double edge) {
  return static_cast<int>(std::clamp(std::ceil(edge - 0.5), 0.0, 1.0 * kCropSize));
}

// Whether every rectangle of one has its like in the other.
bool is_same(const CropFoundation& a, const CropFoundation& b, double distinct) {
  const auto has_like = [&](const CropRectangle& r, const std::vector<CropRectangle>& others) {
    return std::any_of(others.begin(), others.end(), [&](const CropRectangle& other) {
      return largest_step(r, other) < distinct;
    });
  };
  return std::all_of(a.rectangles.begin(), a.rectangles.end(),
                     [&](const CropRectangle& r) { return has_like(r, b.rectangles); }) &&
         std::all_of(b.rectangles.begin(), b.rectangles.end(),
                     [&](const CropRectangle& r) { return has_like(r, a.rectangles); });
}

}  // namespace

double largest_step(const CropRectangle& a, const CropRectangle& b) {
  return std::max(
      {std::abs(a.x0 - b.x0), std::abs(a.x1 - b.x1), std::abs(a.y0 - b.y0), std::abs(a.y1 - b.y1)});
}

CropBits bits_of(const CropRectangle& rectangle) {
  CropBits bits;
  const int first = first_pixel(rectangle.x0), last = first_pixel(rectangle.x1);
  const int end = first_pixel(rectangle.y1);
  for (int row = first_pixel(rectangle.y0); row < end; ++row) bits.set_row(row, first, last);
  return bits;
}

CropRectangle bounds_of(const CropBits& bits) {
  uint64_t columns = 0;
  int first = kCropSize, last = -1;
  for (int row = 0; row < kCropSize; ++row) {
    if (!bits.row(row)) continue;
    columns |= bits.row(row);
    first = std::min(first, row);
    last = row;
  }
  if (last < 0) return {};
  return {1.0 * std::countr_zero(columns), 1.0 * (kCropSize - std::countl_zero(columns)),
          1.0 * first, last + 1.0};
}

CropBits CropFoundation::bits() const {
  CropBits all;
  for (const CropRectangle& rectangle : rectangles) all |= bits_of(rectangle);
  return all;
}

std::string check(const CandidateOptions& options) {
  if (!(options.corner_weight >= 0.0 && options.corner_weight <= 10.0)) {
    return "corner_weight must be in [0, 10]";
  }
  if (!(options.at_most >= 1)) return "at_most must be >= 1";
  if (!(options.distinct >= 0.0 && options.distinct <= kCropSize)) {
    return "distinct must be in [0, 64]";
  }
  if (!(options.agreement >= 0.1 && options.agreement <= kCropSize)) {
    return "agreement must be in [0.1, 64]";
  }
  return {};
}

void keep_best(const CandidateOptions& options, std::vector<CropFoundation>* candidates) {
  std::stable_sort(candidates->begin(), candidates->end(),
                   [&](const CropFoundation& a, const CropFoundation& b) {
                     return candidate_score(a, options) > candidate_score(b, options);
                   });
  std::vector<CropFoundation> kept;
  for (CropFoundation& candidate : *candidates) {
    if (static_cast<int>(kept.size()) == options.at_most) break;
    if (std::none_of(kept.begin(), kept.end(), [&](const CropFoundation& better) {
          return better.side == candidate.side && is_same(better, candidate, options.distinct);
        })) {
      kept.push_back(std::move(candidate));
    }
  }
  *candidates = std::move(kept);
}

}  // namespace gable
