#pragma once

#include <gable/engine/closing/closing_options.h>
#include <gable/engine/scales/planar_shape.h>
#include <gable/engine/scan.h>
#include <gable/grammar/solid/solid.h>

#include <Eigen/Core>
#include <string>
#include <vector>

namespace gable {

/// How the shapes of a scan are closed into solids. The scan is taken for metres with z up.
struct ScanSolidOptions {
  ClosingOptions closing = {.max_lines = 60, .max_grid = 2000};
  /// Shapes whose normals point up (or down) by less than this are walls, (0, 1].
  double least_up = 0.25;
  /// The outline's corners nearer than this to the line between their neighbours are left out,
  /// metres, [0, 100]; at least two spacings of the points and three times the scale's RMS.
  double outline_tolerance = 0.3;
  /// Pieces of the plan smaller than this share of the largest get no solid, [0, 1].
  double least_piece = 0.02;
  int most_planes = 48;      ///< those of most elements that are closed, [1, 1000]
  int most_samples = 60000;  ///< that a scan is thinned or a mesh is sampled to, [100, 1e7]
};

/// Empty if the options are in range; otherwise names the violated bound.
std::string check(const ScanSolidOptions& options);

/// A scan at one scale as a closed piecewise-planar model (CVPR 2018, figure 8).
struct ScanSolid {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< scan less this is the solids' frame
  std::vector<Solid> solids;                         ///< valid, metres
  int planes = 0;      ///< of the roofs, those of the ground around a building among them
  int facets = 0;      ///< of all solids
  int triangles = 0;   ///< that the facets fall into
  double rms = 0.0;    ///< of the scan's points (facets by area) to the solids' surface, metres
  double mean = 0.0;   ///< their mean distance, metres
  std::string reason;  ///< why there are no solids; empty where there are
};

/// Closes the shapes of a scale in 2.5D: what is seen of them from above, between a level base
/// under the lowest point and their planes, over the outline of the scan's points in plan. Walls
/// are vertical, overhangs and undersides are not there. Deterministic.
ScanSolid close_scale(const Scan& scan, const ScaleShapes& scale, const ScanSolidOptions& options);

}  // namespace gable
