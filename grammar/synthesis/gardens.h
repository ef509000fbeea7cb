#pragma once

#include <gable/grammar/synthesis/ground/vegetation.h>
#include <gable/grammar/synthesis/streets.h>
#include <gable/grammar/synthesis/village.h>

#include <vector>

namespace gable {

struct Gardens {
  std::vector<Tree> trees;
  std::vector<Hedge> hedges;
};

/// Trees and hedges for placed houses: trees clear of all houses by 1 m and off the carriageway,
/// some that reach over a wall by up to 0.8 m, hedges along fronts and side boundaries.
Gardens plant_gardens(const StreetPlan& plan, const VillageOptions& options, Random* random);

}  // namespace gable
