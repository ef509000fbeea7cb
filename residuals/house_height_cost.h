#pragma once

#include <ceres/cost_function.h>
#include <gable/grammar/house.h>
#include <gable/residuals/compressed.h>
#include <gable/residuals/height_image.h>
#include <gable/residuals/robust_loss.h>

#include <vector>

namespace gable {

/// How a house's height field is compared with a height image.
struct HeightCostOptions {
  /// Width of a sample's square support, metres, (0, 100]; that of the image's spread where this is
  /// narrower.
  double support = 0.5;
  LossKind loss = LossKind::kSoftL1;
  double loss_scale = 0.3;  ///< metres, (0, 100]
  int stride = 1;           ///< every stride-th pixel of every stride-th row is used, >= 1
};

/// The comparison of one house with one height image. A sample p sees the layers k of
/// grammar/height_field.h with heights z_k and visible shares w_k, and the terrain with the rest.
/// A height image holds first returns, which come from one surface each and are no means over the
/// support; so the sample costs the mean of what its layers would cost,
///
///   E(p) = sum_k w_k rho(z_k - height) + w_ground rho(ground - height),
///
/// and its residual is sqrt(E), signed where it sees one layer only. Edges feel every pixel that
/// would fit better on their other side, whatever the loss, and roofs are not bent by pixels
/// beside them. Where heights are means (HeightImage::spread > 0), they are compared with the
/// height field's mean over the support instead, h(p) = sum_k w_k z_k + w_ground ground, the z_k by
/// RoofSampling::kMean: E(p) = rho(h(p) - height), and the residual keeps its sign. Parameter
/// blocks: House::derivation().
///
/// Pixels are never resampled: the azimuth turns the sample points. Derivatives are taken with
/// respect to the values of the blocks that a pixel sees and summed per pair of blocks; the chain
/// to the parameters is applied once to the sums.
class HouseHeightEvaluator {
 public:
  /// `house` gives the structure (kinds and numbers of rules), `image` must outlive this object.
  HouseHeightEvaluator(const House& house, const HeightImage* image,
                       const HeightCostOptions& options);

  /// Sum of squared robust residuals; half of it is the cost. parameters: one pointer per rule.
  double squared_residuals(double const* const* parameters) const;

  /// The normal equations over all parameters, in derivation order.
  void normal_equations(double const* const* parameters, NormalEquations* normal) const;

  const House& house() const { return house_; }
  int num_parameters() const { return num_parameters_; }
  /// First position of each rule's parameters in the normal equations.
  const std::vector<int>& offsets() const { return offsets_; }
  /// Number of pixels compared (weight > 0, after the stride).
  int num_samples() const { return num_samples_; }

 private:
  struct Sums;
  template <bool kDerivatives>
  double accumulate(double const* const* parameters, Sums* sums) const;

  House house_;
  const HeightImage* image_;
  HeightCostOptions options_;
  std::vector<int> offsets_;
  int num_parameters_ = 0;
  int num_samples_ = 0;
  // Running sums along each used row of the cost that pixels have where no block is seen.
  std::vector<double> ground_cost_;
};

/// HouseHeightEvaluator as a Ceres cost function of (number of parameters + 1) residuals. The
/// robust loss is inside: add it to a problem without one.
///
/// The last point evaluated with a Jacobian is remembered: within bounds, Ceres asks for the same
/// point up to three times a step (line search, cost, linearisation). So one object must not be
/// evaluated by two threads at once; give each problem its own.
class HouseHeightCost : public ceres::CostFunction {
 public:
  HouseHeightCost(const House& house, const HeightImage* image, const HeightCostOptions& options);

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override;

  const HouseHeightEvaluator& evaluator() const { return evaluator_; }

 private:
  HouseHeightEvaluator evaluator_;
  mutable Eigen::VectorXd last_parameters_;
  mutable std::vector<int> last_columns_;
  mutable CompressedResiduals last_;
};

}  // namespace gable
