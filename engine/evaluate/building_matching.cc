#include <gable/engine/evaluate/building_matching.h>
#include <glog/logging.h>

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

namespace gable {

std::vector<BuildingMatch> match_buildings(const Raster<int>& model_owner, int num_buildings,
                                           const Raster<int>& truth_owner, int num_truth) {
  CHECK(model_owner.grid == truth_owner.grid);
  std::vector<size_t> model_cells(num_buildings, 0), truth_cells(num_truth, 0);
  std::map<std::pair<int, int>, size_t> shared;  // (truth, building)
  for (size_t i = 0; i < truth_owner.values.size(); ++i) {
    const int building = model_owner.values[i];
    const int truth = truth_owner.values[i];
    if (building >= 0) ++model_cells[building];
    if (truth >= 0) ++truth_cells[truth];
    if (building >= 0 && truth >= 0) ++shared[{truth, building}];
  }
  std::vector<std::tuple<double, int, int>> candidates;  // (-IoU, truth, building)
  for (const auto& [pair, cells] : shared) {
    const auto [truth, building] = pair;
    const size_t all = truth_cells[truth] + model_cells[building] - cells;
    candidates.emplace_back(-static_cast<double>(cells) / static_cast<double>(all), truth,
                            building);
  }
  std::sort(candidates.begin(), candidates.end());
  std::vector<BuildingMatch> matches(num_truth);
  std::vector<bool> taken(num_buildings, false);
  for (const auto& [minus_iou, truth, building] : candidates) {
    if (matches[truth].building >= 0 || taken[building]) continue;
    matches[truth] = {building, -minus_iou};
    taken[building] = true;
  }
  return matches;
}

}  // namespace gable
