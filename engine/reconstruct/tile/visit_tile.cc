#include <gable/engine/ordered_pool.h>
#include <gable/engine/plan_overlay.h>
#include <gable/engine/reconstruct/finding/found_rows.h>
#include <gable/engine/reconstruct/tile/tile_crops.h>
#include <gable/engine/reconstruct/tile/tile_spread.h>
#include <gable/engine/reconstruct/tile/tile_terrain.h>
#include <gable/engine/reconstruct/tile/tile_windows.h>
#include <gable/engine/reconstruct/tile/visit_tile.h>
#include <gable/grammar/polygon_cells.h>
#include <glog/logging.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <unordered_set>
#include <utility>

namespace gable {
namespace {

CellBox extent_of(const PlanPolygon& polygon, const Grid& grid) {
  Eigen::AlignedBox2d extent;
  for (const Eigen::Vector2d& p : polygon.outer) extent.extend(p);
  return cells_around(extent.min(), extent.max(), grid);
}

/// Whether the bounding box of a polygon, enlarged to three times its size, reaches a grid.
bool is_near(const PlanPolygon& polygon, const Grid& grid) {
  Eigen::AlignedBox2d extent, box;
  for (const Eigen::Vector2d& p : polygon.outer) extent.extend(p);
  if (extent.isEmpty()) return false;
  box.extend(grid.north_west);
  box.extend(grid.north_west + grid.gsd * Eigen::Vector2d(grid.cols, -grid.rows));
  return box.intersects({extent.min() - extent.sizes(), extent.max() + extent.sizes()});
}

/// Centres of houses are half cells apart; their ids differ where this is more than a unit.
constexpr double kLeastUnitsPerCell = 2.25;

/// The heights of one window.
struct Window {
  CellBox core, box;
  HeightRaster dsm, dtm;
};

class TileVisit {
 public:
  TileVisit(const TileInput& input, const TileOptions& options, const std::stop_token& stop,
            const TileCallbacks& callbacks, const MakeBuilding& make, const JoinBuildings& join)
      : input_(input),
        options_(options),
        stop_(stop),
        callbacks_(callbacks),
        make_(make),
        join_(join),
        grid_(input.dsm->grid()),
        crop_(options.crop),
        terrain_(*input.dsm, input.dtm,
                 {options.terrain, options.window_cells, options.overlap, options.scratch}) {
    if (!crop_.spread) crop_.spread = tile_spread(*input.dsm);
    summary_.spread = *crop_.spread;
    if (!input.footprints) return;
    for (const Footprint& footprint : *input.footprints) {
      extents_.push_back(extent_of(footprint.polygon, grid_));
    }
  }

  TileSummary run() {
    const std::vector<TileWindow> windows = windows_of(input_, options_);
    num_windows_ = static_cast<int>(windows.size());
    for (window_ = 0; window_ < num_windows_ && !summary_.stopped; ++window_) {
      const TileWindow& window = windows[window_];
      if (callbacks_.wants_window && !callbacks_.wants_window(window)) continue;
      const TileSummary before = summary_;
      input_.footprints ? over_footprints(window.core) : over_found_houses(window.core);
      if (!summary_.stopped && callbacks_.end_window) {
        callbacks_.end_window(window, since(before));
      }
    }
    return summary_;
  }

 private:
  TileSummary since(const TileSummary& before) const {
    TileSummary summary = summary_;
    summary.num_buildings -= before.num_buildings;
    summary.num_small -= before.num_small;
    summary.num_crown -= before.num_crown;
    summary.num_far -= before.num_far;
    summary.num_unexplained -= before.num_unexplained;
    return summary;
  }

  Window read(const CellBox& core, const CellBox& box) {
    Window window{core, box, {}, {}};
    window.dsm = input_.dsm->read(box.row0, box.col0, box.row1 - box.row0, box.col1 - box.col0);
    window.dtm = terrain_.read(box);
    return window;
  }

  void over_found_houses(const CellBox& core) {
    const Window window = read(core, with_margin(core, options_.overlap, grid_));
    FoundHouses found = find_houses(window.dsm, window.dtm, options_.find);
    if (input_.filter) {
      std::vector<PlanPolygon> polygons;
      for (const Footprint& footprint : *input_.filter) {
        if (is_near(footprint.polygon, window.dsm.grid)) polygons.push_back(footprint.polygon);
      }
      summary_.num_far += keep_near_footprints(polygons, &found);
    }
    summary_.num_small += found.num_small;
    summary_.num_crown += found.num_crown;
    std::vector<size_t> whole, mine;
    std::vector<std::string> ids;
    std::unordered_set<std::string> taken;
    for (size_t i = 0; i < found.houses.size(); ++i) {
      if (!holds_center(core, in_tile(found.houses[i].box, window))) continue;
      if (cut_where_it_goes_on(window, i, &found)) whole.push_back(i);
    }
    // Once all are cut at the window's border: a row is cut as far as it is this window's.
    for (const size_t i : whole) {
      for (const size_t piece : pieces_of(window, i, &found)) {
        mine.push_back(piece);
        ids.push_back(id_of_place(in_tile(found.houses[piece].box, window), &taken));
      }
    }
    visit_all(mine.size(), [&](size_t i) {
      TileBuilding out;
      out.image = crop_found_house(window.dsm, window.dtm, found, mine[i], crop_);
      out.of_row = found.houses[mine[i]].row > 0;
      out.cuts = found.houses[mine[i]].cuts;
      for (PlanLine& cut : out.cuts) cut.offset -= cut.normal.dot(out.image.origin.head<2>());
      make_(ids[i], nullptr, &out);
      return out;
    });
  }

  void over_footprints(const CellBox& core) {
    const std::vector<Footprint>& footprints = *input_.footprints;
    CellBox box = input_.dtm ? CellBox{} : with_margin(core, options_.overlap, grid_);
    std::vector<size_t> mine;
    for (size_t i = 0; i < footprints.size(); ++i) {
      if (!holds_center(core, extents_[i])) continue;
      mine.push_back(i);
      box = union_of(box, with_margin(extents_[i], options_.crop.margin, grid_));
    }
    if (mine.empty()) return visit_all(0, nullptr);
    const Window window = read(core, box);
    Raster<unsigned char> outlined(window.dsm.grid, 0);
    for (size_t i = 0; i < footprints.size(); ++i) {
      if (extents_[i].row0 >= box.row1 || extents_[i].row1 <= box.row0 ||
          extents_[i].col0 >= box.col1 || extents_[i].col1 <= box.col0) {
        continue;
      }
      for_cells_in_polygon(footprints[i].polygon, Eigen::Vector2d::Zero(), outlined.grid,
                           [&](int row, int col) { outlined.at(row, col) = 1; });
    }
    visit_all(mine.size(), [&](size_t i) {
      const Footprint& footprint = footprints[mine[i]];
      TileBuilding out;
      out.image = crop_footprint(window.dsm, window.dtm, outlined, footprint.polygon, crop_);
      const PlanPolygon outline = moved({footprint.polygon}, -out.image.origin.head<2>()).front();
      make_(footprint.id, &outline, &out);
      return out;
    });
  }

  void visit_all(size_t count, const std::function<TileBuilding(size_t)>& make) {
    if (callbacks_.begin_window) callbacks_.begin_window(window_, num_windows_, count);
    const size_t first = num_visited_;
    num_visited_ += count;
    const auto made = [&](size_t i) {
      TileBuilding out = make(i);
      out.index = first + i;
      if (!join_ && out.is_building) inspect(out);
      return out;
    };
    std::vector<TileBuilding> window;  // of those to be joined
    bool done =
        run_in_order<TileBuilding>(count, options_.threads, stop_, made, [&](TileBuilding&& out) {
          if (callbacks_.made) callbacks_.made();
          if (!out.is_building) {
            ++summary_.num_unexplained;
            return;
          }
          join_ ? window.push_back(std::move(out)) : deliver(std::move(out));
        });
    if (join_ && done) done = join_and_deliver(&window);
    summary_.stopped = !done || stop_.stop_requested();
  }

  /// Returns false, with nothing delivered, where it was stopped before all were joined.
  bool join_and_deliver(std::vector<TileBuilding>* window) {
    join_(window);
    if (stop_.stop_requested()) return false;
    return run_in_order<TileBuilding>(
        window->size(), options_.threads, {},
        [&](size_t i) {
          inspect((*window)[i]);
          return std::move((*window)[i]);
        },
        [&](TileBuilding&& out) { deliver(std::move(out)); });
  }

  void inspect(const TileBuilding& building) const {
    if (callbacks_.inspect) callbacks_.inspect(building);
  }

  void deliver(TileBuilding&& building) {
    ++summary_.num_buildings;
    if (callbacks_.deliver) callbacks_.deliver(std::move(building));
  }

  static CellBox in_tile(const CellBox& box, const Window& window) {
    return {box.row0 + window.box.row0, box.col0 + window.box.col0, box.row1 + window.box.row0,
            box.col1 + window.box.col0};
  }

  /// Cuts a house that goes on beyond the window where the cores meet. The next window sees as
  /// much of it on its side of that border, takes its part for a house of its own, and cuts it as
  /// well. Says whether anything is left.
  bool cut_where_it_goes_on(const Window& window, size_t index, FoundHouses* found) const {
    FoundHouse& house = found->houses[index];
    const CellBox box = in_tile(house.box, window);
    const bool goes_on = (box.row0 == window.box.row0 && box.row0 > 0) ||
                         (box.col0 == window.box.col0 && box.col0 > 0) ||
                         (box.row1 == window.box.row1 && box.row1 < grid_.rows) ||
                         (box.col1 == window.box.col1 && box.col1 < grid_.cols);
    if (!goes_on) return true;
    const int label = static_cast<int>(index) + 1;
    FoundHouse part;
    for (int row = house.box.row0; row < house.box.row1; ++row) {
      for (int col = house.box.col0; col < house.box.col1; ++col) {
        int& cell = found->label.at(row, col);
        if (cell != label) continue;
        const int tile_row = row + window.box.row0, tile_col = col + window.box.col0;
        if (tile_row >= window.core.row0 && tile_row < window.core.row1 &&
            tile_col >= window.core.col0 && tile_col < window.core.col1) {
          part.box.add(row, col);
          ++part.num_cells;
        } else {
          cell = FoundHouses::kDropped;
        }
      }
    }
    house = part;
    return part.num_cells > 0;
  }

  /// The houses that a row is cut into, or the house itself.
  std::vector<size_t> pieces_of(const Window& window, size_t index, FoundHouses* found) const {
    if (!options_.cut_rows) return {index};
    return cut_found_row(window.dsm, window.dtm, index, options_.row_cuts, found);
  }

  /// Two houses can have one centre (one stands in the other's yard), and both are of the window
  /// whose core holds it: `taken` are this window's. The unit is so small that other houses differ.
  std::string id_of_place(const CellBox& box, std::unordered_set<std::string>* taken) const {
    const Eigen::Vector2d center =
        0.5 * (grid_.center_of(box.row0, box.col0) + grid_.center_of(box.row1 - 1, box.col1 - 1));
    double units_per_metre = 10.0;
    while (units_per_metre * grid_.gsd < kLeastUnitsPerCell) units_per_metre *= 10.0;
    const std::string id = "b" + std::to_string(std::llround(units_per_metre * center.x())) + "_" +
                           std::to_string(std::llround(units_per_metre * center.y()));
    std::string unique = id;
    for (int k = 2; !taken->insert(unique).second; ++k) unique = id + "-" + std::to_string(k);
    return unique;
  }

  const TileInput& input_;
  const TileOptions& options_;
  const std::stop_token& stop_;
  const TileCallbacks& callbacks_;
  const MakeBuilding& make_;
  const JoinBuildings& join_;
  const Grid grid_;
  HeightCropOptions crop_;
  std::vector<CellBox> extents_;  ///< of the footprints
  TileTerrain terrain_;
  TileSummary summary_;
  size_t num_visited_ = 0;  ///< pieces and outlines, buildings or not
  int window_ = 0, num_windows_ = 0;
};

}  // namespace

TileSummary visit_tile(const TileInput& input, const TileOptions& options,
                       const std::stop_token& stop, const TileCallbacks& callbacks,
                       const MakeBuilding& make, const JoinBuildings& join) {
  CHECK(input.dsm != nullptr);
  CHECK(check(options).empty()) << check(options);
  return TileVisit(input, options, stop, callbacks, make, join).run();
}

}  // namespace gable
