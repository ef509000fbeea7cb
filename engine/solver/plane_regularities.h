#pragma once

#include <gable/residuals/oriented_plane.h>
#include <gable/residuals/point_moments.h>

#include <string>
#include <utility>
#include <vector>

namespace gable {

/// What two planes, or one plane and the vertical, have to do with each other.
enum class RegularityKind { kParallel, kOrthogonal, kCoplanar, kHorizontal, kVertical };

/// A regularity of plane `a` (horizontal, vertical) or of planes `a` and `b` (all others).
struct PlaneRegularity {
  RegularityKind kind = RegularityKind::kParallel;
  int a = 0;
  int b = -1;
  bool operator==(const PlaneRegularity&) const = default;
};

/// How close planes must be to a regularity to be taken for it.
struct RegularityOptions {
  double angle_tolerance = 0.0524;  ///< radians (3 degrees), (0, 0.5]
  double distance_tolerance = 0.1;  ///< metres between coplanar planes, (0, 10]
};

/// Empty if the options are in range; otherwise names the violated bound.
std::string check(const RegularityOptions& options);

/// The regularities that hold within the tolerances. `moments`: of each plane's points (their
/// centroids decide coplanarity). `pairs`: the pairs to look at, or empty for all of them.
///
/// Only a spanning set is returned, closest first: of planes that are all parallel just enough
/// pairs to connect them, one orthogonal pair between two such groups, and nothing that follows
/// from planes being horizontal or vertical (all horizontal planes are parallel, and orthogonal to
/// vertical ones). So the number is linear in the planes for one group of directions, and equations
/// are not counted twice. Deterministic.
/// This is the answer to the limitation of structural scales' plane fits (CVPR 2018, section 6).
std::vector<PlaneRegularity> detect_regularities(const std::vector<OrientedPlane>& planes,
                                                 const std::vector<PointMoments>& moments,
                                                 const std::vector<std::pair<int, int>>& pairs,
                                                 const RegularityOptions& options);

}  // namespace gable
