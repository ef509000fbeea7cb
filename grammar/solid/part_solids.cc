#include <gable/grammar/solid/part_solids.h>
#include <gable/grammar/solid/plan_bodies.h>
#include <gable/grammar/solid/roof_facets.h>
#include <gable/grammar/solid/surface_mesh.h>
#include <gable/grammar/solid/validity.h>

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
int envelope_plane(const std::vector<FacetedBlock>& blocks, const Eigen::Vector2d& p,
                   const std::vector<Plane>& planes, int otherwise) {
  int best = otherwise;
  bool covered = false;
  for (const FacetedBlock& block : blocks) {
    if (!block.contains(p)) continue;
    const int plane = block.plane_at(p, planes);
    if (!covered || planes[plane].at(p) > planes[best].at(p)) best = plane;
    covered = true;
  }
  return best;
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

std::optional<std::vector<Solid>> solids_above(const std::vector<Block<double>>& own,
                                               const std::vector<Block<double>>& below,
                                               double base) {
  using namespace block_value;
  if (own.empty()) return std::vector<Solid>{};
  Eigen::Vector2d low(own[0][kX0], own[0][kY0]), high(own[0][kX1], own[0][kY1]);
  for (const Block<double>& block : own) {
    low = low.cwiseMin(Eigen::Vector2d(block[kX0], block[kY0]));
    high = high.cwiseMax(Eigen::Vector2d(block[kX1], block[kY1]));
  }
  PlaneSet plane_set(low, high);
  const int ground = plane_set.number_of({0.0, 0.0, base});
  std::vector<FacetedBlock> upper, lower;
  for (const Block<double>& block : own) upper.push_back(facet_block(block, &plane_set));
  for (const Block<double>& block : below) {
    const bool apart = block[kX0] >= high.x() || block[kX1] <= low.x() || block[kY0] >= high.y() ||
                       block[kY1] <= low.y();
    if (!apart) lower.push_back(facet_block(block, &plane_set));
  }
  std::vector<const FacetedBlock*> all;
  for (const FacetedBlock& block : upper) all.push_back(&block);
  for (const FacetedBlock& block : lower) all.push_back(&block);

  const std::vector<Plane>& planes = plane_set.planes();
  const auto label = [&](const Eigen::Vector2d& p) {
    CellLabel cell;
    const int top = envelope_plane(upper, p, planes, -1);
    if (top < 0) return cell;
    const int bottom = envelope_plane(lower, p, planes, ground);
    if (top == bottom || planes[top].at(p) <= planes[bottom].at(p)) return cell;
    cell.upper = top;
    cell.lower = bottom;
    return cell;
  };
  return solids_over_plan(envelope_segments(all, planes, low, high), label, planes, kLeastVolume);
}

}  // namespace gable
