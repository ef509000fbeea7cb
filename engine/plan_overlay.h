#pragma once

#include <gable/grammar/solid/extrusion.h>

#include <vector>

namespace gable {

/// A part of the plan: polygons that do not overlap, one per connected piece, metres. Outer rings
/// anticlockwise, holes clockwise.
using PlanShape = std::vector<PlanPolygon>;

/// What two parts of the plan cover together, have in common, and what the first has alone; exact
/// up to rounding (GEOS through GDAL). Slivers under a square centimetre are nothing. Rings that
/// cross themselves are nothing as well.
PlanShape union_of(const PlanShape& a, const PlanShape& b);
PlanShape common_of(const PlanShape& a, const PlanShape& b);
PlanShape difference_of(const PlanShape& a, const PlanShape& b);

/// A part of the plan, moved by `step`.
PlanShape moved(PlanShape shape, const Eigen::Vector2d& step);

/// Area in square metres.
double area_of(const PlanShape& shape);

}  // namespace gable
