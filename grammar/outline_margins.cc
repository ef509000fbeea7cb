#include <gable/grammar/height_field.h>
#include <gable/grammar/outline_margins.h>

#include <algorithm>
#include <limits>

namespace gable {

bool reaches(const Block<double>& block, double margin, const Eigen::Vector2d& point) {
  using namespace block_value;
  return point.x() >= block[kX0] - margin && point.x() < block[kX1] + margin &&
         point.y() >= block[kY0] - margin && point.y() < block[kY1] + margin;
}

double continued_roof_height(const Block<double>& block, const Eigen::Vector2d& point) {
  double height = std::numeric_limits<double>::infinity();
  for (int f = 0; f < kNumFacets; ++f) {
    const Facet facet = static_cast<Facet>(f);
    if (!has_facet(block, facet)) continue;
    height = std::min(height, facet_height(block, facet, point.x(), point.y()));
  }
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
