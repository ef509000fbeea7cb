#include <gable/engine/evaluate/triangles.h>
#include <gable/engine/io/models/build_model.h>
#include <gable/engine/reconstruct/building/building_fit.h>
#include <gable/engine/reconstruct/building/known_walls.h>
#include <gable/engine/reconstruct/building/model_defect.h>
#include <gable/engine/reconstruct/building/snapped_outline.h>
#include <gable/engine/scales/outline/ring_simplification.h>
#include <gable/grammar/outline_margins.h>

#include <array>
#include <limits>
#include <tuple>
#include <vector>

namespace gable {
namespace {

// How far corners that are left out may lie from the walls, metres. Outlines are drawn from
// pictures of 10 to 25 cm.
constexpr std::array<double, 3> kTolerances = {0.2, 0.5, 1.0};

// How far corners may move onto the walls of blocks, metres: no farther than an outline without
// its smallest corners may be off.
constexpr double kSnap = kTolerances.front();

// How much nearer to the heights a triangle must bring a house on average, metres: a quarter of
// what a corner of the plan must, which takes two of a wall, one of the roof and one of the ground.
constexpr double kTrianglePrice = 0.0025;

KnownOutline simplified_outline(const PlanPolygon& outline, double tolerance) {
  std::vector<Ring> rings = outline.holes;
  rings.insert(rings.begin(), outline.outer);
  rings = simplified(rings, tolerance);
  KnownOutline walls;
  if (rings.empty()) return walls;
  walls.polygon = {rings.front(), {rings.begin() + 1, rings.end()}};
  return walls;
}

size_t num_corners(const PlanPolygon& polygon) {
  size_t count = polygon.outer.size();
  for (const Ring& hole : polygon.holes) count += hole.size();
  return count;
}

// What walls cost: their house's distance from the heights, what it takes of its neighbours' ground
// (eaves may reach over open ground, but not over theirs) and the price of its solids. These count
// once the distance is no more than it may be.
struct Cost {
  bool too_far = true;
  double total = std::numeric_limits<double>::infinity();

  bool operator<(const Cost& other) const {
    return std::tie(too_far, total) < std::tie(other.too_far, other.total);
  }
};

// What walls cost, or an infinite cost where that is no less than `least` or without valid solids.
Cost cost_below(const Cost& least, const HeightImage& image, Building building, double farthest) {
  const BuildingFit fit = fit_of_building(image, building);
  Cost cost{fit.charge > farthest, fit.charge + fit.intrusion};
  if (!(cost < least)) return {};
  building.base = fit.base;
  constexpr std::array<Lod, 1> kFinest = {kHouseLods.back()};
  const BuildingModel model = build_model(building, kFinest);
  if (!defect_of(model).empty()) return {};
  int triangles = 0;
  for (const PartModel& part : model.parts) triangles += count_triangles(finest_solid(part));
  cost.total += kTrianglePrice * triangles;
  return cost;
}

}  // namespace

KnownOutline known_walls(const PlanPolygon& outline, const HeightImage& image,
                         const Building& house, double farthest) {
  Building with = house;
  with.walls = {};
  KnownOutline best;
  Cost least = cost_below({}, image, with, farthest);
  size_t corners = 0;
  for (const double tolerance : kTolerances) {
    with.walls = simplified_outline(outline, tolerance);
    // As many corners as with a smaller tolerance: the same ones.
    if (with.walls.empty() || num_corners(with.walls.polygon) == corners) continue;
    corners = num_corners(with.walls.polygon);
    const PlanPolygon simple = with.walls.polygon;
    for (const PlanPolygon& polygon : {snapped_to_blocks(simple, *house.house, kSnap), simple}) {
      for (const double reach : kOutlineMargins) {
        with.walls = {polygon, reach};
        const Cost cost = cost_below(least, image, with, farthest);
        if (!(cost < least)) continue;
        least = cost;
        best = with.walls;
      }
    }
  }
  return best;
}

}  // namespace gable
