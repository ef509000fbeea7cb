#include <gable/engine/reconstruct/neighbours/divided_ground.h>
#include <gable/grammar/ring.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace gable {
namespace {

using Box = Eigen::AlignedBox2d;

// By how much the two sides of one cut may differ, metres: they come from frames far apart.
constexpr double kSameLine = 1e-6;

Box box_of(const PlanShape& shape) {
  Box box;
  for (const PlanPolygon& polygon : shape) {
    for (const Eigen::Vector2d& p : polygon.outer) box.extend(p);
  }
  return box;
}

/// The cut between two houses, the first on its negative side.
std::optional<PlanLine> cut_between(const PlanHouse& a, const PlanHouse& b) {
  for (const PlanLine& cut : a.cuts) {
    for (const PlanLine& other : b.cuts) {
      if ((cut.normal + other.normal).norm() < kSameLine &&
          std::abs(cut.offset + other.offset) < kSameLine) {
        return cut;
      }
    }
  }
  return std::nullopt;
}

/// The negative side of a line, as far as it lies in `box` and somewhat beyond.
PlanShape side_of(const PlanLine& line, const Box& box) {
  const double size = box.diagonal().norm() + 1.0;
  const Eigen::Vector2d center = box.center();
  const Eigen::Vector2d foot = center - line.signed_distance(center) * line.normal;
  // Far enough to hold the box wherever the line runs.
  const double depth = size + std::abs(line.signed_distance(center));
  const Eigen::Vector2d along = size * line.direction(), back = depth * line.normal;
  Ring ring = {foot - along, foot + along, foot + along - back, foot - along - back};
  if (signed_area(ring) < 0.0) std::reverse(ring.begin(), ring.end());
  return {{std::move(ring), {}}};
}

PlanLine turned(const PlanLine& line) {
  PlanLine out = line;
  out.normal = -line.normal;
  out.offset = -line.offset;
  return out;
}

}  // namespace

std::vector<PlanShape> divided_ground(
    const std::vector<PlanHouse>& houses,
    const std::function<double(size_t, const PlanPolygon&)>& claim) {
  std::vector<PlanShape> ground;
  std::vector<Box> boxes;
  for (const PlanHouse& house : houses) {
    ground.push_back(house.plan);
    boxes.push_back(box_of(house.plan));
  }
  for (size_t a = 0; a < houses.size(); ++a) {
    for (size_t b = a + 1; b < houses.size(); ++b) {
      if (!boxes[a].intersects(boxes[b])) continue;
      const PlanShape both = common_of(houses[a].plan, houses[b].plan);
      if (both.empty()) continue;
      if (const std::optional<PlanLine> cut = cut_between(houses[a], houses[b])) {
        const Box box = box_of(both);
        ground[a] = difference_of(ground[a], common_of(both, side_of(turned(*cut), box)));
        ground[b] = difference_of(ground[b], common_of(both, side_of(*cut, box)));
        continue;
      }
      for (const PlanPolygon& piece : both) {
        const size_t loser = claim(a, piece) >= claim(b, piece) ? b : a;
        ground[loser] = difference_of(ground[loser], {piece});
      }
    }
  }
  return ground;
}

}  // namespace gable
