#pragma once

#include <gable/engine/scan.h>

#include <vector>

namespace gable {

/// How well planes found in a cloud agree with known ones.
struct PlaneScores {
  double rand_index = 0.0;  ///< adjusted, over the points with a known plane; unassigned: one class
  double planes = 0.0;      ///< number found
  double coverage = 0.0;    ///< share of all points in planes
  double rms = 0.0;         ///< of the planes' points from their least-squares planes, share of the
                            ///< diagonal of the points' bounding box
};

/// truth, plane_of: per point the number of its plane, -1 for none.
PlaneScores score_planes(const std::vector<Eigen::Vector3d>& points, const std::vector<int>& truth,
                         const std::vector<int>& plane_of);

}  // namespace gable
