#include <gable/engine/scales/collapse.h>
#include <gable/engine/scales/detect_scales.h>
#include <gable/engine/scales/measure_shapes.h>
#include <gable/engine/scales/outline/facet_polygon.h>
#include <gable/engine/scales/outline/inlier_polygon.h>
#include <gable/engine/scales/outline/outlined_region.h>
#include <gable/engine/scales/scale_chain.h>
#include <glog/logging.h>

#include <algorithm>
#include <numeric>

namespace gable {
namespace {

void add_polygons(const Scan& scan, ScaleShapes* scale) {
  std::vector<std::vector<int>> members(scale->shapes.size());
  for (size_t i = 0; i < scale->shape_of.size(); ++i) {
    if (scale->shape_of[i] >= 0) members[scale->shape_of[i]].push_back(static_cast<int>(i));
  }
  for (size_t s = 0; s < scale->shapes.size(); ++s) {
    PlanarShape& shape = scale->shapes[s];
    if (scan.is_mesh()) {
      shape.polygons = facet_polygons(scan, members[s], shape.plane);
    } else {
      std::vector<Eigen::Vector3d> points;
      for (int i : members[s]) points.push_back(scan.points[i]);
      shape.polygons = inlier_polygons(points, shape.plane);
    }
    shape.area = 0.0;
    for (const SpacePolygon& polygon : shape.polygons) shape.area += area_of(polygon);
  }
}

// Of K scales the `count` whose beginnings change the shapes most, in their order.
std::vector<int> most_distinct(const ScaleLabels& labels,
                               const std::vector<ScaleFeatures>& features, int count) {
  std::vector<int> scales(labels.num_scales());
  std::iota(scales.begin(), scales.end(), 0);
  const auto change = [&](int scale) {
    const int first = labels.first[scale];
    return first == 0 ? 0.0 : feature_distance(features[first - 1], features[first]);
  };
  std::stable_sort(scales.begin(), scales.end(),
                   [&](int a, int b) { return change(a) > change(b); });
  scales.resize(count);
  std::sort(scales.begin(), scales.end());
  return scales;
}

}  // namespace

std::string check(const DetectScalesOptions& options, const ScaleModel& model) {
  if (options.num_scales < 0 || options.num_scales > model.num_scales()) {
    return "num_scales must lie in [0, " + std::to_string(model.num_scales()) +
           "], the scales of the model";
  }
  const std::string first = check(options.first_shapes);
  return first.empty() ? check(options.refit) : first;
}

CollapsedScan collapse_scan(const Scan& scan, const FirstShapesOptions& options) {
  CollapsedScan out;
  out.first_shapes = find_first_shapes(scan, options);
  out.trajectory = collapse(out.first_shapes);
  return out;
}

std::vector<int> shapes_of_elements(const CollapsedScan& collapsed, int configuration) {
  const std::vector<int> shape_of_first = shapes_at(collapsed.trajectory, configuration);
  std::vector<int> shape_of = collapsed.first_shapes.shape_of;
  for (int& shape : shape_of) {
    if (shape >= 0) shape = shape_of_first[shape];
  }
  return shape_of;
}

ScaleShapes shapes_of_configuration(const Scan& scan, const CollapsedScan& collapsed,
                                    int configuration, const DetectScalesOptions& options,
                                    PlaneRefit* refit) {
  const std::vector<int> shape_of = shapes_of_elements(collapsed, configuration);
  RefitOptions refitting = options.refit;
  refitting.regularities = refitting.regularities && options.refit_planes;
  const PlaneRefit fitted = refit_shapes(scan, shape_of, refitting);
  ScaleShapes scale =
      measure_shapes(scan, shape_of, options.refit_planes ? fitted.after : fitted.before);
  scale.configuration = configuration;
  if (options.polygons) add_polygons(scan, &scale);
  if (refit != nullptr) *refit = fitted;
  return scale;
}

DetectedScales detect_scales(const Scan& scan, const ScaleModel& model,
                             const DetectScalesOptions& options) {
  CHECK(check(options, model).empty()) << check(options, model);
  const CollapsedScan collapsed = collapse_scan(scan, options.first_shapes);
  const Trajectory& trajectory = collapsed.trajectory;
  DetectedScales out;
  out.labels = label_trajectory(trajectory.features, model.forest, {model.gamma});
  for (int& first : out.labels.first) first = std::min(first, trajectory.num_configurations() - 1);
  if (options.num_scales > 0 && options.num_scales < model.num_scales()) {
    std::vector<int> first;
    for (int scale : most_distinct(out.labels, trajectory.features, options.num_scales)) {
      first.push_back(out.labels.first[scale]);
    }
    out.labels.first = first;
  }
  for (int first : out.labels.first) {
    PlaneRefit refit;
    out.scales.push_back(shapes_of_configuration(scan, collapsed, first, options, &refit));
    if (options.refit_planes) out.refits.push_back(refit);
  }
  out.first_shapes = collapsed.first_shapes;
  out.trajectory = collapsed.trajectory;
  return out;
}

}  // namespace gable
