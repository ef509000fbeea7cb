#include <gable/engine/detectors/house_crop.h>
#include <gable/engine/detectors/peaks.h>
#include <glog/logging.h>

#include <algorithm>

namespace gable {
namespace {

// Where the parabola through three values at -1, 0, 1 is highest; `middle` is none of the lowest.
double vertex(double before, double middle, double after) {
  const double curvature = before - 2.0 * middle + after;
  if (!(curvature < 0.0)) return 0.0;
  return std::clamp(0.5 * (before - after) / curvature, -0.5, 0.5);
}

// Whether no pixel within the radius is higher, nor as high and earlier.
bool is_peak(std::span<const float> map, int row, int col, int radius) {
  const float value = map[static_cast<size_t>(row) * kCropSize + col];
  for (int r = std::max(0, row - radius); r <= std::min(kCropSize - 1, row + radius); ++r) {
    for (int c = std::max(0, col - radius); c <= std::min(kCropSize - 1, col + radius); ++c) {
      const float other = map[static_cast<size_t>(r) * kCropSize + c];
      const bool earlier = r < row || (r == row && c < col);
      if (other > value || (other == value && earlier)) return false;
    }
  }
  return true;
}

}  // namespace

std::string check(const PeakOptions& options) {
  if (!(options.threshold > 0.0 && options.threshold <= 1.0)) return "threshold must be in (0, 1]";
  if (!(options.radius >= 1 && options.radius <= 16)) return "radius must be in [1, 16]";
  if (!(options.at_most >= 1)) return "at_most must be >= 1";
  return {};
}

std::vector<Peak> find_peaks(std::span<const float> map, const PeakOptions& options) {
  CHECK_EQ(map.size(), kCropPixels);
  CHECK(check(options).empty()) << check(options);
  const auto value = [&](int row, int col) {
    return static_cast<double>(map[static_cast<size_t>(row) * kCropSize + col]);
  };
  std::vector<Peak> peaks;
  for (int row = 0; row < kCropSize; ++row) {
    for (int col = 0; col < kCropSize; ++col) {
      if (!(value(row, col) >= options.threshold)) continue;
      if (!is_peak(map, row, col, options.radius)) continue;
      Peak peak;
      peak.value = value(row, col);
      peak.crop = {col + 0.5, row + 0.5};
      if (col > 0 && col + 1 < kCropSize) {
        peak.crop.x() += vertex(value(row, col - 1), peak.value, value(row, col + 1));
      }
      if (row > 0 && row + 1 < kCropSize) {
        peak.crop.y() += vertex(value(row - 1, col), peak.value, value(row + 1, col));
      }
      peaks.push_back(peak);
    }
  }
  std::stable_sort(peaks.begin(), peaks.end(),
                   [](const Peak& a, const Peak& b) { return a.value > b.value; });
  if (static_cast<int>(peaks.size()) > options.at_most) peaks.resize(options.at_most);
  return peaks;
}

}  // namespace gable
