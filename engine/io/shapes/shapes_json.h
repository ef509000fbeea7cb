#pragma once

#include <gable/engine/scales/planar_shape.h>

#include <string>

namespace gable {

/// Writes the shapes of a scale as JSON, in the frame of the scan, numbers exact:
///
///     {"configuration": 118,   which of the trajectory
///      "elements": 100000,     of the scan: points, or facets of a mesh
///      "coverage": 0.93,       share of the elements (of a mesh: of its area) in shapes
///      "rms": 0.012,           metres, over all inliers
///      "shapes": [{"shape": 0,               its number in the labelled PLY
///                  "normal": [x, y, z], "offset": d,   the points p with normal . p = d, metres
///                  "centroid": [x, y, z],
///                  "inliers": 1200,          elements
///                  "area": 31.5,             square metres, of the polygons
///                  "rms": 0.011,             metres
///                  "polygons": [{"outer": [[x, y, z], ...], "holes": [[[x, y, z], ...], ...]}]}]}
///
/// Throws Error (kCannotWrite).
void write_shapes_json(const std::string& path, const ScaleShapes& shapes);

/// The same as text.
std::string shapes_json(const ScaleShapes& shapes);

}  // namespace gable
