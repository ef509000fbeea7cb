#include <gable/engine/evaluate/model_surface.h>
#include <gable/grammar/polygon_cells.h>
#include <gable/grammar/rasterise.h>
#include <gable/grammar/roof_cells.h>

#include <limits>

namespace gable {

ModelSurface rasterise_buildings(const std::vector<Building>& buildings, const Grid& grid) {
  ModelSurface surface;
  surface.height = HeightRaster(grid, std::numeric_limits<float>::quiet_NaN());
  surface.owner = Raster<int>(grid, -1);
  for (size_t i = 0; i < buildings.size(); ++i) {
    const Building& building = buildings[i];
    const double origin_z = building.house ? building.house->origin.z() : building.origin.z();
    const auto raise = [&](int row, int col, double above_origin) {
      const float height = static_cast<float>(origin_z + above_origin);
      float& seen = surface.height.at(row, col);
      if (height <= seen) return;  // false where nothing is seen yet (NaN)
      seen = height;
      surface.owner.at(row, col) = static_cast<int>(i);
    };
    if (building.house) {
      for_covered_cells(*building.house, grid, raise);
    } else if (building.roof) {
      for_cells_of_roof(*building.roof, building.origin.head<2>(), grid, raise);
    } else {
      for_cells_in_polygon(building.outline, building.origin.head<2>(), grid,
                           [&](int row, int col) { raise(row, col, building.height); });
    }
  }
  return surface;
}

}  // namespace gable
