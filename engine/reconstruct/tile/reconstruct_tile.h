#pragma once

#include <gable/engine/io/footprint_file.h>
#include <gable/engine/io/models/building.h>
#include <gable/engine/io/models/building_model.h>
#include <gable/engine/io/raster/height_source.h>
#include <gable/engine/reconstruct/building/reconstruct_building.h>
#include <gable/engine/reconstruct/finding/find_houses.h>
#include <gable/engine/reconstruct/finding/height_crop.h>
#include <gable/engine/reconstruct/finding/row_cuts.h>
#include <gable/engine/reconstruct/heights/terrain.h>
#include <gable/engine/reconstruct/neighbours/join_neighbours.h>
#include <gable/engine/reconstruct/tile/tile_windows.h>
#include <gable/residuals/height_image.h>

#include <cstddef>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

namespace gable {

/// What is reconstructed.
struct TileInput {
  const HeightSource* dsm = nullptr;
  /// Null: the terrain is derived from the surface. It is also derived where this does not reach.
  const HeightSource* dtm = nullptr;
  /// Every polygon is one building; null: buildings are found in the heights.
  const std::vector<Footprint>* footprints = nullptr;
  /// Where buildings are found in the heights: only those near a polygon are kept, see
  /// `keep_near_footprints`. Null: all are.
  const std::vector<Footprint>* filter = nullptr;
};

struct TileOptions {
  FindHousesOptions find;
  HeightCropOptions crop;
  BuildingOptions building;
  TerrainOptions terrain;
  int window_cells = 2048;  ///< the raster is worked on in windows of this size, [64, 32768]
  /// By how much windows reach beyond that, metres, [0, 10000]. Buildings found in the heights that
  /// reach further into both of two windows are cut where these meet.
  double overlap = 100.0;
  /// Folder of temporary files: derived terrain, where the raster has several windows. Nothing is
  /// left there. Empty: the system's.
  std::string scratch;
  /// Pieces found in the heights that no house of the grammar explains and that cover less than
  /// this are no buildings, square metres, [0, 1e6]: hedges and clumps of trees, mostly. With
  /// outlines every polygon is one.
  double least_unexplained_area = 60.0;
  /// Where heights are means, crowns are as smooth as hipped roofs: there such a small piece is
  /// explained only by a house whose mean distance from the heights is at most this share of the
  /// piece's mean height over the terrain, [0, 1000].
  double most_misfit = 0.05;
  /// Cut what was found in the heights and is large into pieces of a few blocks, along the walls
  /// where houses of a row meet. With outlines every polygon is one building.
  bool cut_rows = true;
  RowCutOptions row_cuts;
  int threads = 1;  ///< [1, 1024]
  /// Folder of the learned detectors (engine/detectors/detector_nets.h), a second source of first
  /// values; empty: none.
  std::string detectors;
  DetectedValuesOptions detected_values;
  /// Refine the houses of a window that share party walls together once all are made, and divide
  /// the ground that two of them still cover; they are delivered after that. Groups do not reach
  /// from one window into another.
  bool join_neighbours = true;
  JoinOptions join;  ///< its stage is replaced by `last_stage`
};

/// Empty if the options are in range; otherwise names the violated bound.
std::string check(const TileOptions& options);

/// One building of a tile.
struct TileBuilding {
  size_t index = 0;            ///< rises in the order of delivery
  bool is_building = true;     ///< false: taken for something else after all, and not delivered
  bool of_row = false;         ///< a piece that a row was cut into
  std::vector<PlanLine> cuts;  ///< of a row's piece, local frame; it lies on their negative sides
  Building building;
  BuildingModel model;
  HeightImage image;   ///< what it was fitted to
  HouseChoice choice;  ///< what its house was chosen from
  /// What its house was refined with together with its neighbours' afterwards; empty: by itself.
  std::vector<UsedRelation> relations;
};

/// What happened.
struct TileSummary {
  size_t num_buildings = 0;
  int num_small = 0;        ///< high pieces that were too small to be houses
  int num_unexplained = 0;  ///< pieces that no house explains and that are small for anything else
  int num_crown = 0;        ///< high pieces that were parts of tree crowns
  int num_far = 0;          ///< houses dropped by the filter
  double spread = 0.0;      ///< over which heights were taken for means, metres; 0: for no means
  bool stopped = false;
};

/// What a caller does with the buildings. Members may be empty.
struct TileCallbacks {
  /// Asked on the calling thread before a window is worked on; false leaves it out, which changes
  /// nothing in the others.
  std::function<bool(const TileWindow&)> wants_window;
  /// Called on the calling thread, in order, when a building has been made: before it is delivered,
  /// and long before where neighbours are joined.
  std::function<void()> made;
  /// Called by worker threads, in any order, before the building is delivered.
  std::function<void(const TileBuilding&)> inspect;
  /// Called on the calling thread, in order.
  std::function<void(TileBuilding&&)> deliver;
  /// Called on the calling thread when the buildings of a window are known.
  std::function<void(int window, int num_windows, size_t num_buildings)> begin_window;
  /// Called on the calling thread when all buildings of a window have been delivered, with what
  /// happened in this window alone. Not called for the window that a stop request hits.
  std::function<void(const TileWindow&, const TileSummary&)> end_window;
};

/// The windows that `reconstruct_tile` works on, in its order: all that may hold a building.
std::vector<TileWindow> windows_of(const TileInput& input, const TileOptions& options);

/// Reconstructs all buildings of a raster of any size, window by window, on several threads. The
/// buildings and their order depend on neither the number of threads nor their timing. Where
/// neighbours are joined, all buildings of a window are held until it is done, and a window that a
/// stop request interrupts delivers nothing: what is delivered is final. Buildings that are found
/// get ids from their place: "b<easting>_<northing>" in decimetres (a tenth of that and less where
/// cells are smaller than 0.23 m). Memory depends on the size of a window, not on that of the
/// raster. Throws Error where a file is damaged, before any work where it is one of the detectors.
TileSummary reconstruct_tile(const TileInput& input, const TileOptions& options,
                             const std::stop_token& stop, const TileCallbacks& callbacks);

}  // namespace gable
