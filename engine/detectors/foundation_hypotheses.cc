#include <gable/engine/detectors/crop_tasks.h>
#include <gable/engine/detectors/foundation_hypotheses.h>
#include <gable/engine/detectors/polygon_candidates.h>
#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gable {
namespace {

constexpr Foundation kTypes[] = {Foundation::kI, Foundation::kII, Foundation::kIII, Foundation::kL,
                                 Foundation::kU};

int first_corner_map(Foundation type) {
  switch (type) {
    case Foundation::kII:
      return crop_map::kCornersII;
    case Foundation::kIII:
      return crop_map::kCornersIII;
    case Foundation::kL:
      return crop_map::kCornersL;
    case Foundation::kU:
      return crop_map::kCornersU;
    default:
      return crop_map::kCornersI;
  }
}

CropBits foundation_pixels(const HouseCrop& crop, const CropAnswer& answer,
                           const GarageOptions& options) {
  const CropBits mask = mask_bits(crop);
  const CropBits garages = pixels_above(answer.map(crop_map::kGarages), options.threshold);
  CropBits rest;
  for (int row = 0; row < kCropSize; ++row) rest.row(row) = mask.row(row) & ~garages.row(row);
  return 2 * rest.count() < mask.count() ? mask : rest;
}

std::vector<CropFoundation> candidates_of(Foundation type, const CropAnswer& answer,
                                          const CropBits& pixels,
                                          const FoundationOptions& options) {
  CornerPeaks peaks;
  for (int corner = 0; corner < 4; ++corner) {
    peaks[corner] = find_peaks(answer.map(first_corner_map(type) + corner), options.peaks);
  }
  RectangleSetOptions sets = options.sets;
  sets.candidates.at_most = options.per_foundation;
  if (type == Foundation::kL) return l_candidates(peaks, pixels, sets.candidates);
  if (type == Foundation::kU) return u_candidates(peaks, pixels, sets.candidates);
  return rectangle_sets(rectangle_candidates(peaks, pixels, sets.candidates), num_components(type),
                        pixels, sets);
}

}  // namespace

std::string check(const FoundationOptions& options) {
  if (!(options.per_foundation >= 1)) return "per_foundation must be >= 1";
  if (!(options.at_most >= 1)) return "at_most must be >= 1";
  if (!(options.least_probability >= 0.0 && options.least_probability <= 1.0)) {
    return "least_probability must be in [0, 1]";
  }
  if (!(options.score_weight >= 0.0 && options.score_weight <= 100.0)) {
    return "score_weight must be in [0, 100]";
  }
  for (const std::string& bad :
       {check(options.peaks), check(options.sets), check(options.garages)}) {
    if (!bad.empty()) return bad;
  }
  return {};
}

std::vector<CropFoundation> foundation_hypotheses(const HouseCrop& crop, const CropAnswer& answer,
                                                  const FoundationOptions& options) {
  CHECK(check(options).empty()) << check(options);
  CHECK_EQ(answer.maps.size(), kNumCropMaps * kCropPixels);
  const CropBits pixels = foundation_pixels(crop, answer, options.garages);
  std::vector<CropFoundation> out;
  if (pixels.empty()) return out;
  const auto probability = [&](Foundation type) {
    return static_cast<double>(answer.foundation[static_cast<size_t>(type)]);
  };
  const auto add = [&](Foundation type) {
    for (CropFoundation& candidate : candidates_of(type, answer, pixels, options)) {
      candidate.log_probability =
          std::log(std::max(probability(type), std::numeric_limits<double>::min()));
      out.push_back(std::move(candidate));
    }
  };
  const Foundation likeliest = *std::max_element(
      std::begin(kTypes), std::end(kTypes),
      [&](Foundation a, Foundation b) { return probability(a) < probability(b); });
  for (const Foundation type : kTypes) {
    if (type == likeliest || probability(type) >= options.least_probability) add(type);
  }
  if (out.empty()) add(Foundation::kI);
  const auto worth = [&](const CropFoundation& f) {
    return f.log_probability + options.score_weight * candidate_score(f, options.sets.candidates);
  };
  std::stable_sort(out.begin(), out.end(), [&](const CropFoundation& a, const CropFoundation& b) {
    return worth(a) > worth(b);
  });
  if (static_cast<int>(out.size()) > options.at_most) out.resize(options.at_most);
  return out;
}

}  // namespace gable
