#include <gable/engine/closing/labelled_plan.h>

namespace gable {

void PlaneChoice::add(const Plane& plane, int origin, const Eigen::AlignedBox3d& reach) {
  planes.push_back(plane);
  origins.push_back(origin);
  reaches.push_back(reach);
}

PlaneChoice used_planes(const PlaneChoice& choice, LabelledPlan* labelled) {
  std::vector<int> number(choice.planes.size(), -1);
  for (const int l : labelled->labels) number[l] = 0;
  PlaneChoice used;
  for (size_t i = 0; i < number.size(); ++i) {
    if (number[i] < 0) continue;
    number[i] = static_cast<int>(used.planes.size());
    used.add(choice.planes[i], choice.origins[i], choice.reaches[i]);
  }
  for (int& l : labelled->labels) l = number[l];
  for (PlanLine& line : labelled->lines) {
    if (!line.is_crease()) continue;
    line.a = number[line.a];
    line.b = number[line.b];
    if (line.a < 0 || line.b < 0) line.a = line.b = -1;
  }
  return used;
}

std::optional<RoofPartition> partition_of(const LabelledPlan& labelled,
                                          const std::vector<Plane>& planes) {
  return partition_plan(labelled.division.segments(), planes, [&](const Eigen::Vector2d& p) {
    const int cell = labelled.division.cell_at(p);
    return cell < 0 ? -1 : labelled.labels[cell];
  });
}

}  // namespace gable
