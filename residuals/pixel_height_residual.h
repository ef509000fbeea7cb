#pragma once

#include <ceres/autodiff_cost_function.h>
#include <gable/grammar/height_field.h>
#include <gable/residuals/house_height_cost.h>

#include <array>
#include <cmath>
#include <vector>

namespace gable {

/// The cost of one pixel as a Ceres user would first write it, for houses of foundation II with
/// nothing on their roofs: one residual, metres, whose square is the pixel's E(p) of
/// HouseHeightEvaluator for first returns, over the layers of grammar/height_field.h. The robust
/// loss is inside: add it to a problem without one. p in the local frame, heights in metres above
/// House::origin. Parameter blocks: azimuth, two footprints, two roofs, as in House::derivation().
/// HouseHeightCost says the same of all pixels at once and much faster; this one is the yardstick.
class PixelHeightResidual {
 public:
  /// `house` gives the structure only and must outlive this; of `options` the stride is not read.
  PixelHeightResidual(const House& house, const Eigen::Vector2d& local, double height,
                      double ground, const HeightCostOptions& options)
      : house_(&house),
        sources_(block_sources(house)),
        local_(local),
        height_(height),
        ground_(ground),
        support_(options.support),
        loss_(options.loss, options.loss_scale) {}

  template <typename T>
  bool operator()(const T* azimuth, const T* footprint_a, const T* footprint_b, const T* roof_a,
                  const T* roof_b, T* residual) const {
    using std::cos, std::sin;
    const T cosine = cos(azimuth[0]), sine = sin(azimuth[0]);
    const T x = cosine * local_.x() + sine * local_.y();
    const T y = cosine * local_.y() - sine * local_.x();
    const std::array<Block<T>, 2> blocks = {
        expand_block<T>(*house_, sources_[0], roof_a, footprint_a),
        expand_block<T>(*house_, sources_[1], roof_b, footprint_b)};
    const Layers<T> seen = layers_at<T, T>(blocks, x, y, support_);
    // One surface in sight: the residual keeps its sign, which is smooth where it is zero.
    if (seen.count > 0 && seen.layers[0].share >= T(1.0 - 1e-12)) {
      residual[0] = loss_.robust(seen.layers[0].height - height_);
      return true;
    }
    T cost = seen.ground_share * loss_.cost(ground_ - height_);
    for (int k = 0; k < seen.count; ++k) {
      cost += seen.layers[k].share * loss_.cost(seen.layers[k].height - height_);
    }
    using std::sqrt;
    residual[0] = sqrt(cost < T(1e-12) ? T(1e-12) : cost);
    return true;
  }

  /// kRoofA, kRoofB: sizes of the two roof rules (1 flat, 2 gable, 4 hip).
  template <int kRoofA = 4, int kRoofB = 4>
  static ceres::CostFunction* create(const House& house, const Eigen::Vector2d& local,
                                     double height, double ground,
                                     const HeightCostOptions& options) {
    return new ceres::AutoDiffCostFunction<PixelHeightResidual, 1, 1, 4, 4, kRoofA, kRoofB>(
        new PixelHeightResidual(house, local, height, ground, options));
  }

 private:
  const House* house_;
  std::vector<BlockSource> sources_;
  Eigen::Vector2d local_;
  double height_, ground_, support_;
  RobustLoss loss_;
};

}  // namespace gable
