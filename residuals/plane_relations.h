#pragma once

#include <ceres/autodiff_cost_function.h>
#include <gable/residuals/oriented_plane.h>

#include <cmath>

namespace gable {

// Regularities of planes as residuals. Parameter blocks: OrientedPlane::values, one or two. Angles
// enter as sines or cosines (ratio, ~ radians near the regularity); `weight` turns them into the
// unit of the other residuals: with a weight of L metres an angle counts as the distance it moves
// a point L away. All are blind to the sign of the normals. z points up.

/// Parallel: r = weight * (normal_a x normal_b), three residuals of norm weight * |sin angle|.
class ParallelPlanes {
 public:
  explicit ParallelPlanes(double weight) : weight_(weight) {}

  template <typename T>
  bool operator()(const T* a, const T* b, T* residuals) const {
    residuals[0] = (a[1] * b[2] - a[2] * b[1]) * weight_;
    residuals[1] = (a[2] * b[0] - a[0] * b[2]) * weight_;
    residuals[2] = (a[0] * b[1] - a[1] * b[0]) * weight_;
    return true;
  }

  static ceres::CostFunction* create(double weight) {
    return new ceres::AutoDiffCostFunction<ParallelPlanes, 3, kPlaneSize, kPlaneSize>(
        new ParallelPlanes(weight));
  }

 private:
  double weight_;
};

/// Orthogonal: r = weight * normal_a . normal_b, one residual, weight * cos angle.
class OrthogonalPlanes {
 public:
  explicit OrthogonalPlanes(double weight) : weight_(weight) {}

  template <typename T>
  bool operator()(const T* a, const T* b, T* residual) const {
    residual[0] = (a[0] * b[0] + a[1] * b[1] + a[2] * b[2]) * weight_;
    return true;
  }

  static ceres::CostFunction* create(double weight) {
    return new ceres::AutoDiffCostFunction<OrthogonalPlanes, 1, kPlaneSize, kPlaneSize>(
        new OrthogonalPlanes(weight));
  }

 private:
  double weight_;
};

/// Coplanar: five residuals. First those of ParallelPlanes with `angle_weight`; then, in metres
/// times `distance_weight`, the signed distances of each plane's centroid (of its points, kept
/// fixed, in the frame of the other plane) to the other plane. The planes may have frames of their
/// own that differ by a shift.
class CoplanarPlanes {
 public:
  CoplanarPlanes(const Eigen::Vector3d& centroid_a, const Eigen::Vector3d& centroid_b,
                 double angle_weight, double distance_weight)
      : centroid_a_(centroid_a),
        centroid_b_(centroid_b),
        parallel_(angle_weight),
        distance_weight_(distance_weight) {}

  template <typename T>
  bool operator()(const T* a, const T* b, T* residuals) const {
    parallel_(a, b, residuals);
    residuals[3] = distance(a, centroid_b_) * distance_weight_;
    residuals[4] = distance(b, centroid_a_) * distance_weight_;
    return true;
  }

  static ceres::CostFunction* create(const Eigen::Vector3d& centroid_a,
                                     const Eigen::Vector3d& centroid_b, double angle_weight,
                                     double distance_weight) {
    return new ceres::AutoDiffCostFunction<CoplanarPlanes, 5, kPlaneSize, kPlaneSize>(
        new CoplanarPlanes(centroid_a, centroid_b, angle_weight, distance_weight));
  }

 private:
  template <typename T>
  static T distance(const T* plane, const Eigen::Vector3d& p) {
    return plane[0] * p.x() + plane[1] * p.y() + plane[2] * p.z() - plane[3];
  }

  Eigen::Vector3d centroid_a_, centroid_b_;
  ParallelPlanes parallel_;
  double distance_weight_;
};

/// Of equal slope: r = weight * (slope_a - slope_b), one residual, where a slope is the angle in
/// [0, pi / 2] between plane and horizontal. Not defined for horizontal planes.
class EquallySteepPlanes {
 public:
  explicit EquallySteepPlanes(double weight) : weight_(weight) {}

  template <typename T>
  bool operator()(const T* a, const T* b, T* residual) const {
    residual[0] = (slope(a) - slope(b)) * weight_;
    return true;
  }

  static ceres::CostFunction* create(double weight) {
    return new ceres::AutoDiffCostFunction<EquallySteepPlanes, 1, kPlaneSize, kPlaneSize>(
        new EquallySteepPlanes(weight));
  }

 private:
  template <typename T>
  static T slope(const T* plane) {
    using std::atan2;
    using std::sqrt;
    const T across = sqrt(plane[0] * plane[0] + plane[1] * plane[1]);
    return atan2(across, plane[2] < T(0.0) ? T(-plane[2]) : plane[2]);
  }

  double weight_;
};

/// Horizontal: r = weight * (normal.x, normal.y), two residuals of norm weight * sin slope.
class HorizontalPlane {
 public:
  explicit HorizontalPlane(double weight) : weight_(weight) {}

  template <typename T>
  bool operator()(const T* plane, T* residuals) const {
    residuals[0] = plane[0] * weight_;
    residuals[1] = plane[1] * weight_;
    return true;
  }

  static ceres::CostFunction* create(double weight) {
    return new ceres::AutoDiffCostFunction<HorizontalPlane, 2, kPlaneSize>(
        new HorizontalPlane(weight));
  }

 private:
  double weight_;
};

/// Vertical: r = weight * normal.z, one residual, weight * cos slope.
class VerticalPlane {
 public:
  explicit VerticalPlane(double weight) : weight_(weight) {}

  template <typename T>
  bool operator()(const T* plane, T* residual) const {
    residual[0] = plane[2] * weight_;
    return true;
  }

  static ceres::CostFunction* create(double weight) {
    return new ceres::AutoDiffCostFunction<VerticalPlane, 1, kPlaneSize>(new VerticalPlane(weight));
  }

 private:
  double weight_;
};

}  // namespace gable
