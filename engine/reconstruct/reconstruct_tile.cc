#include <gable/engine/reconstruct/detector_pool.h>
#include <gable/engine/reconstruct/reconstruct_tile.h>
#include <gable/engine/reconstruct/visit_tile.h>

#include <optional>
#include <utility>

namespace gable {

std::string check(const TileOptions& options) {
  for (const std::string& error : {check(options.find), check(options.crop),
                                   check(options.building), check(options.detected_values)}) {
    if (!error.empty()) return error;
  }
  if (options.window_cells < 64 || options.window_cells > 32768) {
    return "window_cells must lie in [64, 32768]";
  }
  if (!(options.overlap >= 0.0 && options.overlap <= 10000.0)) {
    return "overlap must lie in [0, 10000] m";
  }
  if (options.threads < 1 || options.threads > 1024) return "threads must lie in [1, 1024]";
  return "";
}

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
  return visit_tile(input, options, stop, callbacks,
                    [&](const std::string& id, const PlanPolygon* outline, TileBuilding* building) {
                      ReconstructedBuilding made = reconstruct_building(
                          id, building->image, outline, options.building, detect);
                      building->building = std::move(made.building);
                      building->model = std::move(made.model);
                      building->choice = std::move(made.choice);
                    });
}

}  // namespace gable
