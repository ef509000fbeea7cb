#pragma once

#include <gable/grammar/house.h>
#include <gable/grammar/random.h>
#include <gable/grammar/synthesis/houses/built_shape.h>

namespace gable {

/// A house that is a slice of a row, in its own frame (x along the row, the street towards -y),
/// origin zero, components' box centred, azimuth uniform: 4-8 m wide and 6.5-11 m deep, not less
/// than 7 cells of `gsd` metres wide. `foundation` is one of
///
///   I    gabled along or across the row, hipped in front, or flat
///   II   with a flat shelf as wide as the house behind the ridge, as high as the eaves or higher,
///        or with a flat part of 3.8 m or more at the back; or flat on two levels
///   III  with two such parts
///
/// Box dormers, chimneys on party walls, and flat extensions of 2.1-3.4 m at the back as garages.
/// Of II and III `is_distinct` or `flat_parts_are_distinct` holds.
House random_row_house(Foundation foundation, double gsd, Random* random);

/// The neighbours of a placed house of a row, world, on both sides of it or on one: the same roof,
/// equal (half of them), a little (U(0.1, 0.6) m) or much (2.5 m at most) higher or lower.
BuiltShape random_row_beside(const House& house, Random* random);

}  // namespace gable
