#include <gable/engine/io/models/building_plan.h>
#include <gable/grammar/outlined_house.h>
#include <gable/grammar/plan_outline.h>
#include <gable/grammar/polygon_cells.h>
#include <gable/grammar/rasterise.h>
#include <gable/grammar/roof_cells.h>

namespace gable {

const Eigen::Vector3d& origin_of(const Building& building) {
  return building.house ? building.house->origin : building.origin;
}

std::vector<PlanPolygon> plan_of(const Building& building) {
  if (!building.house) return {building.outline};
  if (!building.walls.empty()) return {building.walls.polygon};
  return plan_outline(*building.house);
}

void for_building_cells(const Building& building, const Grid& grid,
                        const std::function<void(int row, int col, double height)>& visit) {
  if (building.house && building.walls.empty()) {
    return for_covered_cells(*building.house, grid, visit);
  }
  const Eigen::Vector2d origin = origin_of(building).head<2>();
  if (building.roof) return for_cells_of_roof(*building.roof, origin, grid, visit);
  if (!building.house) {
    for_cells_in_polygon(building.outline, origin, grid,
                         [&](int row, int col) { visit(row, col, building.height); });
    return;
  }
  const OutlinedHouse house(*building.house, building.walls);
  for_cells_in_polygon(building.walls.polygon, origin, grid, [&](int row, int col) {
    if (const auto seen = house.at_local(grid.center_of(row, col) - origin)) {
      visit(row, col, seen->height);
    }
  });
}

}  // namespace gable
