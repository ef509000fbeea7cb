#pragma once

#include <gable/engine/drawing/report_file.h>
#include <gable/engine/scales/planar_shape.h>
#include <gable/engine/scales/scale_labels.h>
#include <gable/engine/scales/trajectory.h>
#include <gable/engine/scan.h>

#include <string>
#include <vector>

namespace gable {

/// How far related planes of a scale miss their regularities (parallel, orthogonal), mean angles in
/// degrees.
struct RegularityAngles {
  double before = 0.0;  ///< refitting
  double after = 0.0;
};

/// What a report on the scales of a scan shows. The referred parts outlive it.
struct ScalesReport {
  std::string title;  ///< the name of the scan
  const Scan& scan;
  const FirstShapes& first_shapes;
  const Trajectory& trajectory;
  const ScaleLabels& labels;
  const std::vector<ScaleShapes>&
      scales;                           ///< finest first; drawn by their polygons if they have any
  std::vector<std::string> names = {};  ///< per scale, "roofs"; or none
  std::vector<RegularityAngles> angles = {};  ///< per scale, or none
};

/// The files of the report: the pictures of the scan, of every scale and of the labelled
/// trajectory, and after them index.html, which shows them side by side with their figures and
/// needs nothing but the files beside it.
std::vector<ReportFile> scales_report(const ScalesReport& report);

}  // namespace gable
