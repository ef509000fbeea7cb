#pragma once

#include <gable/engine/scales/detect_scales.h>

#include <Eigen/Core>
#include <vector>

namespace gable {

/// The configuration of a cloud's trajectory that describes its points with the least, when a
/// distance of `deviation` metres from a plane counts as one standard deviation:
///
///   sum over points of min(d^2 / deviation^2, 9) + 3 n ln N
///
/// d the distance of a point from the least-squares plane of its shape (points without a shape do
/// not count), n the number of shapes and N of points: twice the negative log-likelihood and the
/// Bayesian information criterion's price of planes. Of equals the coarsest. A wider deviation asks
/// for a coarser scale. `points`: those that were collapsed. 0 where there are no shapes.
int cheapest_configuration(const std::vector<Eigen::Vector3d>& points,
                           const CollapsedScan& collapsed, double deviation);

}  // namespace gable
