#include <gable/engine/reconstruct/building_fit.h>
#include <gable/engine/reconstruct/known_walls.h>
#include <gable/engine/scales/outline/ring_simplification.h>
#include <gable/grammar/outline_margins.h>

#include <array>
#include <vector>

namespace gable {
namespace {

// How far corners that are left out may lie from the walls, metres. Outlines are drawn from
// pictures of 10 to 25 cm.
constexpr std::array<double, 3> kTolerances = {0.2, 0.5, 1.0};

// How much nearer to the heights a corner must bring a house on average, metres.
constexpr double kCornerPrice = 0.01;

KnownOutline simplified_outline(const PlanPolygon& outline, double tolerance) {
  std::vector<Ring> rings = outline.holes;
  rings.insert(rings.begin(), outline.outer);
  rings = simplified(rings, tolerance);
  KnownOutline walls;
  if (rings.empty()) return walls;
  walls.polygon = {rings.front(), {rings.begin() + 1, rings.end()}};
  return walls;
}

size_t corners(const PlanPolygon& polygon) {
  size_t count = polygon.outer.size();
  for (const auto& hole : polygon.holes) count += hole.size();
  return count;
}

}  // namespace

KnownOutline known_walls(const PlanPolygon& outline, const HeightImage& image,
                         const Building& house) {
  Building with = house;
  with.walls = {};
  const size_t rectangles = with.house->footprints.size() + with.house->garages.size();
  KnownOutline best;
  double least = fit_of_building(image, with).charge + kCornerPrice * 4.0 * rectangles;
  for (const double tolerance : kTolerances) {
    with.walls = simplified_outline(outline, tolerance);
    if (with.walls.empty()) continue;
    for (const double reach : kOutlineMargins) {
      with.walls.reach = reach;
      const double price = fit_of_building(image, with).charge +
                           kCornerPrice * (corners(with.walls.polygon) + 4.0 * (rectangles - 1.0));
      if (price >= least) continue;
      least = price;
      best = with.walls;
    }
  }
  return best;
}

}  // namespace gable
