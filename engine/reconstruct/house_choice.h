#pragma once

#include <gable/engine/reconstruct/leftovers.h>
#include <gable/engine/solver/house_refinement.h>
#include <gable/grammar/house.h>
#include <gable/residuals/height_image.h>

#include <string>
#include <vector>

namespace gable {

/// How a house is chosen among hypotheses.
struct HouseChoiceOptions {
  int per_foundation = 2;  ///< hypotheses of each foundation type and azimuth, [1, 10]
  int finalists = 5;       ///< hypotheses refined to the end, [1, 20]
  /// Hypotheses whose robust cost is more than this times the least are given up early, > 1.
  double hopeless = 1.6;
  /// The outline is known: pixels beyond it hold ground, and misses inside it count by their
  /// height.
  bool outline_known = false;
  double least_noise = 0.1;  ///< of the heights, metres, > 0
  double most_noise = 0.4;   ///< metres, >= least_noise
};

/// Empty if the options are in range; otherwise names the violated bound.
std::string check(const HouseChoiceOptions& options);

/// One hypothesis after its refinement.
struct Candidate {
  House house;
  PenalisedCost cost;
};

/// The house chosen, and what it was chosen from.
struct HouseChoice {
  bool found = false;  ///< false: no block explains the building better than bare ground
  Candidate best;
  RefinementSummary summary;         ///< of the last refinement of the best
  std::vector<Candidate> finalists;  ///< best first, the winner among them
  int hypotheses = 0;                ///< how many were refined
  double noise = 0.0;                ///< of the heights as used to price parameters, metres
};

/// Chooses a house without learning: first values of every foundation type from the heights, all
/// refined, the best few refined to the end with their dormers, chimneys and garages and simplified
/// roofs, and the least penalised cost wins.
HouseChoice choose_house(const HeightImage& image, const HouseChoiceOptions& options);

}  // namespace gable
