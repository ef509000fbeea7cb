#pragma once

#include <gable/engine/reconstruct/tile/reconstruct_tile.h>

#include <string>

namespace gable {

/// How a building's house was chosen and why the building came out as it did, in lines of plain
/// text that end with a newline: how many first values each source gave, the probabilities of the
/// foundation types where detectors were asked, the finalists with their penalised costs (best
/// first), the hypotheses that were given up, what the winner's first values were read from, its
/// lead over the next of another foundation, what became of it, the relations to neighbours it was
/// refined with and how far it was from each before and after, and the outcome. Costs are those of
/// `PenalisedCost`; lengths in metres. The same building gives the same text.
std::string explain(const TileBuilding& building);

}  // namespace gable
