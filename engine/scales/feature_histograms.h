#pragma once

#include <gable/engine/scales/scale_features.h>
#include <gable/engine/scales/shape_plane.h>

#include <Eigen/Core>
#include <array>
#include <cstdint>

namespace gable {

/// What the features need of a shape.
struct ShapeOutline {
  Eigen::Vector3d centroid;  ///< metres
  Eigen::Vector3d normal;    ///< unit, of either sign
  double size = 0.0;         ///< number of points, or area
};

/// The histograms behind ScaleFeatures as counts, to which pairs of adjacent shapes are added and
/// from which they are removed as shapes merge, so that a step costs only the pairs it touches.
class FeatureHistograms {
 public:
  /// `diagonal` of the bounding box, metres: distances are counted relative to it.
  explicit FeatureHistograms(double diagonal) : diagonal_(diagonal) {}

  void add(const ShapeOutline& a, const ShapeOutline& b) { count(a, b, 1); }
  void remove(const ShapeOutline& a, const ShapeOutline& b) { count(a, b, -1); }

  /// The normalised histograms.
  ScaleFeatures features() const;

 private:
  void count(const ShapeOutline& a, const ShapeOutline& b, int64_t by);

  double diagonal_;
  int64_t pairs_ = 0;
  std::array<int64_t, kNumFeatures> counts_{};
};

}  // namespace gable
