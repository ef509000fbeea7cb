#pragma once

#include <gable/engine/scales/neighbours.h>
#include <gable/residuals/point_moments.h>

#include <string>
#include <vector>

namespace gable {

/// How points are given to the regions around them.
struct RelaxOptions {
  double epsilon = 0.0;     ///< largest distance of a point to its region's plane, metres, >= 0
  double deviation = 0.0;   ///< standard deviation of the points' distances, metres, > 0
  double smoothness = 3.0;  ///< price of being alone among points of other regions, [0, 100]
  int sweeps = 4;           ///< [0, 100]
  int min_inliers = 1;      ///< smaller regions are given up in the end
  int threads = 1;
};

/// Lets points change between the regions they touch. Region growing gives a point to the region
/// that comes first and leaves out points with unsure normals, which are those at the edges of
/// surfaces; here every point that has neighbours in other regions, or that has none, chooses the
/// region of its neighbours with the lowest
///   distance^2 / (2 deviation^2) + smoothness * (share of neighbours in other regions),
/// among those within epsilon, or none. All points choose at once, then the planes are fitted anew:
/// iterated conditional modes of a Potts model, for a number of sweeps.
/// `region_of` (per point, -1: none) and the regions' `moments` are changed; regions are numbered
/// anew in their old order.
void relax_regions(const OrderedCloud& cloud, const Neighbours& neighbours,
                   const RelaxOptions& options, std::vector<int>* region_of,
                   std::vector<PointMoments>* moments);

}  // namespace gable
