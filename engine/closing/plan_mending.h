#pragma once

#include <gable/engine/closing/labelled_plan.h>
#include <gable/grammar/solid/roof_partition.h>
#include <gable/grammar/solid/solid.h>

#include <optional>
#include <vector>

namespace gable {

/// A labelled plan over which solids stand.
struct MendedPlan {
  RoofPartition roof;
  std::vector<Solid> solids;  ///< valid, between base and roof; one per connected body
  std::vector<int> origins;   ///< of the roof's planes, as in PlaneChoice
  int cells = 0;              ///< of the division at last
};

/// The solids between the height `base` and the roof of a labelled plan. Defects of the roof (see
/// find_roof_defects) are mended where they are, up to 40 times: around saddles single cells get
/// the plane of a cell beside them that stays `clearance` above the base there; where corners
/// crowd, a line of steps, a corner of the outline or a plane is moved by up to 2 cm, and the cells
/// keep their planes. Planes that no cell uses are left out. Nothing where no valid solid comes
/// out. Local frame, metres; deterministic.
std::optional<MendedPlan> mend_plan(LabelledPlan labelled, PlaneChoice choice, double base,
                                    double clearance);

}  // namespace gable
