#pragma once

#include <gable/engine/closing/plan_lines.h>
#include <gable/engine/scales/planar_shape.h>

#include <Eigen/Core>
#include <vector>

namespace gable {

/// A place of a scan's surface.
struct SurfaceSample {
  Eigen::Vector3d point;  ///< local frame, metres
  double weight = 1.0;    ///< a point, or square metres of a mesh
  int shape = -1;         ///< that it belongs to
};

/// Where a wall stands, with the stretch that was seen of it.
struct WallTrace {
  PlanLine line;
  double low = 0.0, high = 0.0;  ///< between which it was seen, metres
};

/// The traces of the shapes that are walls, longest first: those whose normals point up or down by
/// less than `least_up` and which are `least_length` metres long or longer. A wall that leans has
/// its trace at half its height. Shapes are in the scan's frame, samples and traces in that frame
/// less `origin`.
std::vector<WallTrace> wall_traces(const std::vector<SurfaceSample>& samples,
                                   const std::vector<PlanarShape>& shapes,
                                   const Eigen::Vector3d& origin, double least_up,
                                   double least_length);

}  // namespace gable
