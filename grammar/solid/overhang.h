#pragma once

#include <gable/grammar/block.h>

namespace gable {

/// A block whose roof reaches beyond the walls by `overhang` (metres, >= 0): its planes fall on at
/// the eaves along the ridge, and keep their height at gables. A hip falls on until it is as low as
/// the other eaves, so the overhang is smaller under a steeper hip and larger under a shallower
/// one; where that differs from `overhang` by less than 5 mm it is `overhang`, and the hip's plane
/// leans accordingly.
Block<double> with_overhang(const Block<double>& block, double overhang);

}  // namespace gable
