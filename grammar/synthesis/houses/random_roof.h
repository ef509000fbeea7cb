#pragma once

#include <gable/grammar/house.h>
#include <gable/grammar/random.h>
#include <gable/grammar/synthesis/houses/rectangle.h>

namespace gable {

/// How a roof ends at one end of its ridge.
enum class RoofEnd { kGable, kHip };

/// Eaves height in metres: bungalows 2.4-3.2, a storey and a half 3.2-4.6, two storeys 4.6-6.5.
double random_eaves(Random* random);

/// Roof pitch in radians, 25-50 degrees, mostly around 38.
double random_pitch(Random* random);

/// A pitched roof over a rectangle. Hips are as steep as the sides or up to a third steeper
/// (0.75-1.0 of the half span as their run, never more than half of the length).
Rule make_roof(const Rectangle& rectangle, Axis ridge, double eaves, double pitch, RoofEnd start,
               RoofEnd end, Random* random);

/// A roof for a block whose ends are both free: gables, hips, one of each, or a pyramid.
Rule random_roof(const Rectangle& rectangle, Axis ridge, double eaves, double pitch,
                 Random* random);

Rule make_flat_roof(double height);

}  // namespace gable
