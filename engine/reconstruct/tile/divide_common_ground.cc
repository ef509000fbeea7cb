#include <gable/engine/io/models/build_model.h>
#include <gable/engine/ordered_pool.h>
#include <gable/engine/reconstruct/building/building_fit.h>
#include <gable/engine/reconstruct/building/model_defect.h>
#include <gable/engine/reconstruct/neighbours/divided_ground.h>
#include <gable/engine/reconstruct/tile/divide_common_ground.h>
#include <gable/engine/scales/outline/ring_simplification.h>
#include <gable/grammar/plan_outline.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <numeric>
#include <stop_token>
#include <utility>

namespace gable {
namespace {

// Plans that differ by less are left alone, square metres.
constexpr double kLeastChange = 0.5;

// Corners nearer than this to the walls are left out, metres.
constexpr double kStraight = 0.2;

// Share of its plan that a house may lose so that it is in one piece.
constexpr double kCrumbs = 0.1;

/// The one polygon that a plan is for the most part; without corners where there is no such.
PlanPolygon one_polygon(const PlanShape& plan) {
  const auto largest = std::max_element(
      plan.begin(), plan.end(),
      [](const PlanPolygon& a, const PlanPolygon& b) { return area_of({a}) < area_of({b}); });
  const double whole = area_of(plan);
  if (largest == plan.end() || whole - area_of({*largest}) > kCrumbs * whole) return {};
  std::vector<Ring> rings = largest->holes;
  rings.insert(rings.begin(), largest->outer);
  rings = simplified(rings, kStraight);
  if (rings.empty()) return {};
  return {rings.front(), {rings.begin() + 1, rings.end()}};
}

/// Gives a house walls, and takes them back where its solids are not valid.
void give_walls(PlanPolygon polygon, TileBuilding* made) {
  if (polygon.outer.empty()) return;
  Building building = made->building;
  building.walls = {std::move(polygon), 0.0};
  set_fit(fit_of_building(made->image, building), &building);
  BuildingModel model = build_model(building);
  if (!defect_of(model).empty()) return;
  made->building = std::move(building);
  made->model = std::move(model);
}

/// Numbers of the houses whose boxes touch directly or through others, group by group; houses that
/// touch none are in no group.
std::vector<std::vector<size_t>> touching(const std::vector<Eigen::AlignedBox2d>& boxes) {
  std::vector<size_t> order(boxes.size());
  std::iota(order.begin(), order.end(), size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](size_t a, size_t b) { return boxes[a].min().x() < boxes[b].min().x(); });
  std::vector<size_t> parent(boxes.size());
  std::iota(parent.begin(), parent.end(), size_t{0});
  const auto root = [&](size_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  for (size_t i = 0; i < order.size(); ++i) {
    for (size_t j = i + 1; j < order.size(); ++j) {
      if (boxes[order[j]].min().x() > boxes[order[i]].max().x()) break;
      if (!boxes[order[i]].intersects(boxes[order[j]])) continue;
      const size_t a = root(order[i]), b = root(order[j]);
      parent[std::max(a, b)] = std::min(a, b);
    }
  }
  std::map<size_t, std::vector<size_t>> members;
  for (size_t i = 0; i < boxes.size(); ++i) members[root(i)].push_back(i);
  std::vector<std::vector<size_t>> groups;
  for (auto& [first, group] : members) {
    if (group.size() > 1) groups.push_back(std::move(group));
  }
  return groups;
}

/// A house in the frame of others, `step` from its own.
PlanHouse in_frame(const TileBuilding& made, const Eigen::Vector2d& step) {
  PlanHouse house{moved(plan_outline(*made.building.house), step), made.cuts};
  for (PlanLine& cut : house.cuts) cut.offset += cut.normal.dot(step);
  return house;
}

/// The area of a polygon in a building's own pixels, square metres.
double own_area(const HeightImage& image, const PlanPolygon& polygon) {
  int count = 0;
  for (int row = 0; row < image.rows; ++row) {
    for (int col = 0; col < image.cols; ++col) {
      count +=
          image.inside[image.index(row, col)] && polygon_holds(polygon, image.center_of(row, col));
    }
  }
  return count * image.gsd * image.gsd;
}

/// The frame of a group is that of its first house.
void divide_ground_of(const std::vector<TileBuilding*>& group) {
  const auto step_to = [&](size_t i) -> Eigen::Vector2d {
    return (group[i]->image.origin - group.front()->image.origin).head<2>();
  };
  std::vector<PlanHouse> houses;
  for (size_t i = 0; i < group.size(); ++i) houses.push_back(in_frame(*group[i], step_to(i)));
  const std::vector<PlanShape> ground =
      divided_ground(houses, [&](size_t i, const PlanPolygon& polygon) {
        return own_area(group[i]->image, moved({polygon}, -step_to(i)).front());
      });
  for (size_t i = 0; i < group.size(); ++i) {
    if (area_of(houses[i].plan) - area_of(ground[i]) < kLeastChange) continue;
    give_walls(one_polygon(moved(ground[i], -step_to(i))), group[i]);
  }
}

}  // namespace

void divide_common_ground(int threads, std::vector<TileBuilding>* window) {
  std::vector<TileBuilding*> houses;
  std::vector<Eigen::AlignedBox2d> boxes;
  for (TileBuilding& made : *window) {
    if (!made.building.house || !made.building.walls.empty()) continue;
    Eigen::AlignedBox2d box;
    for (const PlanPolygon& polygon : plan_outline(*made.building.house)) {
      for (const Eigen::Vector2d& p : polygon.outer) box.extend(p + made.image.origin.head<2>());
    }
    houses.push_back(&made);
    boxes.push_back(box);
  }
  const std::vector<std::vector<size_t>> groups = touching(boxes);
  run_in_order<bool>(
      groups.size(), threads, {},
      [&](size_t g) {
        std::vector<TileBuilding*> group;
        for (const size_t i : groups[g]) group.push_back(houses[i]);
        divide_ground_of(group);
        return true;
      },
      [](bool) {});
}

}  // namespace gable
