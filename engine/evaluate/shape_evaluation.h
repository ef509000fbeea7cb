#pragma once

#include <gable/engine/scan.h>

#include <string>
#include <vector>

namespace gable {

/// How planar shapes fit a scan. Distances are to the shapes' least-squares planes, whatever planes
/// the shapes were given with, so that figures of different programs can be compared. Facets count
/// by their corners, each with an equal share of the facet's area.
struct ShapeEvaluation {
  int planes = 0;
  double coverage = 0.0;   ///< share of the points (of a mesh: of its area) in shapes
  double diagonal = 0.0;   ///< of the scan's bounding box, metres
  double rms = 0.0;        ///< over all points (corners) in shapes, metres
  double worst_rms = 0.0;  ///< the largest of a single shape, metres
};

/// shape_of: per element of the scan its shape, any numbers, negative for none.
ShapeEvaluation evaluate_shapes(const Scan& scan, const std::vector<int>& shape_of);

/// Agreement of shapes with known planes: the adjusted Rand index over the elements whose plane is
/// known (truth >= 0); elements without a shape are one class.
double agreement_index(const std::vector<int>& shape_of, const std::vector<int>& truth);

}  // namespace gable
