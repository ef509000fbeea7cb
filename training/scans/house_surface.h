#pragma once

#include <gable/grammar/house.h>
#include <gable/grammar/random.h>
#include <gable/training/scans/labelled_surface.h>

namespace gable {

/// The surface of a house without its underside, in its local frame over flat ground. Hull:
/// CityGML LOD1, the walls and one top for roofs of like height; structure: LOD2, walls, roof
/// planes, fronts and roofs of dormers; detail: LOD3, chimneys, dormers' cheeks, recesses of
/// windows and doors, eaves that stand out, door steps.
LabelledSurface house_surface(const House& house, Random* random);

}  // namespace gable
