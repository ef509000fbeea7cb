#include <gable/engine/reconstruct/building/building_options.h>

namespace gable {
namespace {

// A margin that nothing exceeds, metres.
constexpr double kNever = 1000.0;

}  // namespace

bool BuildingOptions::planes_may_replace(double distance) const {
  return planes_margin < kNever && distance > planes_from;
}

std::string check(const BuildingOptions& options) {
  for (const std::string& error :
       {check(options.choice), check(options.house_scales), check(options.scale_values)}) {
    if (!error.empty()) return error;
  }
  if (!(options.least_area >= 0.0 && options.least_area <= 1000.0)) {
    return "least_area must lie in [0, 1000] square metres";
  }
  if (!(options.outline_tolerance >= 0.01 && options.outline_tolerance <= 10.0)) {
    return "outline_tolerance must lie in [0.01, 10] m";
  }
  if (const std::string error = check(options.closing); !error.empty()) return error;
  if (!(options.planes_from >= 0.0 && options.planes_from <= kNever)) {
    return "planes_from must lie in [0, 1000] m";
  }
  if (!(options.planes_margin >= 0.0 && options.planes_margin <= kNever)) {
    return "planes_margin must lie in [0, 1000] m";
  }
  if (!(options.planes_ratio >= 0.0 && options.planes_ratio <= 1.0)) {
    return "planes_ratio must lie in [0, 1]";
  }
  if (!(options.extrusion_margin >= 0.0 && options.extrusion_margin <= 10.0)) {
    return "extrusion_margin must lie in [0, 10] m";
  }
  return "";
}

}  // namespace gable
