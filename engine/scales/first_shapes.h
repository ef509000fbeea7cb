#pragma once

#include <gable/engine/scales/trajectory.h>
#include <gable/engine/scan.h>

#include <string>

namespace gable {

/// How the first shapes of a trajectory are found (CVPR 2018, section 4, "Initialization"). The
/// defaults are the paper's and serve all inputs.
struct FirstShapesOptions {
  /// Largest distance of an element to its shape, per cent of the bounding box diagonal, [0, 10].
  /// On meshes 0 makes every facet a shape of its own.
  double epsilon_percent = 0.05;
  /// Scans whose surfaces are thicker than epsilon get an epsilon of this many standard deviations
  /// of their noise instead, [0, 10]; 0: epsilon is taken as it is.
  double epsilon_deviations = 3.0;
  double max_angle = 0.4363;  ///< between an element's normal and its shape's, radians, (0, 1.5708)
  /// Of a shape of points, or of the facets of a rough mesh, [1, 1000000]. Facets always find one.
  int min_inliers = 10;
  int neighbours = 20;  ///< k of the neighbour graph of points, [3, 200]
  int threads = 1;      ///< [1, 1024]; the shapes do not depend on it
};

/// Empty if the options are in range; otherwise names the violated bound.
std::string check(const FirstShapesOptions& options);

/// Finds the first shapes of a scan and which of them are adjacent: shapes of points that have
/// mutual neighbours in each other, shapes of facets that share an edge (corners at the same place
/// are one). A scan without any shape (no points, a line) gives none.
FirstShapes find_first_shapes(const Scan& scan, const FirstShapesOptions& options);

}  // namespace gable
