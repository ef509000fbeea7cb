#pragma once

#include <ceres/autodiff_cost_function.h>
#include <gable/grammar/height_field.h>

#include <cmath>
#include <vector>

namespace gable {

/// The height residual of one pixel as a Ceres user would first write it, for houses of foundation
/// II with nothing on their roofs:  r = h(p; parameters, support, ground) - height, metres, without
/// a loss (give the problem a ceres::SoftLOneLoss). h of grammar/height_field.h, p in the local
/// frame. Parameter blocks: azimuth, two footprints, two roofs, as in House::derivation().
/// HouseHeightCost says the same of all pixels at once and much faster; this one is the yardstick.
class PixelHeightResidual {
 public:
  /// `house` gives the structure only and must outlive this. Heights: metres above House::origin.
  PixelHeightResidual(const House& house, const Eigen::Vector2d& local, double height,
                      double ground, double support)
      : house_(&house),
        sources_(block_sources(house)),
        local_(local),
        height_(height),
        ground_(ground),
        support_(support) {}

  template <typename T>
  bool operator()(const T* azimuth, const T* footprint_a, const T* footprint_b, const T* roof_a,
                  const T* roof_b, T* residual) const {
    using std::cos, std::sin;
    const T cosine = cos(azimuth[0]), sine = sin(azimuth[0]);
    const T x = cosine * local_.x() + sine * local_.y();
    const T y = cosine * local_.y() - sine * local_.x();
    const std::vector<Block<T>> blocks = {
        expand_block<T>(*house_, sources_[0], roof_a, footprint_a),
        expand_block<T>(*house_, sources_[1], roof_b, footprint_b)};
    residual[0] = height_at<T, T>(blocks, sources_, x, y, support_, ground_) - height_;
    return true;
  }

  /// kRoofA, kRoofB: sizes of the two roof rules (1 flat, 2 gable, 4 hip).
  template <int kRoofA = 4, int kRoofB = 4>
  static ceres::CostFunction* create(const House& house, const Eigen::Vector2d& local,
                                     double height, double ground, double support) {
    return new ceres::AutoDiffCostFunction<PixelHeightResidual, 1, 1, 4, 4, kRoofA, kRoofB>(
        new PixelHeightResidual(house, local, height, ground, support));
  }

 private:
  const House* house_;
  std::vector<BlockSource> sources_;
  Eigen::Vector2d local_;
  double height_, ground_, support_;
};

}  // namespace gable
