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
  /// Scales differ in what they are to show: boundary_cost, step_cost and plane_charge here are
  /// those of a scale whose shapes are `coarse_rms` from their elements, and others have them in
  /// proportion to their RMS. loss_scale and least_step_length are the largest, finer scales have
  /// smaller ones.
  ClosingOptions closing = {.max_lines = 1000, .max_grid = 20000};
  double coarse_rms = 0.5;  ///< metres, (0, 100]
  double least_rms = 0.02;  ///< below it all scales are alike, metres, (0, coarse_rms]
  /// Shapes whose normals point up (or down) by less than this are walls, (0, 1].
  double least_up = 0.25;
  /// The outline's corners nearer than this to the line between their neighbours are left out,
  /// metres, [0, 100]; at least the spacing of the points and three times the scale's RMS.
  double outline_tolerance = 0.3;
  /// Pieces of the plan smaller than this share of the largest get no solid, [0, 1].
  double least_piece = 0.02;
  /// Roofs that jut out over a wall by no more than this end at the wall, metres, [0, 10].
  double overhang = 1.0;
  /// Of what is seen from above, the share that the shapes offered as roofs hold, largest first,
  /// (0, 1].
  double offered_share = 0.99;
  int most_samples = 60000;  ///< that a scan is thinned or a mesh is sampled to, [100, 1e7]
};

/// Empty if the options are in range; otherwise names the violated bound.
std::string check(const ScanSolidOptions& options);

/// A scan at one scale as a closed piecewise-planar model (CVPR 2018, figure 8).
struct ScanSolid {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< scan less this is the solids' frame
  std::vector<Solid> solids;                         ///< valid, metres
  int scale = 0;       ///< number of the scale, from 0, whose shapes were closed (see close_scales)
  int planes = 0;      ///< of the roofs, those of the ground around a building among them
  int facets = 0;      ///< of all solids
  int triangles = 0;   ///< that the facets fall into
  double rms = 0.0;    ///< of the scan's points (facets by area) to the solids' surface, metres
  double mean = 0.0;   ///< their mean distance, metres
  std::string reason;  ///< why there are no solids; empty where there are
};

/// Closes the shapes of a scale in 2.5D: what is seen of them from above, between a level base
/// under the lowest point and their planes, over the outline of the scan's points in plan. Shapes
/// that are walls divide the plan along their traces, edges of the outline beside a trace follow
/// it, and roofs that jut out over a wall end there (see find_overhangs). Walls are vertical,
/// undersides are not there. Deterministic.
ScanSolid close_scale(const Scan& scan, const ScaleShapes& scale, const ScanSolidOptions& options);

/// The closed models of all scales, finest first. Of two scales the coarser model has no more
/// facets and the finer one is no farther from the scan (RMS): a coarser model with more facets
/// than the finer one gives way to it, and a finer one that is farther than the coarser one to
/// that; `scale` then says whose model it is. Scales that cannot be closed keep their reason.
std::vector<ScanSolid> close_scales(const Scan& scan, const std::vector<ScaleShapes>& scales,
                                    const ScanSolidOptions& options);

}  // namespace gable
