#pragma once

#include <gable/grammar/solid/roof_partition.h>

#include <Eigen/Core>
#include <vector>

namespace gable {

/// What around a corner of the plan one plane covers.
struct RoofSector {
  Eigen::Vector2d into = Eigen::Vector2d::UnitX();  ///< unit, from the corner into its middle
  int plane = -1;                                   ///< -1: outside the roof
};

/// A corner of the plan around which the roof is higher than something in more than one direction,
/// and lower between, so that two bodies touch in a vertical edge; or at which a region touches
/// itself.
struct RoofSaddle {
  Eigen::Vector2d place = Eigen::Vector2d::Zero();
  std::vector<RoofSector> sectors;  ///< anticlockwise
};

/// A corner of the plan that is too near to another one or to a boundary that it does not end.
struct CrowdedCorner {
  Eigen::Vector2d place = Eigen::Vector2d::Zero();
  /// Or of which these planes are at nearly but not quite one height.
  std::vector<int> nearly_level;
};

/// Why there would be no valid solid over a roof.
struct RoofDefects {
  std::vector<CrowdedCorner> crowded;
  std::vector<RoofSaddle> saddles;
};

/// Defects of a roof whose solid is to have no vertices nearer than `least`, metres, to each other
/// or to edges that they do not end. In the order of the regions' corners.
RoofDefects find_roof_defects(const RoofPartition& roof, double least);

}  // namespace gable
