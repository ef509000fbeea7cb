#pragma once

#include <gable/engine/scan.h>

namespace gable {

/// A cloud to measure times on: two storeys of three by two furnished rooms of 5 x 4 x 2.8 m under
/// a saddle roof, about 300 planar faces, sampled uniformly with noise of 0.1 % of the diagonal
/// and 1 % outliers. The same points for the same number of points. No normals, no labels.
Scan make_scan_scene(int num_points);

}  // namespace gable
