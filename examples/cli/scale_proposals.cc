#include "examples/cli/scale_proposals.h"

#include <gable/engine/scales/known_scales.h>
#include <gable/engine/scales/scale_chain.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace gable {
namespace {

ScaleLabels spread_evenly(const Trajectory& trajectory, int num_scales) {
  ScaleLabels labels;
  labels.num_configurations = trajectory.num_configurations();
  for (int k = 1; k <= num_scales; ++k) {
    const double share = 1.0 - static_cast<double>(k) / (num_scales + 1);
    const long shapes = std::lround(std::pow(trajectory.num_first, share));
    labels.first.push_back(std::clamp(trajectory.num_first - static_cast<int>(shapes), 0,
                                      labels.num_configurations - 1));
  }
  return labels;
}

}  // namespace

std::vector<std::vector<int>> known_planes(const Scan& scan) {
  std::vector<std::vector<int>> planes;
  while (true) {
    const auto found = scan.labels.find("scale_" + std::to_string(planes.size() + 1));
    if (found == scan.labels.end()) return planes;
    planes.push_back(found->second);
  }
}

ScaleProposal propose_scales(const Scan& scan, const CollapsedScan& collapsed, int num_scales,
                             const ScaleModel* model) {
  const std::vector<std::vector<int>> known = known_planes(scan);
  if (static_cast<int>(known.size()) == num_scales) {
    return {known_scales(known, collapsed.first_shapes, collapsed.trajectory), true};
  }
  if (model != nullptr && model->num_scales() == num_scales) {
    return {label_trajectory(collapsed.trajectory.features, model->forest, {model->gamma}), false};
  }
  return {spread_evenly(collapsed.trajectory, num_scales), false};
}

}  // namespace gable
