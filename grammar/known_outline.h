#pragma once

#include <gable/grammar/solid/extrusion.h>

namespace gable {

/// Where the walls of a house are known to be.
struct KnownOutline {
  PlanPolygon polygon;  ///< local frame, metres; without corners: nothing is known
  /// How far blocks fill the polygon beyond their rectangles, metres; see outline_margins.h.
  double reach = 0.0;

  bool empty() const { return polygon.outer.empty(); }
};

}  // namespace gable
