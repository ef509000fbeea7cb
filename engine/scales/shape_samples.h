#pragma once

#include <gable/engine/scan.h>
#include <gable/engine/solver/plane_refinement.h>

#include <vector>

namespace gable {

/// Points that stand for the elements of shapes.
struct ShapeSamples {
  std::vector<Eigen::Vector3d> points;  ///< metres, in the frame of the scan
  /// Per shape its points and their weights; noise is not filled. The mean weight of a facet is 1.
  std::vector<PlaneSupport> supports;
  double weight_unit = 1.0;  ///< what a weight of 1 is: a point, or square metres of a mesh
};

/// Of a cloud the points themselves. Of a mesh the mid-points of the edges of each facet's
/// triangles (a fan from its first corner), each with a third of the triangle's area in units of
/// the mean area of all facets in shapes: a quadrature that is exact for squares of distances.
/// Facets without area have no samples. shape_of: per element its shape, numbered from 0, or -1.
ShapeSamples sample_shapes(const Scan& scan, const std::vector<int>& shape_of);

/// Moments of a shape's samples, relative to the first one.
PointMoments moments_of(const std::vector<Eigen::Vector3d>& points, const PlaneSupport& support);

}  // namespace gable
