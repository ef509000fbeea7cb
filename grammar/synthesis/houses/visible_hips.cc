#include <gable/grammar/block.h>
#include <gable/grammar/synthesis/houses/rectangle.h>
#include <gable/grammar/synthesis/houses/visible_hips.h>

namespace gable {

void drop_short_hips(double least_run, House* house) {
  namespace r = param::roof;
  const auto blocks = expand_blocks(*house);
  for (int i = 0; i < house->num_components(); ++i) {
    Rule& roof = house->roofs[i];
    if (roof.kind != RuleKind::kRoofHip) continue;
    const Rectangle at = rectangle_of(blocks[i]);
    const double length = roof.ridge == Axis::kX ? at.size_x() : at.size_y();
    for (int end : {r::kHipStart, r::kHipEnd}) {
      if (roof[end] * length < least_run) roof[end] = 0.0;
    }
    if (roof[r::kHipStart] > 0.0 || roof[r::kHipEnd] > 0.0) continue;
    Rule gable = make_rule(RuleKind::kRoofGable);
    gable.ridge = roof.ridge;
    gable[r::kEaves] = roof[r::kEaves];
    gable[r::kRise] = roof[r::kRise];
    roof = gable;
  }
}

}  // namespace gable
