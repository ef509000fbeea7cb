#pragma once

#include <gable/engine/scales/first_shapes.h>
#include <gable/engine/scales/planar_shape.h>
#include <gable/engine/scales/refit_shapes.h>
#include <gable/engine/scales/scale_labels.h>
#include <gable/engine/scales/scale_model.h>
#include <gable/engine/scales/trajectory.h>
#include <gable/engine/scan.h>

#include <string>
#include <vector>

namespace gable {

/// How the structural scales of a scan are found. The defaults serve all inputs.
struct DetectScalesOptions {
  FirstShapesOptions first_shapes;
  RefitOptions refit;
  bool refit_planes = true;  ///< false: planes stay least squares through their elements
  bool polygons = true;      ///< outline the shapes
  /// Scales to keep, [0, scales of the model]; 0: all. Of more, those remain whose first
  /// configurations differ most from the ones before them.
  int num_scales = 0;
};

/// Empty if the options are in range for a model; otherwise names the violated bound.
std::string check(const DetectScalesOptions& options, const ScaleModel& model);

/// The structural scales of a scan, and how they were found.
struct DetectedScales {
  FirstShapes first_shapes;
  Trajectory trajectory;
  /// Scales kept. A scale that the trajectory does not reach begins at its last configuration.
  ScaleLabels labels;
  std::vector<ScaleShapes> scales;  ///< finest first
  std::vector<PlaneRefit> refits;   ///< per scale; none without refit_planes
};

/// First shapes and their collapse, the trajectory that everything else is read off (CVPR 2018,
/// section 4).
struct CollapsedScan {
  FirstShapes first_shapes;
  Trajectory trajectory;
};
CollapsedScan collapse_scan(const Scan& scan, const FirstShapesOptions& options);

/// The shape of every element of a scan (-1: none) in a configuration of its trajectory.
std::vector<int> shapes_of_elements(const CollapsedScan& collapsed, int configuration);

/// The planar shapes of a configuration, with planes refitted together as `options` say.
/// refit (may be null): what that did.
ScaleShapes shapes_of_configuration(const Scan& scan, const CollapsedScan& collapsed,
                                    int configuration, const DetectScalesOptions& options,
                                    PlaneRefit* refit);

/// Finds the structural scales of a scan (CVPR 2018): first shapes, their collapse, labels by the
/// model, and the first configuration of each scale with its planes refitted together. A scan
/// without shapes has scales without shapes.
DetectedScales detect_scales(const Scan& scan, const ScaleModel& model,
                             const DetectScalesOptions& options);

}  // namespace gable
