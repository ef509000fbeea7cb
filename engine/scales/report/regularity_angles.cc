#include <gable/engine/scales/report/regularity_angles.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace gable {
namespace {

/// Radians by which the lines along two vectors miss being parallel (or orthogonal).
double miss(const Eigen::Vector3d& a, const Eigen::Vector3d& b, bool orthogonal) {
  const double along = std::abs(a.dot(b)), across = a.cross(b).norm();
  return orthogonal ? std::atan2(along, across) : std::atan2(across, along);
}

double mean_miss(const std::vector<OrientedPlane>& planes,
                 const std::vector<PlaneRegularity>& regularities) {
  double sum = 0.0;
  int count = 0;
  for (const PlaneRegularity& r : regularities) {
    if (r.kind == RegularityKind::kEqualSlope) continue;
    const Eigen::Vector3d& a = planes[r.a].normal();
    const Eigen::Vector3d b = r.b < 0 ? Eigen::Vector3d::UnitZ().eval() : planes[r.b].normal();
    sum += miss(a, b, r.kind == RegularityKind::kOrthogonal || r.kind == RegularityKind::kVertical);
    ++count;
  }
  return count > 0 ? sum / count * 180.0 / M_PI : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

RegularityAngles regularity_angles(const PlaneRefit& refit) {
  return {mean_miss(refit.before, refit.regularities), mean_miss(refit.after, refit.regularities)};
}

}  // namespace gable
