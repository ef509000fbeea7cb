#include "plane_methods.h"

#include <gable/engine/io/model_folder.h>
#include <gable/engine/io/shapes/scale_model_file.h>
#include <gable/engine/scales/detect_scales.h>
#include <gable/engine/scales/known_scales.h>

#include <algorithm>
#include <cstdio>

#ifdef GABLE_WITH_CGAL
#include "cgal_planes.h"
#endif

namespace gable {
namespace {

constexpr char kModel[] = "buildings";
constexpr int kScale = 2;  // structure
constexpr int kNumScales = 3;

FirstShapesOptions first_shapes_options() {
  FirstShapesOptions options;
  options.threads = 2;
  return options;
}

/// The shapes of the scale that the model finds, planes as the collapse leaves them.
PlaneMethod gable_method(const ScaleModel& model) {
  const auto detect = [model](const Scan& scan, double) {
    DetectScalesOptions options;
    options.first_shapes = first_shapes_options();
    options.refit_planes = false;
    options.polygons = false;
    return detect_scales(scan, model, options).scales.at(kScale - 1).shape_of;
  };
  return {"gable", "", {0.0}, nullptr, detect};
}

/// The same trajectory at the configuration that known_scales takes for the truth of all scales:
/// what a model that chooses as it was taught would give. Its measure is not the Rand index, so
/// another configuration may have a higher one.
PlaneMethod known_scale_method() {
  const auto detect = [](const Scan& scan, double) {
    std::vector<std::vector<int>> truths;
    for (int scale = 1; scale <= kNumScales; ++scale) {
      truths.push_back(scan.labels.at("scale_" + std::to_string(scale)));
    }
    const CollapsedScan collapsed = collapse_scan(scan, first_shapes_options());
    const int last = collapsed.trajectory.num_configurations() - 1;
    const ScaleLabels known = known_scales(truths, collapsed.first_shapes, collapsed.trajectory);
    return shapes_of_elements(collapsed, std::min(known.first[kScale - 1], last));
  };
  return {"gable, known scale", "", {0.0}, nullptr, detect};
}

std::vector<PlaneMethod> gable_methods() {
  std::vector<PlaneMethod> methods;
  const std::vector<std::string> names = scale_model_names();
  if (std::find(names.begin(), names.end(), kModel) != names.end()) {
    methods.push_back(gable_method(read_scale_model(find_scale_model(kModel))));
  } else {
    std::fprintf(stderr, "no model %s: gable is measured with the known scale alone\n", kModel);
  }
  methods.push_back(known_scale_method());
  return methods;
}

#ifdef GABLE_WITH_CGAL

/// What CGAL's detectors see of the normals.
struct NormalSetting {
  int neighbours;
  double angle_deg;  ///< largest between a point's normal and its plane's
};
/// What to try at a level of noise.
struct CgalGrid {
  NormalSetting normals;
  std::vector<double> growing_percent;  ///< tolerances, of the diagonal
  std::vector<double> ransac_percent;
};

/// The best neighbourhood of 20, 50, 150 and 300 points and angle of 15 to 60 degrees (CGAL's
/// default is 25), and the tolerances of 0.05 to 4 % that came near the best on 15 buildings.
CgalGrid cgal_grid(double noise) {
  if (noise < 0.0025) return {{20, 25.0}, {0.05, 0.1, 0.2, 0.5}, {0.05, 0.1, 0.2, 0.5}};
  if (noise < 0.0075) return {{150, 40.0}, {0.5, 1.0, 1.5, 2.0, 3.0}, {0.5, 1.0, 1.5, 2.0}};
  return {{150, 40.0}, {1.0, 1.5, 2.0, 3.0, 4.0}, {1.0, 1.5, 2.0, 3.0}};
}

/// Planes of fewer points, as a share of all, are left out.
constexpr double kLeastShare = 0.001;

using CgalDetector = std::vector<int>(const std::vector<Eigen::Vector3d>&,
                                      const std::vector<Eigen::Vector3d>&, const CgalPlaneOptions&);

PlaneMethod cgal_method(const std::string& name, CgalDetector* detector,
                        const NormalSetting& setting, const std::vector<double>& percents) {
  const auto add_normals = [setting](Scan* scan) {
    scan->normals.clear();
    for (const Eigen::Vector3d& normal : cgal_normals(scan->points, setting.neighbours)) {
      scan->normals.push_back(normal.cast<float>());
    }
  };
  const auto detect = [detector, setting](const Scan& scan, double epsilon) {
    std::vector<Eigen::Vector3d> normals;
    for (const Eigen::Vector3f& normal : scan.normals) normals.push_back(normal.cast<double>());
    CgalPlaneOptions options;
    options.epsilon = epsilon;
    options.angle = setting.angle_deg;
    options.least_points = std::max(3, static_cast<int>(kLeastShare * scan.points.size()));
    return detector(scan.points, normals, options);
  };
  return {name, "k " + std::to_string(setting.neighbours), percents, add_normals, detect};
}

#endif

}  // namespace

std::vector<PlaneMethod> plane_methods([[maybe_unused]] double noise) {
  std::vector<PlaneMethod> methods = gable_methods();
#ifdef GABLE_WITH_CGAL
  const CgalGrid grid = cgal_grid(noise);
  methods.push_back(
      cgal_method("CGAL region growing", cgal_region_growing, grid.normals, grid.growing_percent));
  methods.push_back(cgal_method("CGAL Efficient RANSAC", cgal_efficient_ransac, grid.normals,
                                grid.ransac_percent));
#endif
  return methods;
}

}  // namespace gable
