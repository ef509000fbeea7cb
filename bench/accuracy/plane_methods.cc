#include "plane_methods.h"

#ifdef GABLE_WITH_CGAL
#include <algorithm>

#include "cgal_planes.h"
#endif

namespace gable {
namespace {

#ifdef GABLE_WITH_CGAL

const std::vector<double> kEpsilonsPercent = {0.05, 0.1, 0.2, 0.5, 1.0, 1.5, 2.0, 3.0};

/// Of the neighbourhoods 20, 50, 150 and 300 the one with the best results for the method.
constexpr int kNormalNeighbours = 150;
/// Planes of fewer points, as a share of all, are left out.
constexpr double kLeastShare = 0.001;

void add_normals(Scan* scan) {
  scan->normals.clear();
  for (const Eigen::Vector3d& normal : cgal_normals(scan->points, kNormalNeighbours)) {
    scan->normals.push_back(normal.cast<float>());
  }
}

using CgalDetector = std::vector<int>(const std::vector<Eigen::Vector3d>&,
                                      const std::vector<Eigen::Vector3d>&, const CgalPlaneOptions&);

PlaneMethod cgal_method(const std::string& name, CgalDetector* detector) {
  const auto detect = [detector](const Scan& scan, double epsilon) {
    std::vector<Eigen::Vector3d> normals;
    for (const Eigen::Vector3f& normal : scan.normals) normals.push_back(normal.cast<double>());
    CgalPlaneOptions options;
    options.epsilon = epsilon;
    options.least_points = std::max(3, static_cast<int>(kLeastShare * scan.points.size()));
    return detector(scan.points, normals, options);
  };
  return {name, kEpsilonsPercent, add_normals, detect};
}

#endif

}  // namespace

std::vector<PlaneMethod> plane_methods() {
  std::vector<PlaneMethod> methods;
#ifdef GABLE_WITH_CGAL
  methods.push_back(cgal_method("CGAL region growing", cgal_region_growing));
  methods.push_back(cgal_method("CGAL Efficient RANSAC", cgal_efficient_ransac));
#endif
  return methods;
}

}  // namespace gable
