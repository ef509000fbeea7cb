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
  const double across = std::max(0.0, plane.normal().dot(scatter * plane.normal()));
  const double squares = across + moments.weight * off * off;
  const double variance = squares / std::max(1.0, moments.weight - 3.0);
  out.noise = std::sqrt(variance);
  if (moments.weight > 0.0) out.distance = variance / moments.weight;

  Eigen::Matrix<double, 3, 2> along;
  along.col(0) = plane.normal().unitOrthogonal();
  along.col(1) = plane.normal().cross(along.col(0));
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen(along.transpose() * scatter * along);
  for (int i = 0; i < 2; ++i) {
    const double spread = eigen.eigenvalues()[i];
    const double gap = std::max(0.0, spread - across);
    const double turn = variance * spread;  // over gap^2
    const Eigen::Vector3d direction = along * eigen.eigenvectors().col(i);
    out.normal += (turn < gap * gap ? turn / (gap * gap) : 1.0) * direction * direction.transpose();
  }
  return out;
}

}  // namespace gable
