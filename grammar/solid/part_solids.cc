#include <gable/grammar/outline_margins.h>
#include <gable/grammar/solid/part_solids.h>
#include <gable/grammar/solid/plan_bodies.h>
#include <gable/grammar/solid/roof_facets.h>
#include <gable/grammar/solid/surface_mesh.h>
#include <gable/grammar/solid/validity.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

namespace gable {
namespace {

constexpr double kLeastVolume = 0.005;

bool valid_when_rounded(const Solid& solid) {
  Solid rounded = solid;
  for (Eigen::Vector3d& p : rounded.vertices) {
    for (double& value : p) value = std::round(value * 1e4) * 1e-4;
  }
  return check_solid(rounded).valid();
}

Eigen::AlignedBox2d rectangle_of(const Block<double>& block) {
  using namespace block_value;
  return {Eigen::Vector2d(block[kX0], block[kY0]), Eigen::Vector2d(block[kX1], block[kY1])};
}

// A block with its facets over all that it may cover.
struct ReachingBlock {
  FacetedBlock facets;
  PartBlock part;

  bool covers(double margin, const Eigen::Vector2d& p) const {
    return reaches(part.block, part.on_ground ? margin : 0.0, p);
  }
};

std::vector<ReachingBlock> reaching(const std::vector<PartBlock>& blocks, double margin,
                                    PlaneSet* planes) {
  std::vector<ReachingBlock> out;
  for (const PartBlock& b : blocks) {
    out.push_back({facet_block(b.block, planes, b.on_ground ? margin : 0.0), b});
  }
  return out;
}

double box_volume(const SurfaceMesh& mesh) {
  if (mesh.vertices.empty()) return 0.0;
  Eigen::Vector3d low = mesh.vertices[0], high = low;
  for (const Eigen::Vector3d& p : mesh.vertices) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return (high - low).prod();
}

// The plane of the envelope of `blocks` at a point, or `otherwise`.
int envelope_plane(const std::vector<ReachingBlock>& blocks, double margin,
                   const Eigen::Vector2d& p, const std::vector<Plane>& planes, int otherwise) {
  int best = otherwise;
  bool covered = false;
  for (const ReachingBlock& block : blocks) {
    if (!block.covers(margin, p)) continue;
    const int plane = block.facets.plane_at(p, planes);
    if (!covered || planes[plane].at(p) > planes[best].at(p)) best = plane;
    covered = true;
  }
  return best;
}

// Where what covers the plan can change with an outline: the outline, and the blocks' rectangles
// with every margin.
void add_cover(const OutlineCover& cover, std::vector<PlanSegment>* segments) {
  using namespace block_value;
  append_ring(cover.outline.polygon.outer, segments);
  append_rings(cover.outline.polygon.holes, segments);
  for (const double m : kOutlineMargins) {
    if (m > cover.outline.reach) break;
    for (const Block<double>& b : cover.ground_blocks) {
      const double x0 = b[kX0] - m, x1 = b[kX1] + m, y0 = b[kY0] - m, y1 = b[kY1] + m;
      append_ring({{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, segments);
    }
  }
}

}  // namespace

std::optional<std::vector<Solid>> solids_over_plan(const std::vector<PlanSegment>& segments,
                                                   const LabelFunction& label,
                                                   const std::vector<Plane>& planes,
                                                   double least_volume) {
  const std::optional<PlanGraph> plan = divide_plan(segments, label, planes);
  if (!plan) return std::nullopt;
  std::vector<Solid> solids;
  for (const SurfaceMesh& mesh : raise_bodies(*plan, planes)) {
    // Slivers go before they are looked at: their rings may be too small to make sense.
    if (box_volume(mesh) < least_volume) continue;
    std::optional<Solid> solid = merge_pieces(mesh);
    if (!solid) return std::nullopt;
    const SolidValidity validity = check_solid(*solid);
    if (validity.bad_rings == 0 && std::abs(validity.volume) < least_volume) continue;
    if (!validity.valid() || !valid_when_rounded(*solid)) return std::nullopt;
    solids.push_back(std::move(*solid));
  }
  return solids;
}

std::optional<std::vector<Solid>> solids_above(const std::vector<PartBlock>& own,
                                               const std::vector<PartBlock>& below, double base,
                                               const OutlineCover* cover) {
  if (own.empty()) return std::vector<Solid>{};
  const double reach = cover ? cover->outline.reach : 0.0;
  const auto reach_of = [&](const PartBlock& b) { return b.on_ground ? reach : 0.0; };
  Eigen::AlignedBox2d region;
  for (const PartBlock& b : own) {
    const Eigen::AlignedBox2d box = rectangle_of(b.block);
    const Eigen::Vector2d margin = Eigen::Vector2d::Constant(reach_of(b));
    region.extend(Eigen::AlignedBox2d(box.min() - margin, box.max() + margin));
  }
  std::vector<PartBlock> near;
  for (const PartBlock& b : below) {
    const Eigen::AlignedBox2d box = rectangle_of(b.block);
    const bool apart = ((box.min().array() - reach_of(b)) >= region.max().array()).any() ||
                       ((box.max().array() + reach_of(b)) <= region.min().array()).any();
    if (!apart) near.push_back(b);
  }
  PlaneSet plane_set(region.min(), region.max());
  const int ground = plane_set.number_of({0.0, 0.0, base});
  const std::vector<ReachingBlock> upper = reaching(own, reach, &plane_set);
  const std::vector<ReachingBlock> lower = reaching(near, reach, &plane_set);
  std::vector<const FacetedBlock*> all;
  for (const ReachingBlock& block : upper) all.push_back(&block.facets);
  for (const ReachingBlock& block : lower) all.push_back(&block.facets);

  const std::vector<Plane>& planes = plane_set.planes();
  const auto label = [&](const Eigen::Vector2d& p) {
    CellLabel cell;
    double margin = 0.0;
    if (cover) {
      if (!polygon_holds(cover->outline.polygon, p)) return cell;
      margin = outline_margin_at(cover->ground_blocks, cover->outline.reach, p);
      if (margin < 0.0) return cell;
    }
    const int top = envelope_plane(upper, margin, p, planes, -1);
    if (top < 0) return cell;
    const int bottom = envelope_plane(lower, margin, p, planes, ground);
    if (top == bottom || planes[top].at(p) <= planes[bottom].at(p)) return cell;
    cell.upper = top;
    cell.lower = bottom;
    return cell;
  };
  std::vector<PlanSegment> segments;
  // Rectangles and outlines first: where points are merged, the earliest one stays.
  if (cover) add_cover(*cover, &segments);
  for (const PlanSegment& segment : envelope_segments(all, planes, region.min(), region.max())) {
    segments.push_back(segment);
  }
  return solids_over_plan(segments, label, planes, kLeastVolume);
}

}  // namespace gable
