#pragma once

#include <gable/engine/io/models/building.h>
#include <gable/grammar/raster.h>
#include <gable/grammar/solid/extrusion.h>

#include <Eigen/Core>
#include <functional>
#include <vector>

namespace gable {

/// The world point that a building's outline and heights are relative to.
const Eigen::Vector3d& origin_of(const Building& building);

/// The plan of a building relative to its origin, metres: its outline where one is known, otherwise
/// that of its house.
std::vector<PlanPolygon> plan_of(const Building& building);

/// Calls visit(row, col, height) for every cell of a world grid whose centre the building covers:
/// point samples of its upper surface, metres above its origin, row by row.
void for_building_cells(const Building& building, const Grid& grid,
                        const std::function<void(int row, int col, double height)>& visit);

}  // namespace gable
