#include <gable/engine/solver/plane_uncertainty.h>
#include <gable/engine/solver/unstrained_refinement.h>
#include <glog/logging.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace gable {
namespace {

bool is_strained(const OrientedPlane& alone, const OrientedPlane& now, const PointMoments& moments,
                 const RegularityOptions& tolerances) {
  const PlaneUncertainty own = plane_uncertainty(alone, moments);
  const double shift =
      std::abs(now.signed_distance(own.centroid)) - std::abs(alone.signed_distance(own.centroid));
  if (shift >
      std::hypot(tolerances.distance_tolerance, tolerances.deviations * std::sqrt(own.distance))) {
    return true;
  }
  Eigen::Matrix<double, 2, 3> along;
  along.row(0) = alone.normal().unitOrthogonal().transpose();
  along.row(1) = alone.normal().cross(along.row(0).transpose()).transpose();
  const double exact = tolerances.angle_tolerance / tolerances.deviations;
  const Eigen::Matrix2d spread =
      along * own.normal * along.transpose() + exact * exact * Eigen::Matrix2d::Identity();
  const Eigen::Vector2d turn = along * now.normal();
  return turn.dot(spread.inverse() * turn) > tolerances.deviations * tolerances.deviations;
}

}  // namespace

PlaneRefinementSummary refine_unstrained(
    const std::vector<Eigen::Vector3d>& points, const std::vector<PlaneSupport>& supports,
    const std::vector<OrientedPlane>& alone, const std::vector<PointMoments>& moments,
    const RegularityOptions& tolerances, const PlaneRefinementOptions& options,
    std::vector<PlaneRegularity>* regularities, std::vector<OrientedPlane>* planes) {
  CHECK(check(tolerances).empty()) << check(tolerances);
  CHECK_EQ(alone.size(), planes->size());
  CHECK_EQ(moments.size(), planes->size());
  const std::vector<OrientedPlane> start = *planes;
  for (bool all_kinds = false;; all_kinds = true) {
    *planes = start;
    const auto summary = refine_planes(points, supports, *regularities, options, planes);
    std::vector<char> strained(planes->size(), 0);
    for (size_t i = 0; i < planes->size(); ++i) {
      strained[i] = is_strained(alone[i], (*planes)[i], moments[i], tolerances);
    }
    const size_t dropped = std::erase_if(*regularities, [&](const PlaneRegularity& r) {
      const bool between_directions =
          r.kind == RegularityKind::kOrthogonal || r.kind == RegularityKind::kEqualSlope;
      return (all_kinds || between_directions) && (strained[r.a] || (r.b >= 0 && strained[r.b]));
    });
    const bool any = std::find(strained.begin(), strained.end(), 1) != strained.end();
    if (dropped == 0 && (all_kinds || !any)) return summary;
  }
}

}  // namespace gable
