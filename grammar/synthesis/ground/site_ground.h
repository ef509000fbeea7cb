#pragma once

#include <gable/grammar/random.h>
#include <gable/grammar/raster.h>

#include <Eigen/Core>
#include <array>

namespace gable {

/// The ground around one building: a slope of up to a tenth, bent a little.
class SiteGround {
 public:
  SiteGround(const Eigen::Vector2d& center, Random* random);

  /// Height above sea level at a world point, metres.
  double at(const Eigen::Vector2d& world) const {
    const Eigen::Vector2d p = world - center_;
    const double along = bend_.dot(p);
    return height_ + gradient_.dot(p) + curvature_ * along * along;
  }
  HeightRaster on(const Grid& grid) const;

 private:
  Eigen::Vector2d center_, gradient_, bend_;
  double height_ = 0.0, curvature_ = 0.0;
};

/// Adds what a derived terrain gets wrong: a smooth error within +-`most` metres, of waves some
/// 10-40 m long.
void add_terrain_error(double most, Random* random, HeightRaster* terrain);

}  // namespace gable
