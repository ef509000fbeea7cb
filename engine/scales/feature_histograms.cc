#include <gable/engine/scales/feature_histograms.h>

#include <algorithm>
#include <cmath>

namespace gable {
namespace {

// Equal bins over [0, 1].
int equal_bin(double value, int bins) {
  return std::clamp(static_cast<int>(value * bins), 0, bins - 1);
}

// Shapes of all sizes meet along a trajectory, so the bins of their distance double in width: the
// last one starts at 0.32 of the diagonal.
int distance_bin(double share) {
  int bin = 0;
  for (double edge = 0.04; bin + 1 < kDistanceBins && share >= edge; edge *= 2.0) ++bin;
  return bin;
}

}  // namespace

void FeatureHistograms::count(const ShapeOutline& a, const ShapeOutline& b, int64_t by) {
  pairs_ += by;
  int start = 0;
  const auto put = [&](int bin, int bins) {
    counts_[start + bin] += by;
    start += bins;
  };
  put(distance_bin((a.centroid - b.centroid).norm() / diagonal_), kDistanceBins);
  put(equal_bin(std::abs(a.normal.dot(b.normal)), kAlignmentBins), kAlignmentBins);
  put(equal_bin(1.0 - std::abs(a.size - b.size) / (a.size + b.size), kAreaBins), kAreaBins);
  put(equal_bin(std::abs(std::abs(a.normal.z()) - std::abs(b.normal.z())), kVerticalBins),
      kVerticalBins);
}

ScaleFeatures FeatureHistograms::features() const {
  ScaleFeatures out{};
  if (pairs_ == 0) return out;
  for (int i = 0; i < kNumFeatures; ++i) {
    out[i] = static_cast<float>(static_cast<double>(counts_[i]) / static_cast<double>(pairs_));
  }
  return out;
}

}  // namespace gable
