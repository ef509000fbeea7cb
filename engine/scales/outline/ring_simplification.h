#pragma once

#include <gable/grammar/ring.h>

#include <Eigen/Core>
#include <vector>

namespace gable {

/// Whether no two edges of the rings meet but neighbours at their common corner.
bool are_simple(const std::vector<Ring>& rings);

/// Leaves out corners of rings so that no corner that is left out lies farther than `tolerance`
/// (the rings' unit) from the simplified ring (Douglas and Peucker, 1973). Where that would let
/// edges meet, all rings are simplified by half the tolerance instead, and so on; rings that are
/// simple stay so. Rings of less than 3 corners and rings without an area go.
std::vector<Ring> simplified(const std::vector<Ring>& rings, double tolerance);

}  // namespace gable
