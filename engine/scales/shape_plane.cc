#include <gable/engine/scales/shape_plane.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace gable {

ShapePlane shape_plane(const PointMoments& moments) {
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen;
  eigen.computeDirect(moments.scatter());
  ShapePlane plane;
  plane.centroid = moments.centroid();
  plane.normal = eigen.eigenvectors().col(0);
  plane.rms = std::sqrt(std::max(0.0, eigen.eigenvalues()[0]) / moments.weight);
  plane.width = std::sqrt(std::max(0.0, eigen.eigenvalues()[1]) / moments.weight);
  return plane;
}

double plane_rms(const PointMoments& moments) {
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen;
  eigen.computeDirect(moments.scatter(), Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(0.0, eigen.eigenvalues()[0]) / moments.weight);
}

}  // namespace gable
