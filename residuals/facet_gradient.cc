#include <ceres/jet.h>
#include <gable/residuals/facet_gradient.h>

namespace gable {

FacetGradient facet_gradient(const Block<double>& block, Facet facet) {
  using namespace block_value;
  using Jet = ceres::Jet<double, kNumBlockValues>;
  Block<Jet> jets;
  jets.ridge = block.ridge;
  jets.flat = block.flat;
  jets.mansard = block.mansard;
  for (int k = 0; k < kNumBlockValues; ++k) jets.values[k] = Jet(block[k], k);
  FacetGradient gradient;
  // Close to the facet, so that the large terms of a short hip or a steep side do not cancel.
  gradient.anchor = 0.5 * Eigen::Vector2d(block[kX0] + block[kX1], block[kY0] + block[kY1]);
  const bool along_x = block.ridge == Axis::kX;
  double& along = along_x ? gradient.anchor.x() : gradient.anchor.y();
  if (facet == Facet::kStart) along = along_x ? block[kX0] : block[kY0];
  if (facet == Facet::kEnd) along = along_x ? block[kX1] : block[kY1];
  if (block.mansard) {
    double& across = along_x ? gradient.anchor.y() : gradient.anchor.x();
    if (facet == Facet::kLow) across = along_x ? block[kY0] : block[kX0];
    if (facet == Facet::kHigh) across = along_x ? block[kY1] : block[kX1];
  }
  const double x = gradient.anchor.x(), y = gradient.anchor.y();
  gradient.values.col(0) = facet_height<Jet, double>(jets, facet, x, y).v;
  gradient.values.col(1) =
      facet_height<Jet, double>(jets, facet, x + 1.0, y).v - gradient.values.col(0);
  gradient.values.col(2) =
      facet_height<Jet, double>(jets, facet, x, y + 1.0).v - gradient.values.col(0);
  // A roof that moves with its rectangle shows the height it had before the move.
  gradient.slope.x() = -(gradient.values(kX0, 0) + gradient.values(kX1, 0));
  gradient.slope.y() = -(gradient.values(kY0, 0) + gradient.values(kY1, 0));
  return gradient;
}

}  // namespace gable
