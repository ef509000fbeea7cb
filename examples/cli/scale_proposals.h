#pragma once

#include <gable/engine/scales/detect_scales.h>
#include <gable/engine/scan.h>

namespace gable {

/// Where scales begin, before a person has looked.
struct ScaleProposal {
  ScaleLabels labels;
  bool known = false;  ///< from known planes in the scan
};

/// The known planes of a scan, finest scale first: its labels scale_1, scale_2, ... as far as they
/// go.
std::vector<std::vector<int>> known_planes(const Scan& scan);

/// The beginnings of scales from a scan's known planes, if it has as many scales (see
/// known_scales); or else from a model of as many scales (null: none); or else spread evenly over
/// the logarithm of the number of shapes.
ScaleProposal propose_scales(const Scan& scan, const CollapsedScan& collapsed, int num_scales,
                             const ScaleModel* model);

}  // namespace gable
