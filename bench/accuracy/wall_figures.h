#pragma once

#include <gable/engine/solver/neighbour_relations.h>
#include <gable/grammar/house.h>

#include <string>
#include <vector>

namespace gable {

/// How well models of houses that touch fit each other.
struct WallFigures {
  int walls = 0;         ///< pairs of walls within the tolerances of detection
  int closed = 0;        ///< of them, those nowhere further than 2 cm apart or in each other
  double gap = 0.0;      ///< summed area between such walls, square metres
  double overlap = 0.0;  ///< summed area that two houses cover both, square metres
};

/// Figures of all pairs. Overlap is counted on points 5 cm apart, over components and garages.
WallFigures wall_figures(const std::vector<const House*>& houses);

std::string text_of(const WallFigures& figures);

}  // namespace gable
