#include <gable/grammar/block.h>
#include <gable/grammar/synthesis/houses/distinct.h>
#include <gable/grammar/synthesis/houses/flat_parts.h>
#include <gable/grammar/synthesis/houses/rectangle.h>

#include <cmath>

namespace gable {
namespace {

constexpr double kFirstArea = 12.0;

}  // namespace

bool flat_parts_are_distinct(const House& house) {
  const auto blocks = expand_blocks(house);
  const Rectangle first = rectangle_of(blocks[0]);
  using namespace block_value;
  const double top = blocks[0][kEaves] + (blocks[0].flat ? 0.0 : blocks[0][kRise]);
  double hidden_of_first = 0.0;
  for (int i = 1; i < house.num_components(); ++i) {
    const Rectangle part = rectangle_of(blocks[i]);
    const double height = blocks[i][kEaves];
    if (!blocks[i].flat || height < kFlatBlockHeight || top - height < kDistinctStep) return false;
    // A flat part covers the slope that it reaches into; a higher flat block covers it instead.
    const double shared = shared_area(part, first);
    const bool below_first = height <= blocks[0][kEaves];
    double hidden = below_first ? shared : 0.0;
    if (!below_first) hidden_of_first += shared;
    for (int j = 1; j < house.num_components(); ++j) {
      if (j == i) continue;
      if (std::abs(blocks[j][kEaves] - height) < kDistinctStep) return false;
      if (blocks[j][kEaves] > height) hidden += shared_area(part, rectangle_of(blocks[j]));
    }
    if (part.area() - hidden < kFlatPartArea) return false;
  }
  return first.area() - hidden_of_first >= kFirstArea;
}

}  // namespace gable
