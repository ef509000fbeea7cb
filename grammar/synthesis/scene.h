#pragma once

#include <gable/grammar/synthesis/ground/vegetation.h>
#include <gable/grammar/synthesis/houses/prior.h>
#include <gable/grammar/synthesis/survey/lidar.h>

#include <cstdint>
#include <string>
#include <vector>

namespace gable {

/// A crop around one house, as refinement and training see it.
struct SceneOptions {
  uint64_t seed = 1;
  int size = 64;            ///< cells a side, >= 8
  double gsd = 0.5;         ///< metres, > 0
  int trees = 1;            ///< beside the house, crowns overlapping its walls by up to 1 m, >= 0
  double slope = 0.03;      ///< largest slope of the terrain, a plane, >= 0
  double off_center = 0.5;  ///< the house is off the crop's centre by up to this, metres, >= 0
  LidarOptions lidar{};     ///< noise and outliers
  PriorOptions prior{};     ///< what details the house has

  /// Empty, or one line that names the bound that does not hold.
  std::string check() const;
};

struct Scene {
  House house;         ///< the truth; `house.origin` places it in the crop's world
  HeightRaster dsm;    ///< surveyed: house, trees, noise, outliers
  HeightRaster dtm;    ///< the terrain, without noise
  HeightRaster truth;  ///< the terrain with the house alone, without noise
  std::vector<Tree> trees;
};

/// A scene around a random house of the given type (not kC).
Scene make_scene(Foundation foundation, const SceneOptions& options);

/// A scene around a given house; its origin is set by the scene.
Scene make_scene(const House& house, const SceneOptions& options);

}  // namespace gable
