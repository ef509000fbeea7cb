#pragma once

#include <Eigen/Core>
#include <vector>

namespace gable {

/// The points of a scan in an order that keeps near points near in memory (along a Morton curve),
/// which is what makes searches over millions of points fast.
struct OrderedCloud {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< of the bounding box, frame of the scan
  double diagonal = 0.0;                             ///< of the bounding box, metres
  std::vector<Eigen::Vector3f> positions;            ///< relative to the centre, metres
  std::vector<int> source;                           ///< which point of the scan each one is

  int size() const { return static_cast<int>(positions.size()); }
};

/// Orders points; equal cells of the curve keep the order of the scan.
OrderedCloud order_cloud(const std::vector<Eigen::Vector3d>& points);

}  // namespace gable
