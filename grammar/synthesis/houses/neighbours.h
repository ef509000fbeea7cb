#pragma once

#include <gable/grammar/house.h>
#include <gable/grammar/random.h>
#include <gable/grammar/synthesis/houses/built_shape.h>

#include <Eigen/Core>
#include <vector>

namespace gable {

/// How a neighbour stands to a house.
enum class NeighbourKind {
  kPartyWall,  ///< flush at one wall of it, with the same or another roof
  kClose,      ///< parallel to one wall, with a gap of 0.4-3 m
  kApart,      ///< a house of its own, 3-7 m away
};

/// Buildings next to a placed house, world: one, and in a row often another one at the far end;
/// none where there is no room. None overlaps the house. Party walls are shared along at least 3 m.
BuiltShape random_neighbours(NeighbourKind kind, const House& house, Random* random);

/// The same for any building on ground of height `ground`, whose outline (world) runs
/// anticlockwise: at the wall of a party-wall or close neighbour stands a gabled or flat house.
BuiltShape random_neighbours(NeighbourKind kind, const std::vector<Eigen::Vector2d>& outline,
                             double ground, Random* random);

}  // namespace gable
