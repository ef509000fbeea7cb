#include <gable/engine/scales/facet_regions.h>
#include <gable/engine/scales/first_shapes.h>
#include <gable/engine/scales/point_regions.h>
#include <glog/logging.h>

namespace gable {

std::string check(const FirstShapesOptions& options) {
  if (!(options.epsilon_percent >= 0.0 && options.epsilon_percent <= 10.0)) {
    return "epsilon_percent must lie in [0, 10]";
  }
  if (!(options.epsilon_deviations >= 0.0 && options.epsilon_deviations <= 10.0)) {
    return "epsilon_deviations must lie in [0, 10]";
  }
  if (!(options.max_angle > 0.0 && options.max_angle < 1.5708)) {
    return "max_angle must lie in (0, 1.5708)";
  }
  if (options.min_inliers < 1 || options.min_inliers > 1000000) {
    return "min_inliers must lie in [1, 1000000]";
  }
  if (options.neighbours < 3 || options.neighbours > 200) {
    return "neighbours must lie in [3, 200]";
  }
  if (options.threads < 1 || options.threads > 1024) return "threads must lie in [1, 1024]";
  return "";
}

FirstShapes find_first_shapes(const Scan& scan, const FirstShapesOptions& options) {
  CHECK(check(options).empty()) << check(options);
  return scan.is_mesh() ? grow_facet_regions(scan, options) : grow_point_regions(scan, options);
}

}  // namespace gable
