#pragma once

#include <gable/engine/scales/refit_shapes.h>
#include <gable/engine/scales/scale_model.h>
#include <gable/grammar/solid/plane.h>
#include <gable/residuals/height_image.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace gable {

/// How a house's heights are taken apart into planes. The defaults are for cells of 0.25 to 1 m.
struct HouseScalesOptions {
  int neighbours = 12;        ///< k of the neighbour graph, [4, 50]: within two cells on a raster
  double max_angle = 0.4363;  ///< between a pixel's normal and its plane's, radians, (0, 1.5708)
  double least_area = 2.0;  ///< of a first plane in plan, square metres, > 0; five pixels at least
  double epsilon_deviations = 3.0;  ///< of a pixel's distance to its plane, in noises, [1, 10]
  double least_noise = 0.05;        ///< of the heights, metres, > 0
  double most_noise = 0.25;         ///< metres, >= least_noise
  /// Without a model: how far heights may stray from the planes of the roofs and of the blocks
  /// before more planes pay, metres, > 0. The details' is the noise.
  double roof_deviation = 0.15;
  double block_deviation = 1.0;
  int most_points = 3000;  ///< larger houses are thinned to every n-th row and column, [100, 1e6]
  double steepest = 3.0;   ///< slope of the steepest plane that is returned, > 0; others are walls
  RefitOptions refit;
};

/// Empty if the options are in range; otherwise names the violated bound.
std::string check(const HouseScalesOptions& options);

/// A plane of a house in the image's local frame, heights in metres above origin.z().
struct HousePlane {
  Plane plane;
  std::vector<int>
      pixels;  ///< indices into the image, ascending: those of them that were looked at
  Eigen::Vector2d centroid = Eigen::Vector2d::Zero();  ///< of the pixels' centres, local
  double rms = 0.0;                                    ///< of their vertical distances, metres
};

/// The planes of a house at one structural scale, those of most pixels first.
struct HouseScale {
  int configuration = 0;  ///< of the trajectory
  std::vector<HousePlane> planes;
  double coverage = 0.0;  ///< share of the pixels looked at that lie in planes, [0, 1]
};

/// The structural scales of a house, finest first.
struct HouseScales {
  enum { kDetails, kRoofs, kBlocks };
  std::array<HouseScale, 3> scales;
  double noise = 0.0;  ///< standard deviation of the heights about local planes, metres
  int stride = 1;      ///< every so many-th row and column was looked at
  int num_points = 0;  ///< pixels looked at
  int num_first = 0;   ///< planes that the trajectory begins with

  const HouseScale& details() const { return scales[kDetails]; }
  const HouseScale& roofs() const { return scales[kRoofs]; }    ///< the planes of LoD 2
  const HouseScale& blocks() const { return scales[kBlocks]; }  ///< one plane a block
};

/// Takes the heights inside a house apart into planes at its structural scales (CVPR 2018): the
/// inside pixels that are evidence as a cloud, first planes, their trajectory, and three of its
/// configurations with their planes refitted together.
///
/// Which configurations: with a `model`, the first ones of its first, middle and last label.
/// Without, `cheapest_configuration` at the deviation of each scale: a house has so few planes that
/// the histograms which a model judges by are nearly empty. Deterministic; an image without planes
/// has scales without planes.
HouseScales house_scales(const HeightImage& image, const ScaleModel* model,
                         const HouseScalesOptions& options = {});

}  // namespace gable
