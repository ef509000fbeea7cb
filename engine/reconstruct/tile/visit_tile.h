#pragma once

#include <gable/engine/reconstruct/tile/reconstruct_tile.h>

#include <functional>
#include <stop_token>
#include <string>
#include <vector>

namespace gable {

/// Fills a building whose `image` is set: `id` and, where it is known, `outline` in the image's
/// local frame, otherwise null. Called by worker threads.
using MakeBuilding =
    std::function<void(const std::string& id, const PlanPolygon* outline, TileBuilding* building)>;

/// Changes the buildings of a window once all are made. Called on the calling thread.
using JoinBuildings = std::function<void(std::vector<TileBuilding>* window)>;

/// Cuts the height images of all buildings of a raster of any size, window by window, and has
/// `make` make something of each, on several threads. Where `join` is given, it is called with all
/// buildings of each window before any of them is delivered; otherwise each is delivered as soon as
/// it is its turn. `reconstruct_tile` is this with reconstruction.
TileSummary visit_tile(const TileInput& input, const TileOptions& options,
                       const std::stop_token& stop, const TileCallbacks& callbacks,
                       const MakeBuilding& make, const JoinBuildings& join = {});

}  // namespace gable
