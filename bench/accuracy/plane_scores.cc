#include "plane_scores.h"

#include <gable/engine/evaluate/rand_index.h>
#include <gable/residuals/point_moments.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>

namespace gable {

PlaneScores score_planes(const std::vector<Eigen::Vector3d>& points, const std::vector<int>& truth,
                         const std::vector<int>& plane_of) {
  std::vector<int> known, found;
  std::map<int, PointMoments> moments;
  Eigen::AlignedBox<double, 3> box;
  for (size_t i = 0; i < points.size(); ++i) {
    box.extend(points[i]);
    if (truth[i] >= 0) {
      known.push_back(truth[i]);
      found.push_back(plane_of[i]);
    }
    if (plane_of[i] < 0) continue;
    PointMoments& plane = moments[plane_of[i]];
    if (plane.weight == 0.0) plane.reference = points[i];
    plane.add(points[i]);
  }
  PlaneScores scores;
  scores.rand_index = adjusted_rand_index(known, found);
  scores.planes = static_cast<double>(moments.size());
  double square = 0.0, count = 0.0;
  for (const auto& [number, plane] : moments) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(plane.scatter());
    square += std::max(axes.eigenvalues()[0], 0.0);
    count += plane.weight;
  }
  scores.coverage = count / static_cast<double>(points.size());
  if (count > 0.0) scores.rms = std::sqrt(square / count) / box.diagonal().norm();
  return scores;
}

}  // namespace gable
