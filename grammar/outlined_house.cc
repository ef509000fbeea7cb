#include <gable/grammar/outline_margins.h>
#include <gable/grammar/outlined_house.h>

#include <utility>

namespace gable {

OutlinedHouse::OutlinedHouse(const House& house, KnownOutline outline)
    : field_(house), outline_(std::move(outline)) {
  for (size_t b = 0; b < field_.blocks().size(); ++b) {
    if (stands_on_roof(field_.sources()[b].role)) break;
    ground_blocks_.push_back(field_.blocks()[b]);
  }
}

std::optional<OutlinedHouse::Sample> OutlinedHouse::at_local(const Eigen::Vector2d& local) const {
  const Eigen::Vector2d p = field_.house_from_local(local);
  if (!has_outline()) {
    const int block = field_.block_at_house(p);
    if (block < 0) return std::nullopt;
    return Sample{block, field_.at_house(p, 0.0, 0.0)};
  }
  if (!polygon_holds(outline_.polygon, local)) return std::nullopt;
  const double margin = outline_margin_at(ground_blocks_, outline_.reach, p);
  if (margin < 0.0) return std::nullopt;
  std::optional<Sample> top;
  for (size_t b = 0; b < field_.blocks().size(); ++b) {
    const Block<double>& block = field_.blocks()[b];
    if (!reaches(block, b < ground_blocks_.size() ? margin : 0.0, p)) continue;
    const double height = continued_roof_height(block, p);
    if (!top || height > top->height) top = Sample{static_cast<int>(b), height};
  }
  return top;
}

}  // namespace gable
