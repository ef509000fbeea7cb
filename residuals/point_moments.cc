#include <gable/residuals/point_moments.h>

#include <Eigen/Geometry>
#include <cassert>

namespace gable {

void PointMoments::add(const Eigen::Vector3d& point, double w) {
  const Eigen::Vector3d p = point - reference;
  weight += w;
  sum += w * p;
  squares += w * p * p.transpose();
}

PointMoments& PointMoments::operator+=(const PointMoments& other) {
  assert(reference == other.reference);
  weight += other.weight;
  sum += other.sum;
  squares += other.squares;
  return *this;
}

Eigen::Vector3d PointMoments::centroid() const {
  return weight > 0.0 ? Eigen::Vector3d(reference + sum / weight) : reference;
}

Eigen::Matrix3d PointMoments::scatter() const {
  if (!(weight > 0.0)) return Eigen::Matrix3d::Zero();
  return squares - sum * sum.transpose() / weight;
}

PointMoments moments_of(std::span<const Eigen::Vector3d> points) {
  PointMoments moments;
  if (!points.empty()) moments.reference = points.front();
  for (const Eigen::Vector3d& p : points) moments.add(p);
  return moments;
}

PointMoments triangle_moments(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                              const Eigen::Vector3d& c, const Eigen::Vector3d& reference) {
  PointMoments out;
  out.reference = reference;
  out.weight = 0.5 * (b - a).cross(c - a).norm();
  const Eigen::Vector3d corners[3] = {a - reference, b - reference, c - reference};
  const Eigen::Vector3d sum = corners[0] + corners[1] + corners[2];
  out.sum = out.weight / 3.0 * sum;
  out.squares = sum * sum.transpose();
  for (const Eigen::Vector3d& corner : corners) out.squares += corner * corner.transpose();
  out.squares *= out.weight / 12.0;
  return out;
}

}  // namespace gable
