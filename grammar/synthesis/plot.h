#pragma once

#include <gable/grammar/height_field.h>
#include <gable/grammar/synthesis/houses/rectangle.h>

#include <Eigen/Core>
#include <vector>

namespace gable {

/// A house that has its place in the world, with what it takes to measure distances from it.
class Plot {
 public:
  explicit Plot(const House& house);

  /// Distance of a world point from the house with its garages, 0 inside, metres.
  double distance(const Eigen::Vector2d& world) const;

  /// Distance between two houses with their garages, 0 where they touch or overlap, metres.
  double distance(const Plot& other) const;

  /// Whether the houses may be closer than `gap`: a quick test of the circles around them.
  bool may_be_closer(const Plot& other, double gap) const {
    return (center_ - other.center_).norm() < radius_ + other.radius_ + gap;
  }
  bool may_be_closer(const Eigen::Vector2d& world, double gap) const {
    return (center_ - world).norm() < radius_ + gap;
  }

  const House& house() const { return house_; }

  /// Last point of the house seen from its origin in a direction (unit vector, local frame):
  /// distance from the origin, metres.
  double edge_towards(const Eigen::Vector2d& direction) const;

 private:
  Eigen::Vector2d house_from_world(const Eigen::Vector2d& world) const;
  std::vector<Eigen::Vector2d> world_corners(const Rectangle& rectangle) const;

  House house_;
  HeightField field_;
  std::vector<Rectangle> rectangles_;
  Eigen::Vector2d center_;
  double radius_ = 0.0;
};

}  // namespace gable
