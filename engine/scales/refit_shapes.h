#pragma once

#include <gable/engine/scan.h>
#include <gable/engine/solver/plane_refinement.h>

#include <string>
#include <vector>

namespace gable {

/// How the planes of a configuration are refitted together. The defaults serve all inputs: every
/// length is measured in the shapes' own noise, the distance of coplanar planes among them.
struct RefitOptions {
  LossKind loss = LossKind::kGemanMcClure;
  double loss_scale = 4.0;             ///< of a distance in units of its shape's noise, (0, 100]
  double angle_tolerance = 0.0087;     ///< see RegularityOptions, radians (0.5 degrees), (0, 0.5]
  double deviations = 3.0;             ///< see RegularityOptions, [1, 10]
  double regularity_strength = 100.0;  ///< see PlaneRefinementOptions, [0, 1e4]
  bool regularities = true;            ///< false: each plane alone
};

/// Empty if the options are in range; otherwise names the violated bound.
std::string check(const RefitOptions& options);

/// The planes of a configuration before and after they were refitted.
struct PlaneRefit {
  std::vector<OrientedPlane> before;  ///< least squares through each shape's elements
  std::vector<OrientedPlane> after;
  std::vector<PlaneRegularity> regularities;
  /// Of the elements in shapes about their planes, metres; facets weigh by area. Least squares has
  /// the smallest there is, so that `after` is never below `before`.
  double rms_before = 0.0;
  double rms_after = 0.0;
  /// What is minimised (see PlaneRefinementSummary), at `before` and at `after`.
  double cost_before = 0.0;
  double cost_after = 0.0;
  int reweightings = 0;
  double time_ms = 0.0;
  Termination termination = Termination::kConverged;
};

/// Refits the planes of shapes together: each to its own elements under a robust loss whose scale
/// is the shape's own noise, with the regularities that hold between near ones within what the
/// noise leaves open. None turns a plane further from what its own points say than that:
/// regularities that would, since several add up, are dropped. This is the answer to a limitation
/// of structural scales (CVPR 2018, section 6).
///
/// shape_of: per element its shape, numbered from 0, or -1. Facets weigh by their area: they enter
/// by the mid-points of their triangles' edges, which give the moments of a triangle exactly. A
/// shape with fewer than three points, or with no area, keeps its plane. Deterministic.
PlaneRefit refit_shapes(const Scan& scan, const std::vector<int>& shape_of,
                        const RefitOptions& options);

}  // namespace gable
