#include <gable/training/scans/face_plane.h>

#include <Eigen/Geometry>

namespace gable {

FacePlane face_plane(const Solid& solid, const Face& face) {
  const std::vector<int>& outer = face.rings[0];
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const int corner : outer) mean += solid.vertices[corner];
  mean /= static_cast<double>(outer.size());
  Eigen::Vector3d twice_area = Eigen::Vector3d::Zero();
  for (const std::vector<int>& ring : face.rings) {
    for (size_t i = 0; i < ring.size(); ++i) {
      const Eigen::Vector3d a = solid.vertices[ring[i]] - mean;
      const Eigen::Vector3d b = solid.vertices[ring[(i + 1) % ring.size()]] - mean;
      twice_area += a.cross(b);
    }
  }
  FacePlane plane;
  plane.area = 0.5 * twice_area.norm();
  if (plane.area > 0.0) plane.normal = twice_area.normalized();
  plane.offset = plane.normal.dot(mean);
  return plane;
}

}  // namespace gable
