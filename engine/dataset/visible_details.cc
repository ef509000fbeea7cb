#include <gable/engine/dataset/visible_details.h>
#include <gable/grammar/rasterise.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace gable {
namespace {

constexpr int kDormerCells = 3;
constexpr double kDormerStep = 0.3;   // metres out of the roof, on average
constexpr double kChimneyStep = 0.5;  // metres
constexpr double kCoverStep = 1.0;    // what stands higher over the truth is a crown, metres

struct Seen {
  int cells = 0;
  double sum = 0.0;   ///< of heights out of the roof, metres
  double most = 0.0;  ///< metres
};

}  // namespace

House keep_visible_details(const TrainingScene& scene, House* house) {
  House bare = *house;
  bare.dormers.clear();
  bare.chimneys.clear();
  House faint = bare;
  if (house->dormers.empty() && house->chimneys.empty()) return faint;
  const HeightField field(*house), roof(bare);
  std::vector<Seen> dormers(house->dormers.size()), chimneys(house->chimneys.size());
  for_covered_cells(*house, scene.dsm.grid, [&](int row, int col, double above_origin) {
    const Eigen::Vector2d point =
        field.house_from_local(scene.dsm.grid.center_of(row, col) - house->origin.head<2>());
    const BlockSource& source = field.sources()[field.block_at_house(point)];
    if (!stands_on_roof(source.role)) return;
    const double surveyed = scene.dsm.at(row, col) - house->origin.z();
    if (!std::isfinite(surveyed) || surveyed > above_origin + kCoverStep) return;
    const double ground = scene.dtm.at(row, col) - house->origin.z();
    const double out = surveyed - roof.at_house(point, 0.0, ground);
    Seen& seen = (source.role == BlockRole::kDormer ? dormers : chimneys)[source.index];
    ++seen.cells;
    seen.sum += out;
    seen.most = std::max(seen.most, out);
  });
  const auto keep = [](const std::vector<Seen>& seen, auto shows, std::vector<Rule>* rules,
                       std::vector<Rule>* others) {
    std::vector<Rule> kept;
    for (size_t i = 0; i < rules->size(); ++i) {
      (shows(seen[i]) ? &kept : others)->push_back((*rules)[i]);
    }
    *rules = std::move(kept);
  };
  keep(
      dormers,
      [](const Seen& s) { return s.cells >= kDormerCells && s.sum >= kDormerStep * s.cells; },
      &house->dormers, &faint.dormers);
  keep(
      chimneys, [](const Seen& s) { return s.cells > 0 && s.most >= kChimneyStep; },
      &house->chimneys, &faint.chimneys);
  return faint;
}

}  // namespace gable
