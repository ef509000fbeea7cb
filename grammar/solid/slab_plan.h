#pragma once

#include <gable/grammar/block.h>
#include <gable/grammar/solid/extrusion.h>
#include <gable/grammar/solid/plan_graph.h>
#include <gable/grammar/solid/plane.h>
#include <gable/grammar/solid/roof_facets.h>

#include <Eigen/Core>
#include <vector>

namespace gable {

/// A block under, or in the way of, roof slabs.
struct SlabBlock {
  Block<double> block;   ///< its roof is the upper face of its slab
  int part = 0;          ///< parts stand on one another in this order
  bool on_roof = false;  ///< a dormer: its slab ends on the slab of the roof below
  bool has_slab = true;  ///< false: a chimney, which slabs are cut out around
};

/// A slab over a point of the plan.
struct SlabPiece {
  int block = 0;  ///< whose roof it is
  CellLabel label;
};

/// Which roof slabs lie over a point of the plan (house frame). A block's slab lies between its
/// roof, continued beyond the walls by the overhang, and the same `thickness` lower; the block's
/// body ends under it. Slabs end
///  - where they would enter the body of another block, so at the wall of a higher wing, around
///    chimneys and dormers, and at the ground;
///  - where another slab lies less than the thickness above: of two roofs that meet in a valley,
///    each ends there. A dormer's slab lies on the slab below instead.
///  - beyond walls over which the roof does not show, another wing's being higher there;
///  - inside `neighbours` (even-odd, house frame), unless over the house's own blocks.
class SlabPlan {
 public:
  SlabPlan(const std::vector<SlabBlock>& blocks, double overhang, double thickness, double base,
           const std::vector<PlanPolygon>& neighbours);

  /// The slabs over a point, which do not overlap.
  std::vector<SlabPiece> at(const Eigen::Vector2d& p) const;

  /// Every line along which `at` can change.
  const std::vector<PlanSegment>& segments() const { return segments_; }
  const std::vector<Plane>& planes() const { return planes_; }

 private:
  // A block's roof and the underside of its slab, both with overhang, and what its walls carry.
  struct Roof {
    FacetedBlock top, underside, body;
  };
  // A slab over a point before it is compared with others.
  struct Candidate {
    int block;
    double height;
    CellLabel label;
  };

  double height(int plane, const Eigen::Vector2d& p) const { return planes_[plane].at(p); }
  enum class Bodies { kAll, kOnGround };
  bool enters_a_body(const Candidate& slab, const Eigen::Vector2d& p, Bodies bodies) const;
  Candidate slab_at(int block, const Eigen::Vector2d& p) const;
  bool shows_at_wall(int block, const Eigen::Vector2d& p) const;
  bool is_next_door(const Eigen::Vector2d& p) const;
  std::vector<Candidate> candidates(const Eigen::Vector2d& p, bool on_roof) const;
  void collect_segments();
  void collect_ends_at_walls();

  std::vector<SlabBlock> blocks_;
  double thickness_;
  int ground_ = 0;
  std::vector<PlanPolygon> neighbours_;
  std::vector<Plane> planes_;
  std::vector<Roof> roofs_;
  Eigen::Vector2d low_, high_;
  std::vector<PlanSegment> segments_;
};

}  // namespace gable
