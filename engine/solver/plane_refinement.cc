#include <gable/engine/solver/plane_refinement.h>
#include <gable/engine/stopwatch.h>
#include <gable/residuals/moments_to_plane.h>
#include <gable/residuals/plane_relations.h>
#include <gable/residuals/robust_loss.h>
#include <glog/logging.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace gable {
namespace {

// How much the points of each plane resist: turning costs (turn * angle)^2, shifting
// (shift * metres)^2.
struct Stiffness {
  double turn = 0.0;
  double shift = 0.0;
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
};

struct WeightedPoints {
  std::vector<PointMoments> moments;  ///< per plane, weighted by the loss's slope
  double cost = 0.0;                  ///< half the sum of the losses
  double squares = 0.0;               ///< weighted sum of squared distances
  double weight = 0.0;
};

// One pass over the points; offsets of planes are relative to their centroids (see refine_planes).
WeightedPoints weigh(const std::vector<Eigen::Vector3d>& points,
                     const std::vector<PlaneSupport>& supports,
                     const std::vector<Stiffness>& stiffnesses, const RobustLoss& loss,
                     const std::vector<OrientedPlane>& planes) {
  WeightedPoints out;
  for (size_t i = 0; i < planes.size(); ++i) {
    const PlaneSupport& support = supports[i];
    const double inverse = 1.0 / support.noise;
    PointMoments moments;
    for (size_t k = 0; k < support.members.size(); ++k) {
      const Eigen::Vector3d p = points[support.members[k]] - stiffnesses[i].centroid;
      const double weight = support.weights.empty() ? 1.0 : support.weights[k];
      const double distance = planes[i].signed_distance(p);
      const double r = distance * inverse;
      out.cost += 0.5 * weight * loss.cost(r);
      out.squares += weight * distance * distance;
      out.weight += weight;
      moments.add(p, weight * loss.slope(r) * inverse * inverse);
    }
    out.moments.push_back(moments);
  }
  return out;
}

Stiffness stiffness(const std::vector<Eigen::Vector3d>& points, const PlaneSupport& support) {
  CHECK_GE(support.members.size(), 3u) << "a plane needs three points";
  CHECK(support.weights.empty() || support.weights.size() == support.members.size());
  CHECK_GT(support.noise, 0.0);
  PointMoments moments;
  moments.reference = points[support.members.front()];
  for (size_t k = 0; k < support.members.size(); ++k) {
    moments.add(points[support.members[k]], support.weights.empty() ? 1.0 : support.weights[k]);
  }
  CHECK_GT(moments.weight, 0.0) << "a plane needs points that weigh something";
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(moments.scatter(),
                                                             Eigen::EigenvaluesOnly);
  return {std::sqrt(std::max(0.0, eigen.eigenvalues()[2])) / support.noise,
          std::sqrt(moments.weight) / support.noise, moments.centroid()};
}

void add_regularity(const PlaneRegularity& regularity, const std::vector<Stiffness>& stiffnesses,
                    double strength, std::vector<OrientedPlane>* planes, ceres::Problem* problem,
                    std::vector<ceres::ResidualBlockId>* ids) {
  const Stiffness& a = stiffnesses[regularity.a];
  double* values_a = (*planes)[regularity.a].values.data();
  if (regularity.kind == RegularityKind::kHorizontal ||
      regularity.kind == RegularityKind::kVertical) {
    const double weight = strength * a.turn;
    ceres::CostFunction* cost = regularity.kind == RegularityKind::kHorizontal
                                    ? HorizontalPlane::create(weight)
                                    : VerticalPlane::create(weight);
    ids->push_back(problem->AddResidualBlock(cost, nullptr, values_a));
    return;
  }
  const Stiffness& b = stiffnesses[regularity.b];
  double* values_b = (*planes)[regularity.b].values.data();
  const double turn = strength * std::min(a.turn, b.turn);
  ceres::CostFunction* cost = nullptr;
  if (regularity.kind == RegularityKind::kParallel) {
    cost = ParallelPlanes::create(turn);
  } else if (regularity.kind == RegularityKind::kOrthogonal) {
    cost = OrthogonalPlanes::create(turn);
  } else if (regularity.kind == RegularityKind::kEqualSlope) {
    cost = EquallySteepPlanes::create(turn);
  } else {
    // Each centroid in the frame of the other plane.
    cost = CoplanarPlanes::create(a.centroid - b.centroid, b.centroid - a.centroid, turn,
                                  strength * std::min(a.shift, b.shift));
  }
  ids->push_back(problem->AddResidualBlock(cost, nullptr, values_a, values_b));
}

}  // namespace

std::string check(const PlaneRefinementOptions& options) {
  if (!(options.loss_scale > 0.0 && options.loss_scale <= 100.0)) {
    return "loss_scale must lie in (0, 100]";
  }
  if (!(options.regularity_strength >= 0.0 && options.regularity_strength <= 1e4)) {
    return "regularity_strength must lie in [0, 1e4]";
  }
  if (options.max_reweightings < 1 || options.max_reweightings > 1000) {
    return "max_reweightings must lie in [1, 1000]";
  }
  if (!(options.cost_tolerance >= 0.0 && options.cost_tolerance < 1.0)) {
    return "cost_tolerance must lie in [0, 1)";
  }
  if (options.max_iterations < 1 || options.max_iterations > 1000) {
    return "max_iterations must lie in [1, 1000]";
  }
  return "";
}

PlaneRefinementSummary refine_planes(const std::vector<Eigen::Vector3d>& points,
                                     const std::vector<PlaneSupport>& supports,
                                     const std::vector<PlaneRegularity>& regularities,
                                     const PlaneRefinementOptions& options,
                                     std::vector<OrientedPlane>* planes) {
  CHECK(check(options).empty()) << check(options);
  CHECK_EQ(supports.size(), planes->size());
  const Stopwatch watch;

  // Regularities weigh against the unweighted points, so that reweighting leaves them alone.
  std::vector<Stiffness> stiffnesses;
  for (const PlaneSupport& support : supports) stiffnesses.push_back(stiffness(points, support));

  // While they are solved for, offsets are relative to the planes' centroids: turning a plane then
  // leaves its offset alone, however far away the frame's origin is.
  for (size_t i = 0; i < planes->size(); ++i) {
    OrientedPlane& plane = (*planes)[i];
    plane = {plane.normal(), -plane.signed_distance(stiffnesses[i].centroid)};
  }

  PlaneRefinementSummary summary;
  const RobustLoss loss(options.loss, options.loss_scale);
  WeightedPoints weighted = weigh(points, supports, stiffnesses, loss, *planes);
  summary.termination = Termination::kIterationLimit;
  for (int pass = 0; pass < options.max_reweightings; ++pass) {
    ceres::Problem problem;
    std::vector<ceres::ResidualBlockId> relations;
    for (size_t i = 0; i < planes->size(); ++i) {
      double* values = (*planes)[i].values.data();
      problem.AddParameterBlock(values, kPlaneSize, make_plane_manifold());
      problem.AddResidualBlock(new MomentsToPlane(weighted.moments[i]), nullptr, values);
    }
    for (const PlaneRegularity& regularity : regularities) {
      add_regularity(regularity, stiffnesses, options.regularity_strength, planes, &problem,
                     &relations);
    }
    const auto relation_cost = [&] {
      double cost = 0.0;
      if (relations.empty()) return cost;
      ceres::Problem::EvaluateOptions evaluate;
      evaluate.residual_blocks = relations;
      problem.Evaluate(evaluate, &cost, nullptr, nullptr, nullptr);
      return cost;
    };
    const double before = weighted.cost + relation_cost();
    if (pass == 0) summary.initial_cost = before;

    MinimizerOptions minimizer;
    minimizer.sparse = true;
    minimizer.max_iterations = options.max_iterations;
    minimizer.function_tolerance = 1e-9;
    const MinimizerSummary solved = minimize(minimizer, &problem);
    summary.iterations += solved.iterations;
    ++summary.reweightings;
    weighted = weigh(points, supports, stiffnesses, loss, *planes);
    summary.final_cost = weighted.cost + relation_cost();
    if (solved.termination == Termination::kFailed) {
      summary.termination = Termination::kFailed;
      break;
    }
    if (before - summary.final_cost <= options.cost_tolerance * before) {
      summary.termination = Termination::kConverged;
      break;
    }
  }
  for (size_t i = 0; i < planes->size(); ++i) {
    OrientedPlane& plane = (*planes)[i];
    plane = {plane.normal(), plane.offset() + plane.normal().dot(stiffnesses[i].centroid)};
  }
  if (weighted.weight > 0.0) summary.rmse = std::sqrt(weighted.squares / weighted.weight);
  summary.time_ms = watch.ms();
  return summary;
}

PlaneRefinementSummary refine_planes(const std::vector<Eigen::Vector3d>& points,
                                     const std::vector<std::vector<int>>& members,
                                     const std::vector<PlaneRegularity>& regularities,
                                     const PlaneRefinementOptions& options,
                                     std::vector<OrientedPlane>* planes) {
  std::vector<PlaneSupport> supports;
  for (const std::vector<int>& m : members) supports.push_back({m, {}, 1.0});
  return refine_planes(points, supports, regularities, options, planes);
}

}  // namespace gable
