#include <gable/grammar/solid/overhang.h>
#include <gable/grammar/solid/slab_plan.h>

#include <algorithm>

namespace gable {
namespace {

// Heights nearer than this are the same where slabs and bodies are compared, metres. No more than
// rounding: planes that differ little would be the same in a strip instead of along a line.
constexpr double kSame = 1e-12;
// How far inside a wall's face it is asked what stands there, metres.
constexpr double kInset = 1e-6;

Block<double> lowered(Block<double> block, double by) {
  block[block_value::kEaves] -= by;
  return block;
}

FacetedBlock level_region(const Eigen::Vector2d& low, const Eigen::Vector2d& high, int plane) {
  return {low, high, {{plane, {low, {high.x(), low.y()}, high, {low.x(), high.y()}}}}};
}

}  // namespace

SlabPlan::SlabPlan(const std::vector<SlabBlock>& blocks, double overhang, double thickness,
                   double base, const std::vector<PlanPolygon>& neighbours)
    : blocks_(blocks), thickness_(thickness), neighbours_(neighbours) {
  low_ = Eigen::Vector2d::Constant(1e300);
  high_ = -low_;
  for (const SlabBlock& b : blocks_) {
    using namespace block_value;
    const Block<double> reach = with_overhang(b.block, overhang);
    low_ = low_.cwiseMin(Eigen::Vector2d(reach[kX0], reach[kY0]));
    high_ = high_.cwiseMax(Eigen::Vector2d(reach[kX1], reach[kY1]));
  }
  PlaneSet planes(low_, high_);
  ground_ = planes.number_of({0.0, 0.0, base});
  for (const SlabBlock& b : blocks_) {
    Roof& roof = roofs_.emplace_back();
    const Block<double> below = lowered(b.block, b.has_slab ? thickness : 0.0);
    roof.body = facet_block(below, &planes);
    if (!b.has_slab) continue;
    roof.top = facet_block(with_overhang(b.block, overhang), &planes);
    roof.underside = facet_block(with_overhang(below, overhang), &planes);
  }
  planes_ = planes.planes();
  collect_segments();
}

SlabPlan::Candidate SlabPlan::slab_at(int block, const Eigen::Vector2d& p) const {
  Candidate slab;
  slab.block = block;
  slab.label.upper = roofs_[block].top.plane_at(p, planes_);
  slab.label.lower = roofs_[block].underside.plane_at(p, planes_);
  slab.height = height(slab.label.upper, p);
  return slab;
}

// Whether the roof of a block shows where its wall is nearest to a point.
bool SlabPlan::shows_at_wall(int block, const Eigen::Vector2d& p) const {
  const FacetedBlock& body = roofs_[block].body;
  if (body.contains(p)) return true;
  const Eigen::Vector2d inset = Eigen::Vector2d::Constant(kInset);
  const Eigen::Vector2d wall = p.cwiseMax(body.low + inset).cwiseMin(body.high - inset);
  return !enters_a_body(slab_at(block, wall), wall, Bodies::kOnGround);
}

bool SlabPlan::enters_a_body(const Candidate& slab, const Eigen::Vector2d& p, Bodies bodies) const {
  // Parts stand on one another, so what carries a block is the highest of the earlier parts.
  double carried = height(ground_, p), floor = carried;
  int part = -1;
  for (size_t b = 0; b < blocks_.size(); ++b) {
    if (blocks_[b].part != part) floor = carried;
    part = blocks_[b].part;
    const FacetedBlock& body = roofs_[b].body;
    if (!body.contains(p)) continue;
    if (bodies == Bodies::kOnGround && (blocks_[b].on_roof || !blocks_[b].has_slab)) continue;
    // As the slab on it has it: where hips were made to lean a little, the body follows.
    const FacetedBlock& top = blocks_[b].has_slab ? roofs_[b].underside : body;
    const double ceiling = height(top.plane_at(p, planes_), p);
    if (height(slab.label.lower, p) < ceiling - kSame && slab.height > floor + kSame &&
        ceiling > floor) {
      return true;
    }
    carried = std::max(carried, ceiling);
  }
  return false;
}

bool SlabPlan::is_next_door(const Eigen::Vector2d& p) const {
  for (const Roof& roof : roofs_) {
    if (roof.body.contains(p)) return false;
  }
  for (const PlanPolygon& neighbour : neighbours_) {
    if (polygon_holds(neighbour, p)) return true;
  }
  return false;
}

std::vector<SlabPlan::Candidate> SlabPlan::candidates(const Eigen::Vector2d& p,
                                                      bool on_roof) const {
  std::vector<Candidate> found;
  for (size_t b = 0; b < blocks_.size(); ++b) {
    if (!blocks_[b].has_slab || blocks_[b].on_roof != on_roof || !roofs_[b].top.contains(p)) {
      continue;
    }
    const Candidate slab = slab_at(static_cast<int>(b), p);
    const bool in_ground = height(slab.label.lower, p) <= height(ground_, p) + kSame;
    if (in_ground || enters_a_body(slab, p, Bodies::kAll)) continue;
    if (on_roof || shows_at_wall(slab.block, p)) found.push_back(slab);
  }
  std::stable_sort(found.begin(), found.end(), [](const Candidate& a, const Candidate& b) {
    return a.height > b.height + kSame;
  });
  std::vector<Candidate> apart;
  for (const Candidate& slab : found) {
    if (apart.empty() || slab.height <= apart.back().height - thickness_ + kSame) {
      apart.push_back(slab);
    }
  }
  return apart;
}

std::vector<SlabPiece> SlabPlan::at(const Eigen::Vector2d& p) const {
  std::vector<SlabPiece> pieces;
  if (is_next_door(p)) return pieces;
  const std::vector<Candidate> below = candidates(p, false);
  for (const Candidate& slab : below) pieces.push_back({slab.block, slab.label});
  for (Candidate& slab : candidates(p, true)) {
    bool stays = true;
    for (const Candidate& other : below) {
      if (other.height >= slab.height - kSame) {
        stays = stays && height(other.label.lower, p) >= slab.height - kSame;
      } else if (other.height > height(slab.label.lower, p)) {
        slab.label.lower = other.label.upper;
      }
    }
    if (stays) pieces.push_back({slab.block, slab.label});
  }
  return pieces;
}

void SlabPlan::collect_segments() {
  const FacetedBlock ground = level_region(low_, high_, ground_);
  std::vector<const FacetedBlock*> tops;
  for (const Roof& roof : roofs_) {
    if (!roof.top.facets.empty()) tops.push_back(&roof.top);
  }
  segments_ = envelope_segments(tops, planes_, low_, high_);
  for (size_t i = 0; i < roofs_.size(); ++i) {
    const FacetedBlock& body = roofs_[i].body;
    append_ring(level_region(body.low, body.high, 0).facets[0].outline, &segments_);
    if (!blocks_[i].has_slab) continue;
    append_meeting_lines(roofs_[i].underside, ground, planes_, low_, high_, &segments_);
    for (size_t j = 0; j < roofs_.size(); ++j) {
      if (j == i) continue;
      const FacetedBlock& other = blocks_[j].has_slab ? roofs_[j].top : roofs_[j].body;
      append_meeting_lines(roofs_[i].underside, other, planes_, low_, high_, &segments_);
    }
  }
  collect_ends_at_walls();
  for (const PlanPolygon& neighbour : neighbours_) {
    append_ring(neighbour.outer, &segments_);
    append_rings(neighbour.holes, &segments_);
  }
}

// An overhang ends square to the wall where the roof stops showing there: at the walls of other
// blocks, and where two roofs meet over the wall.
void SlabPlan::collect_ends_at_walls() {
  for (size_t i = 0; i < roofs_.size(); ++i) {
    if (!blocks_[i].has_slab || blocks_[i].on_roof) continue;
    const FacetedBlock& own = roofs_[i].top;
    const FacetedBlock& body = roofs_[i].body;
    std::vector<PlanSegment> lines;
    for (size_t j = 0; j < roofs_.size(); ++j) {
      if (j == i || !blocks_[j].has_slab || blocks_[j].on_roof) continue;
      append_meeting_lines(own, roofs_[j].top, planes_, low_, high_, &lines);
      append_ring(level_region(roofs_[j].body.low, roofs_[j].body.high, 0).facets[0].outline,
                  &lines);
    }
    for (int axis = 0; axis < 2; ++axis) {  // across the walls that run along the other axis
      for (const bool at_high : {false, true}) {
        const double wall = at_high ? body.high[axis] : body.low[axis];
        const double rim = at_high ? own.high[axis] : own.low[axis];
        const auto end_at = [&](double along) {
          PlanSegment end;
          end.from[axis] = wall;
          end.to[axis] = rim;
          end.from[1 - axis] = end.to[1 - axis] = along;
          segments_.push_back(end);
        };
        end_at(body.low[1 - axis]);
        end_at(body.high[1 - axis]);
        for (const PlanSegment& line : lines) {
          const double from = line.from[axis] - wall, to = line.to[axis] - wall;
          if (from * to > 0.0 || from == to) continue;
          const double along = line.from[1 - axis] +
                               (line.to[1 - axis] - line.from[1 - axis]) * (from / (from - to));
          if (along > body.low[1 - axis] && along < body.high[1 - axis]) end_at(along);
        }
      }
    }
  }
}

}  // namespace gable
