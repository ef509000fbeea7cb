#pragma once

#include <gable/engine/scales/outline/plane_frame.h>
#include <gable/engine/scales/outline/ring_simplification.h>
#include <gable/engine/scales/planar_shape.h>

#include <vector>

namespace gable {

/// A region of the plane: its outer ring anticlockwise, its holes clockwise.
struct OutlinedRegion {
  Ring outer;
  std::vector<Ring> holes;
  double area = 0.0;  ///< less the holes
};

/// Regions as polygons in space, largest first.
std::vector<SpacePolygon> lifted(std::vector<OutlinedRegion> regions, const PlaneFrame& frame);

/// Area of a polygon in space less its holes, square metres.
double area_of(const SpacePolygon& polygon);

}  // namespace gable
