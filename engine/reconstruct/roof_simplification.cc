#include <gable/engine/reconstruct/roof_simplification.h>

namespace gable {

int simplify_roofs(const HeightImage& image, const PenaltyOptions& penalty, House* house) {
  int changed = 0;
  double cost = penalised_cost(image, *house, penalty).total;
  for (Rule& roof : house->roofs) {
    const Rule before = roof;
    if (roof.kind == RuleKind::kRoofHip) {
      roof.kind = RuleKind::kRoofGable;
      roof[param::roof::kHipStart] = roof[param::roof::kHipEnd] = 0.0;
    } else if (roof.kind == RuleKind::kRoofGable) {
      roof.kind = RuleKind::kRoofFlat;
      roof[param::roof::kEaves] += 0.5 * roof[param::roof::kRise];
    } else {
      continue;
    }
    const double simpler = penalised_cost(image, *house, penalty).total;
    if (simpler < cost) {
      cost = simpler;
      ++changed;
    } else {
      roof = before;
    }
  }
  return changed;
}

}  // namespace gable
