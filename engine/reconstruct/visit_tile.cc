#include <gable/engine/reconstruct/fill.h>
#include <gable/engine/reconstruct/ordered_pool.h>
#include <gable/engine/reconstruct/tile_crops.h>
#include <gable/engine/reconstruct/tile_windows.h>
#include <gable/engine/reconstruct/visit_tile.h>
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

PlanPolygon moved(PlanPolygon polygon, const Eigen::Vector2d& origin) {
  for (Eigen::Vector2d& p : polygon.outer) p -= origin;
  for (auto& hole : polygon.holes) {
    for (Eigen::Vector2d& p : hole) p -= origin;
  }
  return polygon;
}

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
        grid_(input.dsm->grid()) {
    if (!input.footprints) return;
    for (const Footprint& footprint : *input.footprints) {
      extents_.push_back(extent_of(footprint.polygon, grid_));
    }
  }

  TileSummary run() {
    const std::vector<CellBox> cores = window_cores(grid_, options_.window_cells);
    for (size_t i = 0; i < cores.size() && !summary_.stopped; ++i) {
      window_ = static_cast<int>(i);
      num_windows_ = static_cast<int>(cores.size());
      input_.footprints ? over_footprints(cores[i]) : over_found_houses(cores[i]);
    }
    return summary_;
  }

 private:
  Window read(const CellBox& core, const CellBox& box) const {
    Window window{core, box, {}, {}};
    window.dsm = input_.dsm->read(box.row0, box.col0, box.row1 - box.row0, box.col1 - box.col0);
    if (!input_.dtm) {
      window.dtm = derive_terrain(window.dsm, options_.terrain);
      return window;
    }
    window.dtm = input_.dtm->read_onto(window.dsm.grid);
    const auto& heights = window.dtm.values;
    if (std::any_of(heights.begin(), heights.end(), [](float z) { return !std::isfinite(z); })) {
      window.dtm = fill_smoothly(window.dtm);
    }
    return window;
  }

  void over_found_houses(const CellBox& core) {
    const Window window = read(core, with_margin(core, options_.overlap, grid_));
    FoundHouses found = find_houses(window.dsm, window.dtm, options_.find);
    if (input_.filter) {
      std::vector<PlanPolygon> polygons;
      for (const Footprint& footprint : *input_.filter) polygons.push_back(footprint.polygon);
      summary_.num_far += keep_near_footprints(polygons, &found);
    }
    summary_.num_small += found.num_small;
    summary_.num_crown += found.num_crown;
    std::vector<size_t> mine;
    std::vector<std::string> ids;
    for (size_t i = 0; i < found.houses.size(); ++i) {
      CellBox box = found.houses[i].box;
      box = {box.row0 + window.box.row0, box.col0 + window.box.col0, box.row1 + window.box.row0,
             box.col1 + window.box.col0};
      if (!holds_center(core, box)) continue;
      mine.push_back(i);
      ids.push_back(id_of_place(box));
    }
    visit_all(mine.size(), [&](size_t i) {
      TileBuilding out;
      out.image = crop_found_house(window.dsm, window.dtm, found, mine[i], options_.crop);
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
      out.image =
          crop_footprint(window.dsm, window.dtm, outlined, footprint.polygon, options_.crop);
      const PlanPolygon outline = moved(footprint.polygon, out.image.origin.head<2>());
      make_(footprint.id, &outline, &out);
      return out;
    });
  }

  void visit_all(size_t count, const std::function<TileBuilding(size_t)>& make) {
    if (callbacks_.begin_window) callbacks_.begin_window(window_, num_windows_, count);
    const size_t first = summary_.num_buildings;
    const auto made = [&](size_t i) {
      TileBuilding out = make(i);
      out.index = first + i;
      if (!join_) inspect(out);
      return out;
    };
    std::vector<TileBuilding> window;  // of those to be joined
    bool done =
        run_in_order<TileBuilding>(count, options_.threads, stop_, made, [&](TileBuilding&& out) {
          if (callbacks_.made) callbacks_.made();
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

  std::string id_of_place(const CellBox& box) {
    const Eigen::Vector2d center =
        0.5 * (grid_.center_of(box.row0, box.col0) + grid_.center_of(box.row1 - 1, box.col1 - 1));
    const std::string id = "b" + std::to_string(std::llround(10.0 * center.x())) + "_" +
                           std::to_string(std::llround(10.0 * center.y()));
    std::string unique = id;
    for (int k = 2; !ids_.insert(unique).second; ++k) unique = id + "-" + std::to_string(k);
    return unique;
  }

  const TileInput& input_;
  const TileOptions& options_;
  const std::stop_token& stop_;
  const TileCallbacks& callbacks_;
  const MakeBuilding& make_;
  const JoinBuildings& join_;
  const Grid grid_;
  std::vector<CellBox> extents_;  ///< of the footprints
  std::unordered_set<std::string> ids_;
  TileSummary summary_;
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
