#include <gable/residuals/moments_to_plane.h>

#include <Eigen/Eigenvalues>
#include <cmath>

namespace gable {

MomentsToPlane::MomentsToPlane(const PointMoments& moments) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(moments.scatter());
  // Rounding can leave the scatter of exactly coplanar points a hair below zero.
  const Eigen::Vector3d roots = eigen.eigenvalues().cwiseMax(0.0).cwiseSqrt();
  const double root_weight = std::sqrt(moments.weight);
  jacobian_.setZero();
  jacobian_.topLeftCorner<3, 3>() = roots.asDiagonal() * eigen.eigenvectors().transpose();
  jacobian_.block<1, 3>(3, 0) = root_weight * moments.centroid().transpose();
  jacobian_(3, 3) = -root_weight;
}

bool MomentsToPlane::Evaluate(double const* const* parameters, double* residuals,
                              double** jacobians) const {
  const Eigen::Map<const Eigen::Vector4d> plane(parameters[0]);
  Eigen::Map<Eigen::Vector4d> out(residuals);
  out = jacobian_ * plane;
  if (jacobians != nullptr && jacobians[0] != nullptr) {
    Eigen::Map<Eigen::Matrix<double, 4, kPlaneSize, Eigen::RowMajor>> jacobian(jacobians[0]);
    jacobian = jacobian_;
  }
  return true;
}

}  // namespace gable
