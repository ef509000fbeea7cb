#pragma once

#include <Eigen/Core>
#include <vector>

namespace gable {

/// A non-vertical plane z = a x + b y + c.
struct Plane {
  double a = 0.0, b = 0.0, c = 0.0;

  double at(const Eigen::Vector2d& p) const { return a * p.x() + b * p.y() + c; }
};

/// The distinct planes of a house. Facets that lie in one plane get one number, so that they are
/// later recognised as one surface.
class PlaneSet {
 public:
  /// `low`, `high`: corners of the region over which planes are compared, metres.
  PlaneSet(const Eigen::Vector2d& low, const Eigen::Vector2d& high) : low_(low), high_(high) {}

  /// Number of the plane: an earlier one where both differ by less than 0.1 mm over the region.
  int number_of(const Plane& plane);

  const std::vector<Plane>& planes() const { return planes_; }

 private:
  Eigen::Vector2d low_, high_;
  std::vector<Plane> planes_;
};

}  // namespace gable
