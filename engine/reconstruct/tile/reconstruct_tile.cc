#include <gable/engine/reconstruct/first_values/detector_pool.h>
#include <gable/engine/reconstruct/tile/divide_common_ground.h>
#include <gable/engine/reconstruct/tile/reconstruct_tile.h>
#include <gable/engine/reconstruct/tile/visit_tile.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace gable {

std::string check(const TileOptions& options) {
  for (const std::string& error :
       {check(options.find), check(options.crop), check(options.building),
        check(options.detected_values), check(options.row_cuts), check(options.join)}) {
    if (!error.empty()) return error;
  }
  if (options.window_cells < 64 || options.window_cells > 32768) {
    return "window_cells must lie in [64, 32768]";
  }
  if (!(options.overlap >= 0.0 && options.overlap <= 10000.0)) {
    return "overlap must lie in [0, 10000] m";
  }
  if (!(options.least_unexplained_area >= 0.0 && options.least_unexplained_area <= 1e6)) {
    return "least_unexplained_area must lie in [0, 1e6] square metres";
  }
  if (!(options.most_misfit >= 0.0 && options.most_misfit <= 1000.0)) {
    return "most_misfit must lie in [0, 1000]";
  }
  if (options.threads < 1 || options.threads > 1024) return "threads must lie in [1, 1024]";
  return "";
}

namespace {

void join_window(const JoinOptions& options, int threads, const std::stop_token& stop,
                 std::vector<TileBuilding>* window) {
  std::vector<FittedBuilding> fitted;
  for (const TileBuilding& made : *window) fitted.push_back({&made.building, &made.image});
  auto joined = join_neighbours(fitted, options, threads, stop);
  for (size_t i = 0; i < joined.size(); ++i) {
    if (!joined[i]) continue;
    (*window)[i].building = std::move(joined[i]->building);
    (*window)[i].model = std::move(joined[i]->model);
    (*window)[i].relations = std::move(joined[i]->relations);
  }
  if (!stop.stop_requested()) divide_common_ground(threads, window);
}

// Mean height over the terrain of the pixels inside, metres.
double mean_height_inside(const HeightImage& image) {
  double sum = 0.0;
  int count = 0;
  for (size_t i = 0; i < image.size(); ++i) {
    if (!image.inside[i] || !is_evidence(image, i)) continue;
    sum += image.height[i] - image.ground[i];
    ++count;
  }
  return count > 0 ? sum / count : 0.0;
}

// Whether a house of the grammar explains what was found.
bool is_explained(const TileBuilding& made, double most_misfit) {
  if (made.building.status != BuildingStatus::kGrammar) return false;
  if (made.image.spread == 0.0) return true;
  return made.building.quality.mad <= most_misfit * mean_height_inside(made.image);
}

double area_inside(const HeightImage& image) {
  return static_cast<double>(std::count(image.inside.begin(), image.inside.end(), 1)) * image.gsd *
         image.gsd;
}

}  // namespace

std::vector<TileWindow> windows_of(const TileInput& input, const TileOptions& options) {
  // An outline where there are no heights is a building all the same.
  return tile_windows(*input.dsm, options.window_cells, input.footprints != nullptr);
}

TileSummary reconstruct_tile(const TileInput& input, const TileOptions& options,
                             const std::stop_token& stop, const TileCallbacks& callbacks) {
  std::optional<DetectorPool> pool;
  DetectValues detect;
  if (!options.detectors.empty()) {
    pool.emplace(options.detectors);
    detect = [&](const HeightImage& image) {
      return detect_values(image, pool->lend().get(), options.detected_values);
    };
  }
  const MakeBuilding make = [&](const std::string& id, const PlanPolygon* outline,
                                TileBuilding* building) {
    ReconstructedBuilding made =
        reconstruct_building(id, building->image, outline, options.building, detect);
    building->building = std::move(made.building);
    building->model = std::move(made.model);
    building->choice = std::move(made.choice);
    building->is_building = outline != nullptr || building->of_row ||
                            area_inside(building->image) >= options.least_unexplained_area ||
                            is_explained(*building, options.most_misfit);
  };
  JoinBuildings join;
  if (options.join_neighbours) {
    JoinOptions join_options = options.join;
    join_options.refinement.stage = last_stage(input.footprints != nullptr);
    join = [join_options, &options, &stop](std::vector<TileBuilding>* window) {
      join_window(join_options, options.threads, stop, window);
    };
  }
  return visit_tile(input, options, stop, callbacks, make, join);
}

}  // namespace gable
