#include <gable/engine/reconstruct/building/snapped_outline.h>
#include <gable/engine/scales/outline/ring_simplification.h>
#include <gable/grammar/height_field.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace gable {
namespace {

// Corners nearer than this to the line through their neighbours are on it, metres.
constexpr double kStraight = 1e-3;

// A wall: where it stands along one axis, and from where to where it runs along the other.
struct Wall {
  double at, from, to;
};

// Walls across the x axis and across the y axis, house frame.
std::pair<std::vector<Wall>, std::vector<Wall>> walls_of(const HeightField& field) {
  using namespace block_value;
  std::pair<std::vector<Wall>, std::vector<Wall>> walls;
  for (size_t b = 0; b < field.blocks().size(); ++b) {
    if (stands_on_roof(field.sources()[b].role)) continue;
    const Block<double>& block = field.blocks()[b];
    for (const int edge : {kX0, kX1}) walls.first.push_back({block[edge], block[kY0], block[kY1]});
    for (const int edge : {kY0, kY1}) walls.second.push_back({block[edge], block[kX0], block[kX1]});
  }
  return walls;
}

double snapped(double value, double along, const std::vector<Wall>& walls, double tolerance) {
  double nearest = value, least = tolerance;
  for (const Wall& wall : walls) {
    const double distance = std::abs(wall.at - value);
    if (distance >= least || along < wall.from - tolerance || along > wall.to + tolerance) continue;
    least = distance;
    nearest = wall.at;
  }
  return nearest;
}

}  // namespace

PlanPolygon snapped_to_blocks(const PlanPolygon& outline, const House& house, double tolerance) {
  const HeightField field(house);
  const auto [across_x, across_y] = walls_of(field);
  std::vector<Ring> rings = outline.holes;
  rings.insert(rings.begin(), outline.outer);
  for (Ring& ring : rings) {
    for (Eigen::Vector2d& corner : ring) {
      const Eigen::Vector2d p = field.house_from_local(corner);
      corner = field.local_from_house(Eigen::Vector2d(snapped(p.x(), p.y(), across_x, tolerance),
                                                      snapped(p.y(), p.x(), across_y, tolerance)));
    }
    const auto same = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
      return (a - b).norm() < kStraight;
    };
    ring.erase(std::unique(ring.begin(), ring.end(), same), ring.end());
    while (ring.size() > 1 && same(ring.front(), ring.back())) ring.pop_back();
  }
  if (!are_simple(rings)) return outline;
  rings = simplified(rings, kStraight);
  if (rings.size() != outline.holes.size() + 1) return outline;
  return {rings.front(), {rings.begin() + 1, rings.end()}};
}

}  // namespace gable
