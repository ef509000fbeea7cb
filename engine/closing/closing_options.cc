#include <gable/engine/closing/closing_options.h>

namespace gable {

std::string check(const ClosingOptions& options) {
  if (!(options.loss_scale > 0.0 && options.loss_scale <= 100.0)) {
    return "loss_scale must lie in (0, 100] m";
  }
  if (!(options.boundary_cost >= 0.0 && options.boundary_cost <= 1000.0)) {
    return "boundary_cost must lie in [0, 1000] square metres";
  }
  if (!(options.step_cost >= 0.0 && options.step_cost <= 1000.0)) {
    return "step_cost must lie in [0, 1000] m";
  }
  if (!(options.plane_charge >= 0.0 && options.plane_charge <= 1e6)) {
    return "plane_charge must lie in [0, 1e6] cubic metres";
  }
  if (!(options.least_step_length > 0.0 && options.least_step_length <= 1000.0)) {
    return "least_step_length must lie in (0, 1000] m";
  }
  if (!(options.snap_distance >= 0.0 && options.snap_distance <= 100.0)) {
    return "snap_distance must lie in [0, 100] m";
  }
  if (options.max_lines < 0 || options.max_lines > 2000) {
    return "max_lines must lie in [0, 2000]";
  }
  if (options.max_grid < 16 || options.max_grid > 1000000) {
    return "max_grid must lie in [16, 1e6]";
  }
  if (options.max_refits < 0 || options.max_refits > 100) return "max_refits must lie in [0, 100]";
  if (!(options.clearance >= 0.01 && options.clearance <= 100.0)) {
    return "clearance must lie in [0.01, 100] m";
  }
  if (!(options.headroom >= 0.0 && options.headroom <= 1000.0)) {
    return "headroom must lie in [0, 1000] m";
  }
  if (std::string error = check(options.refinement); !error.empty()) return error;
  return check(options.regularities);
}

}  // namespace gable
