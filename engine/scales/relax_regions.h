#pragma once

#include <gable/engine/scales/local_planes.h>
#include <gable/residuals/point_moments.h>

#include <string>
#include <vector>

namespace gable {

/// How points are given to the regions around them.
struct RelaxOptions {
  double epsilon = 0.0;     ///< largest distance of a point to its region's plane, metres, >= 0
  double deviation = 0.0;   ///< standard deviation of the points' distances, metres, > 0
  double smoothness = 3.0;  ///< price of being alone among points of other regions, [0, 100]
  double tilt = 3.0;        ///< price of a normal at right angles to that of the plane, [0, 100]
  int sweeps = 4;           ///< [0, 100]
  int min_inliers = 1;      ///< smaller regions are given up in the end
  int threads = 1;
};

/// Lets points change between the regions they touch. Region growing gives a point to the region
/// that comes first and leaves out points with unsure normals, which are those at the edges of
/// surfaces; here every point that has neighbours in other regions, or that has none, chooses the
/// region of its neighbours with the lowest
///   distance^2 / (2 deviation^2) + tilt * (1 - |n . normal|)
///     + smoothness * (share of neighbours in other regions),
/// n the normal of the point's local plane, among those within epsilon, or none, which is priced as
/// a region at a distance of epsilon with n at 60 degrees to its normal. Near an edge the distances
/// to both planes say little, where noise is wide, but the surroundings lean to one of them. All
/// points choose at once, then the planes are fitted anew: iterated conditional modes of a Potts
/// model, for a number of sweeps. `region_of` (per point, -1: none) and the regions' `moments` are
/// changed; regions are numbered anew in their old order.
void relax_regions(const OrderedCloud& cloud, const Neighbours& neighbours,
                   const LocalPlanes& local_planes, const RelaxOptions& options,
                   std::vector<int>* region_of, std::vector<PointMoments>* moments);

}  // namespace gable
