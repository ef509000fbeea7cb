#pragma once

#include <gable/grammar/solid/extrusion.h>
#include <gable/grammar/synthesis/ground/vegetation.h>
#include <gable/grammar/synthesis/houses/prior.h>
#include <gable/grammar/synthesis/survey/lidar.h>

#include <cstdint>
#include <string>
#include <vector>

namespace gable {

struct VillageOptions {
  int count = 40;  ///< houses, >= 1
  uint64_t seed = 1;
  double gsd = 0.5;              ///< metres, in [0.1, 2]
  double gap = 3.0;              ///< least distance between houses, garages included, metres, >= 0
  double steepness = 0.05;       ///< about the largest slope of the terrain, in [0, 0.3]
  double dtm_noise = 0.02;       ///< standard deviation of the DTM's noise, metres, >= 0
  double trees_per_house = 1.5;  ///< clear of the houses, >= 0
  double touching_trees = 0.12;  ///< houses with a tree that reaches over their wall, [0, 1]
  double hedge_share = 0.5;      ///< front and side boundaries with a hedge, [0, 1]
  double margin = 24.0;          ///< terrain around the outermost houses, metres, >= 0
  /// Outer corner of the first cell, world; in the middle of EPSG:27700 by default.
  Eigen::Vector2d north_west = {400000.0, 200000.0};
  LidarOptions lidar{};
  PriorOptions prior{};  ///< foundation_weights become shares of the houses, not chances

  /// Empty, or one line that names the bound that does not hold.
  std::string check() const;
};

/// A surveyed village and its truth, one entry per house in `houses`, `base` and `footprints`.
struct Village {
  std::vector<House> houses;            ///< origin: the terrain's height at the house's centre
  std::vector<double> base;             ///< lowest terrain at the wall, relative to origin.z, <= 0
  std::vector<PlanPolygon> footprints;  ///< world frame, garages included
  std::vector<Tree> trees;
  std::vector<Hedge> hedges;
  HeightRaster dsm;    ///< surveyed: houses, trees, hedges, noise
  HeightRaster dtm;    ///< terrain with its small noise
  HeightRaster truth;  ///< noise-free heights of the houses, NaN elsewhere
};

/// Houses of the prior along winding streets on gentle ground. The same options give the same
/// village, bit for bit.
Village synthesize_village(const VillageOptions& options);

}  // namespace gable
