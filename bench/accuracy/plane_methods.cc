#include "plane_methods.h"

#ifdef GABLE_WITH_CGAL
#include <algorithm>

#include "cgal_planes.h"
#endif

namespace gable {
namespace {

#ifdef GABLE_WITH_CGAL

const std::vector<double> kEpsilonsPercent = {0.05, 0.1, 0.2, 0.5, 1.0, 1.5, 2.0, 3.0};

/// What CGAL's detectors see of the normals.
struct NormalSetting {
  int neighbours;
  double angle_deg;  ///< largest between a point's normal and its plane's
};
/// The best of neighbourhoods of 20, 50, 150 and 300 points and angles of 15 to 60 degrees without
/// noise and with it. CGAL's default angle is 25 degrees.
constexpr NormalSetting kNormalSettings[] = {{20, 25.0}, {150, 40.0}};
/// Planes of fewer points, as a share of all, are left out.
constexpr double kLeastShare = 0.001;

using CgalDetector = std::vector<int>(const std::vector<Eigen::Vector3d>&,
                                      const std::vector<Eigen::Vector3d>&, const CgalPlaneOptions&);

PlaneMethod cgal_method(const std::string& name, CgalDetector* detector,
                        const NormalSetting& setting) {
  const auto add_normals = [setting](Scan* scan) {
    scan->normals.clear();
    for (const Eigen::Vector3d& normal : cgal_normals(scan->points, setting.neighbours)) {
      scan->normals.push_back(normal.cast<float>());
    }
  };
  const auto detect = [detector, setting](const Scan& scan, double epsilon) {
    std::vector<Eigen::Vector3d> normals;
    for (const Eigen::Vector3f& normal : scan.normals) normals.push_back(normal.cast<double>());
    CgalPlaneOptions options;
    options.epsilon = epsilon;
    options.angle = setting.angle_deg;
    options.least_points = std::max(3, static_cast<int>(kLeastShare * scan.points.size()));
    return detector(scan.points, normals, options);
  };
  return {name, "k " + std::to_string(setting.neighbours), kEpsilonsPercent, add_normals, detect};
}

#endif

}  // namespace

std::vector<PlaneMethod> plane_methods() {
  std::vector<PlaneMethod> methods;
#ifdef GABLE_WITH_CGAL
  for (const NormalSetting& setting : kNormalSettings) {
    methods.push_back(cgal_method("CGAL region growing", cgal_region_growing, setting));
    methods.push_back(cgal_method("CGAL Efficient RANSAC", cgal_efficient_ransac, setting));
  }
#endif
  return methods;
}

}  // namespace gable
