#include <gable/grammar/height_field.h>
#include <gable/grammar/outline_margins.h>

#include <algorithm>

namespace gable {

bool reaches(const Block<double>& block, double margin, const Eigen::Vector2d& point) {
  using namespace block_value;
  return point.x() >= block[kX0] - margin && point.x() < block[kX1] + margin &&
         point.y() >= block[kY0] - margin && point.y() < block[kY1] + margin;
}

double continued_roof_height(const Block<double>& block, const Eigen::Vector2d& point) {
  using namespace block_value;
  const auto at = [&](Facet facet) { return facet_height(block, facet, point.x(), point.y()); };
  if (block.flat) return at(Facet::kFlat);
  double height = std::min(at(Facet::kLow), at(Facet::kHigh));
  // A gable wall has no plane to continue.
  if (block[kHipStart] > 0.0) height = std::min(height, at(Facet::kStart));
  if (block[kHipEnd] > 0.0) height = std::min(height, at(Facet::kEnd));
  return height;
}

double outline_margin_at(std::span<const Block<double>> ground_blocks, double most,
                         const Eigen::Vector2d& point) {
  for (const double margin : kOutlineMargins) {
    if (margin > most) break;
    if (std::any_of(ground_blocks.begin(), ground_blocks.end(),
                    [&](const Block<double>& b) { return reaches(b, margin, point); })) {
      return margin;
    }
  }
  return -1.0;
}

}  // namespace gable
