#pragma once

#include <gable/grammar/house.h>
#include <gable/grammar/synthesis/training_scene.h>

namespace gable {

/// Takes the dormers and chimneys away that the scene's surveyed heights do not show: a dormer is
/// seen where at least three cells of it stand 0.3 m out of the roof on average, a chimney where a
/// cell of it stands 0.5 m out, and neither where a tree covers it. Returns the house with those
/// alone that were taken away.
House keep_visible_details(const TrainingScene& scene, House* house);

}  // namespace gable
