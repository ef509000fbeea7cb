#include <gable/engine/reconstruct/choice/roof_simplification.h>

namespace gable {

int simplify_roofs(const HeightImage& image, const PenaltyOptions& penalty, House* house) {
  int changed = 0;
  double cost = penalised_cost(image, *house, penalty).total;
  for (Rule& roof : house->roofs) {
    // Each simpler kind is tried from the roof as it is: a hip may be flat without being a gable.
    const Rule before = roof;
    for (const RuleKind kind : {RuleKind::kRoofGable, RuleKind::kRoofFlat}) {
      if (before.kind == RuleKind::kRoofFlat || before.kind == kind) continue;
      const Rule best = roof;
      roof = before;
      roof.kind = kind;
      roof[param::roof::kHipStart] = roof[param::roof::kHipEnd] = 0.0;
      if (kind == RuleKind::kRoofFlat) {
        roof[param::roof::kEaves] += 0.4 * roof[param::roof::kRise];
        roof[param::roof::kRise] = 0.0;
      }
      const double simpler = penalised_cost(image, *house, penalty).total;
      if (simpler < cost) {
        cost = simpler;
        ++changed;
      } else {
        roof = best;
      }
    }
  }
  return changed;
}

}  // namespace gable
