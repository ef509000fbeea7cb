#pragma once

#include <gable/residuals/oriented_plane.h>
#include <gable/residuals/point_moments.h>

#include <string>
#include <utility>
#include <vector>

namespace gable {

/// What two planes, or one plane and the vertical, have to do with each other. Of equal slope:
/// inclined by the same angle, like the two sides of a gable or the four of a hip.
enum class RegularityKind {
  kParallel,
  kOrthogonal,
  kCoplanar,
  kHorizontal,
  kVertical,
  kEqualSlope
};

/// A regularity of plane `a` (horizontal, vertical) or of planes `a` and `b` (all others).
struct PlaneRegularity {
  RegularityKind kind = RegularityKind::kParallel;
  int a = 0;
  int b = -1;
  bool operator==(const PlaneRegularity&) const = default;
};

/// How close planes must be to a regularity to be taken for it: within a tolerance that even
/// planes known exactly are granted, widened by what their points leave open (PlaneUncertainty), so
/// that small noisy planes snap and precise ones that truly differ do not. And the miss must be
/// likelier than among planes that have nothing to do with each other, so that planes that could be
/// turned anywhere are taken for nothing.
struct RegularityOptions {
  double angle_tolerance = 0.0524;  ///< of exact planes, radians (3 degrees), (0, 0.5]
  double distance_tolerance = 0.1;  ///< between exact coplanar planes, metres, (0, 10]
  /// The size of a miss in standard deviations that is tolerated, with the tolerances above as as
  /// many deviations of their own, [1, 10]. Distances are taken up to the noise of the planes'
  /// points.
  double deviations = 3.0;
};

/// Empty if the options are in range; otherwise names the violated bound.
std::string check(const RegularityOptions& options);

/// The regularities that hold within the tolerances. `moments`: of each plane's points, a weight of
/// 1 for each independent measurement. `pairs`: the pairs to look at, or empty for all of them.
///
/// Only a spanning set is returned, closest first (by the most that a pair could miss it by): of
/// planes that are all parallel just enough pairs to connect them, one orthogonal pair between two
/// such groups, of equal slopes likewise, and nothing that follows from planes being horizontal or
/// vertical (all horizontal planes are parallel, and orthogonal to vertical ones). So the number is
/// linear in the planes for one group of directions, and equations are not counted twice. A group
/// is what its most certain plane is: groups unite only if these two agree, so that no uncertain
/// plane makes certain ones parallel that are not. Deterministic.
/// This is the answer to the limitation of structural scales' plane fits (CVPR 2018, section 6).
std::vector<PlaneRegularity> detect_regularities(const std::vector<OrientedPlane>& planes,
                                                 const std::vector<PointMoments>& moments,
                                                 const std::vector<std::pair<int, int>>& pairs,
                                                 const RegularityOptions& options);

}  // namespace gable
