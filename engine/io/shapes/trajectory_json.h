#pragma once

#include <gable/engine/scales/scale_labels.h>
#include <gable/engine/scales/trajectory.h>

#include <string>

namespace gable {

/// All of a trajectory: which elements the first shapes have, how they merge, where scales begin.
struct TrajectoryFile {
  FirstShapes first_shapes;
  Trajectory trajectory;
  ScaleLabels scales;  ///< none: `first` empty
};

/// Writes a trajectory as JSON, numbers exact:
///
///     {"format": "gable trajectory", "version": 1,
///      "diagonal": 59.8,          metres, of the bounding box of the scan
///      "shape_of": [0, 0, -1],    per element of the scan (point, or facet of a mesh): its first
///                                 shape, or -1
///      "reference": [x, y, z],    what moments are relative to, in the frame of the scan
///      "moments": [[w, x, y, z, xx, xy, xz, yy, yz, zz], ...],   per first shape: sums of w,
///                                 w p and w p p', p relative to the reference
///      "adjacent": [[a, b], ...], pairs of first shapes that touch, a < b
///      "merges": [[a, b, weight], ...],
///      "features": [[...], ...],  per configuration; or none at all
///      "scales": [12, 80, 117]}   the first configuration of each scale, finest first; may be none
///
/// Of n first shapes, the i-th merge (from 0) makes shape n + i of shapes a and b; configuration c
/// is what there is after c merges. So to read off configuration c, let every element follow its
/// first shape through the first c merges. The plane of a shape follows from the sum of its first
/// shapes' moments.
///
/// Throws Error (kCannotWrite).
void write_trajectory_json(const std::string& path, const TrajectoryFile& file);

/// Reads what `write_trajectory_json` wrote, the same to the last bit but for the
/// upper triangles of second moments, which become mirrors of the lower ones. Throws Error:
/// kNoInput where the file does not exist, kBadInput where it is no such file or its numbers do not
/// fit together.
TrajectoryFile read_trajectory_json(const std::string& path);

}  // namespace gable
