#pragma once

#include <gable/grammar/random.h>

#include <Eigen/Core>
#include <vector>

namespace gable {

/// Gentle ground: a tilted plane and a few long waves, smooth everywhere.
class Terrain {
 public:
  /// `steepness`: about the largest slope, a ratio; heights are around `height` metres near
  /// `center` (world).
  Terrain(const Eigen::Vector2d& center, double height, double steepness, Random* random);

  /// Height above sea level at a world point, metres.
  double at(const Eigen::Vector2d& world) const;

 private:
  struct Wave {
    Eigen::Vector2d frequency;  ///< radians per metre
    double phase;
    double amplitude;  ///< metres
  };
  Eigen::Vector2d center_;
  double height_;
  Eigen::Vector2d tilt_;
  std::vector<Wave> waves_;
};

}  // namespace gable
