#pragma once

#include <gable/engine/scales/neighbours.h>
#include <gable/residuals/point_moments.h>

#include <vector>

namespace gable {

/// When a region's points are better explained by the regions around it.
struct DissolveOptions {
  double reach = 0.0;       ///< a point fits a plane within this distance, metres, > 0
  double deviation = 0.0;   ///< standard deviation of points that lie on a plane, metres, > 0
  double max_excess = 2.0;  ///< mean squared distance allowed, in squared deviations, > 0
  double min_share = 0.9;   ///< of the points that must fit, (0, 1]
  int threads = 1;          ///< the regions do not depend on it
};

/// Gives up regions, smallest first, whose points fit the planes of adjacent larger regions: the
/// strips that region growing leaves along edges, where normals blend, and the tails of noise
/// beyond epsilon on either side of a surface. Each point goes to the nearest plane, or to none if
/// it fits none. `region_of` (per point, -1: none) and `moments` are changed; a region that is
/// given up has no weight left.
void dissolve_regions(const OrderedCloud& cloud, const Neighbours& neighbours,
                      const DissolveOptions& options, std::vector<int>* region_of,
                      std::vector<PointMoments>* moments);

}  // namespace gable
