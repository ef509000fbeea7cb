#pragma once

#include <ceres/sized_cost_function.h>
#include <gable/residuals/oriented_plane.h>
#include <gable/residuals/point_moments.h>

namespace gable {

/// All points of a plane at once, through their moments: four residuals whose cost, gradient and
/// Gauss-Newton Hessian are exactly those of PointToPlane (with weights sqrt(w)) over every point.
///
/// Derivation. With W, c and S the points' weight, centroid and scatter, sum w (n.p - d)^2 is
/// n'S n + W (n.c - d)^2: the cross term vanishes about the centroid. Residuals are A n, with
/// A'A = S, then sqrt(W) (n.c - d); they are linear in the plane, so the Jacobian is constant.
/// Same frame for points and plane; metres times the square root of the weight's unit.
/// Parameter block: OrientedPlane::values. A robust loss weights single points: reweight the
/// moments, see engine/solver/plane_refinement.h.
class MomentsToPlane : public ceres::SizedCostFunction<4, kPlaneSize> {
 public:
  explicit MomentsToPlane(const PointMoments& moments);

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override;

 private:
  Eigen::Matrix<double, 4, kPlaneSize, Eigen::RowMajor> jacobian_;
};

}  // namespace gable
