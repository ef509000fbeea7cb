#pragma once

#include <gable/grammar/house.h>
#include <gable/grammar/random.h>
#include <gable/grammar/synthesis/houses/built_shape.h>

namespace gable {

/// The kinds of buildings that no derivation of the grammar describes.
enum class ComplexKind {
  kComposite,    ///< four to six blocks that are all told apart
  kTurnedWings,  ///< wings at 20-70 degrees to the main block
  kRound,        ///< round or with six to ten sides, alone or at a house
  kMansard,      ///< steep below, shallow above, all around
  kHall,         ///< long, sawtooth or vaulted, or several roofs in a row
  kManyWings,    ///< H, E, plus and the like: four components with equal eaves
  kCourtyard,    ///< four wings around a court
  kTerrace,      ///< four to eight units in a stepped row
  kCrescent,     ///< units along a curve
  kSmallThings,  ///< a huddle of sheds, greenhouses and containers
};
inline constexpr int kNumComplexKinds = 10;

/// A random building of the given kind around the origin, its ground at height 0.
BuiltShape random_complex(ComplexKind kind, Random* random);

/// The same, of a kind drawn by how common it is.
BuiltShape random_complex(Random* random);

/// kComposite as a House of foundation kC with one footprint and one roof a block: not well formed,
/// but with a height field; any two of its blocks that touch are told apart as those of a II are.
House random_composite(Random* random);

}  // namespace gable
