#include <gable/engine/solver/plane_uncertainty.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace gable {

double PlaneUncertainty::angle_deviation() const {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(normal, Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(0.0, eigen.eigenvalues()[2]));
}

PlaneUncertainty plane_uncertainty(const OrientedPlane& plane, const PointMoments& moments) {
  PlaneUncertainty out;
  out.centroid = moments.centroid();
  const Eigen::Matrix3d scatter = moments.scatter();
  const double off = plane.signed_distance(out.centroid);
  const double squares =
      std::max(0.0, plane.normal().dot(scatter * plane.normal())) + moments.weight * off * off;
  const double variance = squares / std::max(1.0, moments.weight - 3.0);
  out.noise = std::sqrt(variance);
  if (moments.weight > 0.0) out.distance = variance / moments.weight;

  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(scatter);
  const Eigen::Vector3d& lambda = eigen.eigenvalues();
  for (int i = 1; i < 3; ++i) {
    const double gap = lambda[i] - std::max(0.0, lambda[0]);
    const double turn = variance * lambda[i];  // over gap^2
    const Eigen::Vector3d direction = eigen.eigenvectors().col(i);
    out.normal += (turn < gap * gap ? turn / (gap * gap) : 1.0) * direction * direction.transpose();
  }
  return out;
}

}  // namespace gable
