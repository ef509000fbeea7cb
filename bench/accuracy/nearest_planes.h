#pragma once

#include <gable/training/scans/labelled_surface.h>

#include <vector>

namespace gable {

/// What a detector could reach that knew the surface: for every point the plane of the nearest
/// triangle, at a scale (0: detail). Where noise has carried points over an edge to another plane
/// nothing tells them apart, so that this is about the best there is.
std::vector<int> nearest_planes(const LabelledSurface& surface, int scale,
                                const std::vector<Eigen::Vector3d>& points);

}  // namespace gable
