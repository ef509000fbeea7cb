#pragma once

#include <gable/engine/solver/plane_refinement.h>

#include <vector>

namespace gable {

/// refine_planes with the regularities that the planes bear. Regularities are found pair by pair,
/// each within its tolerance, but several of them in a row may add up: no plane is turned or moved
/// further from its own points than their uncertainty and the tolerances allow. A plane that would
/// be loses its regularities, those to planes of other directions first, and all are refitted.
///
/// `alone`: what each plane's own points say, with their `moments` (outliers left out; a weight of
/// 1 is one measurement). `planes` are the start and the result, `regularities` shrink to those
/// that were kept, `tolerances` are those that they were found with. The summary is of the last
/// refit.
PlaneRefinementSummary refine_unstrained(
    const std::vector<Eigen::Vector3d>& points, const std::vector<PlaneSupport>& supports,
    const std::vector<OrientedPlane>& alone, const std::vector<PointMoments>& moments,
    const RegularityOptions& tolerances, const PlaneRefinementOptions& options,
    std::vector<PlaneRegularity>* regularities, std::vector<OrientedPlane>* planes);

}  // namespace gable
