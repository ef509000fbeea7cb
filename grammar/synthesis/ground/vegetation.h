#pragma once

#include <gable/grammar/random.h>
#include <gable/grammar/raster.h>

#include <Eigen/Core>

namespace gable {

/// A tree as the first return of a survey shows it.
struct Tree {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();  ///< world, metres
  double radius = 2.5;                               ///< of the crown, metres
  double height = 6.0;                               ///< of its top over the ground, metres
};

/// A hedge: a straight strip, mostly below 2 m.
struct Hedge {
  Eigen::Vector2d from = Eigen::Vector2d::Zero();  ///< world, metres
  Eigen::Vector2d to = Eigen::Vector2d::Zero();
  double width = 0.9;   ///< metres
  double height = 1.4;  ///< over the ground, metres
};

/// A tree with a crown of 1.5-4 m radius and 3-10 m height, wide ones high.
Tree random_tree(const Eigen::Vector2d& center, Random* random);

/// Raises `surface` to a crown: half an ellipsoid with a ragged edge, each cell lowered by a random
/// depth into the leaves (0.5 m typical), one in eight seen through to the ground or the roof
/// below.
void add_tree(const Tree& tree, const HeightRaster& ground, Random* random, HeightRaster* surface);

/// Raises `surface` to a hedge, each cell 0.15 m rough.
void add_hedge(const Hedge& hedge, const HeightRaster& ground, Random* random,
               HeightRaster* surface);

}  // namespace gable
