#include <gable/residuals/point_moments.h>

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

}  // namespace gable
