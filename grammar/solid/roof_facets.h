#pragma once

#include <gable/grammar/block.h>
#include <gable/grammar/solid/plan_graph.h>
#include <gable/grammar/solid/plane.h>

#include <Eigen/Core>
#include <vector>

namespace gable {

/// One plane of a roof and the convex part of the plan that it covers (anticlockwise).
struct RoofFacet {
  int plane = 0;  ///< number in a PlaneSet
  std::vector<Eigen::Vector2d> outline;
};

/// A block's rectangle under its roof, which is the minimum of its facets' planes.
struct FacetedBlock {
  Eigen::Vector2d low, high;
  std::vector<RoofFacet> facets;

  bool contains(const Eigen::Vector2d& p) const {
    return p.x() >= low.x() && p.x() < high.x() && p.y() >= low.y() && p.y() < high.y();
  }
  /// Number of the lowest plane at a point inside the rectangle.
  int plane_at(const Eigen::Vector2d& p, const std::vector<Plane>& planes) const;
};

/// Facets of a block's roof, its planes numbered by `planes`, over its rectangle enlarged by
/// `margin` metres on every side.
FacetedBlock facet_block(const Block<double>& block, PlaneSet* planes, double margin = 0.0);

/// Adds the lines in the plan where a facet of one block meets a facet of the other, cut to the
/// rectangle from `low` to `high`.
void append_meeting_lines(const FacetedBlock& block, const FacetedBlock& other,
                          const std::vector<Plane>& planes, const Eigen::Vector2d& low,
                          const Eigen::Vector2d& high, std::vector<PlanSegment>* segments);

/// Every line in the plan along which the upper envelope of `blocks` can change its plane: the
/// facets' outlines and the lines where two facets of different blocks meet, cut to the rectangle
/// from `low` to `high`.
std::vector<PlanSegment> envelope_segments(const std::vector<const FacetedBlock*>& blocks,
                                           const std::vector<Plane>& planes,
                                           const Eigen::Vector2d& low, const Eigen::Vector2d& high);

}  // namespace gable
