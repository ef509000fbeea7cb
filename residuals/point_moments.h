#pragma once

#include <Eigen/Core>
#include <span>

namespace gable {

/// Weighted moments of a set of points up to order two: all that a least-squares plane needs of
/// them. Sums are kept relative to `reference`, so that coordinates far from the origin lose
/// nothing; sets with the same reference are united by adding.
struct PointMoments {
  Eigen::Vector3d reference = Eigen::Vector3d::Zero();
  double weight = 0.0;                                ///< sum of weights; the count if all are 1
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();      ///< sum of w (p - reference), metres
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();  ///< sum of w (p - reference)(p - reference)'

  void add(const Eigen::Vector3d& point, double w = 1.0);
  /// Unites with a set of the same reference.
  PointMoments& operator+=(const PointMoments& other);

  Eigen::Vector3d centroid() const;
  /// Sum of w (p - centroid)(p - centroid)', square metres.
  Eigen::Matrix3d scatter() const;
};

/// Moments of points with weight 1, relative to their first.
PointMoments moments_of(std::span<const Eigen::Vector3d> points);

/// Moments of a triangle's surface, each square metre of which weighs 1: exact integrals.
PointMoments triangle_moments(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                              const Eigen::Vector3d& c, const Eigen::Vector3d& reference);

}  // namespace gable
