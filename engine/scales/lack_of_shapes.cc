#include <gable/engine/scales/lack_of_shapes.h>

#include <Eigen/Eigenvalues>
#include <cmath>

namespace gable {
namespace {

/// Thickness below which points are a line, relative to its length: far above what rounding does
/// to double coordinates, far below what scanners can see.
constexpr double kLineThickness = 1e-6;

}  // namespace

std::string lack_of_shapes(const Scan& scan, const FirstShapesOptions& options) {
  const size_t n = scan.points.size();
  if (!scan.is_mesh() && n < static_cast<size_t>(options.min_inliers)) {
    return "it has " + std::to_string(n) + (n == 1 ? " point" : " points") + ", a shape needs " +
           std::to_string(options.min_inliers);
  }
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p : scan.points) mean += (p - scan.points[0]) / n;
  mean += scan.points[0];
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& p : scan.points) scatter += (p - mean) * (p - mean).transpose();
  const Eigen::Vector3d widths =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(scatter, Eigen::EigenvaluesOnly)
          .eigenvalues()
          .cwiseMax(0.0)
          .cwiseSqrt();
  const double size = std::sqrt(static_cast<double>(n)) * mean.norm();
  if (widths[2] <= 1e-12 * size || widths[2] == 0.0) return "all its points are at one place";
  if (widths[1] <= kLineThickness * widths[2]) return "all its points lie on a line";
  if (scan.is_mesh()) return "none of its facets has an area";
  return "nowhere do " + std::to_string(options.min_inliers) +
         " neighbouring points lie on a plane, try a larger epsilon";
}

}  // namespace gable
