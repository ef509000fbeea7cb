#pragma once

#include <gable/engine/solver/minimizer.h>
#include <gable/engine/solver/plane_regularities.h>
#include <gable/residuals/robust_loss.h>

#include <string>
#include <vector>

namespace gable {

/// The points that a plane is fitted to.
struct PlaneSupport {
  std::vector<int> members;     ///< which of the points, at least three
  std::vector<double> weights;  ///< of the members, >= 0, their sum > 0; none: all 1
  /// What a distance is measured in, metres, > 0. The standard deviation of the points' distances
  /// makes planes count by what they know where regularities tie them; 1 leaves metres.
  double noise = 1.0;
};

/// How planes are refitted to their points.
struct PlaneRefinementOptions {
  LossKind loss = LossKind::kSoftL1;
  double loss_scale = 0.05;  ///< of a point's distance in units of its plane's noise, (0, 100]
  /// How strongly a regularity holds: 1 makes breaking it cost as much as turning (or, coplanar,
  /// shifting) the less supported of its planes by the same amount away from its own points.
  double regularity_strength = 10.0;  ///< [0, 1e4]
  int max_reweightings = 20;          ///< [1, 1000]
  double cost_tolerance = 1e-6;       ///< relative change of the cost that ends it, [0, 1)
  int max_iterations = 20;            ///< of the solver per reweighting, [1, 1000]
};

/// Empty if the options are in range; otherwise names the violated bound.
std::string check(const PlaneRefinementOptions& options);

/// What a plane refinement did. Costs: half the sum of the points' losses (squares of the noise, so
/// square metres where that is 1) plus half the sum of squared regularity residuals.
struct PlaneRefinementSummary {
  double initial_cost = -1.0;
  double final_cost = -1.0;
  int reweightings = 0;
  int iterations = 0;  ///< of the solver, over all reweightings
  double time_ms = 0.0;
  Termination termination = Termination::kFailed;
  double rmse = 0.0;  ///< of all points' distances to their planes, metres, by their weights
};

/// Refits all planes together: each to its own points under a robust loss, with `regularities`
/// between them. points: all points, metres. `planes` (one per support) are the start and the
/// result.
///
/// The loss is applied by reweighting: a pass over the points weighs them by the loss's slope at
/// their current distance and sums them to moments, then the solver core sees four residuals a
/// plane (MomentsToPlane), however many points there are. Since the losses are concave in the
/// squared distance, every pass minimises an upper bound that touches the cost, so the cost never
/// rises and the fixed points are those of the robust problem. Points never enter the solver:
/// memory and time per iteration depend on the planes alone.
PlaneRefinementSummary refine_planes(const std::vector<Eigen::Vector3d>& points,
                                     const std::vector<PlaneSupport>& supports,
                                     const std::vector<PlaneRegularity>& regularities,
                                     const PlaneRefinementOptions& options,
                                     std::vector<OrientedPlane>* planes);

/// The same with members[i] as the points of plane i, all of weight 1, and distances in metres.
PlaneRefinementSummary refine_planes(const std::vector<Eigen::Vector3d>& points,
                                     const std::vector<std::vector<int>>& members,
                                     const std::vector<PlaneRegularity>& regularities,
                                     const PlaneRefinementOptions& options,
                                     std::vector<OrientedPlane>* planes);

}  // namespace gable
