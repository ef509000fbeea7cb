#include <gable/engine/evaluate/model_surface.h>
#include <gable/engine/io/models/building_plan.h>

#include <limits>

namespace gable {

ModelSurface rasterise_buildings(const std::vector<Building>& buildings, const Grid& grid) {
  ModelSurface surface;
  surface.height = HeightRaster(grid, std::numeric_limits<float>::quiet_NaN());
  surface.owner = Raster<int>(grid, -1);
  for (size_t i = 0; i < buildings.size(); ++i) {
    const Building& building = buildings[i];
    const double origin_z = origin_of(building).z();
    const auto raise = [&](int row, int col, double above_origin) {
      const float height = static_cast<float>(origin_z + above_origin);
      float& seen = surface.height.at(row, col);
      if (height <= seen) return;  // false where nothing is seen yet (NaN)
      seen = height;
      surface.owner.at(row, col) = static_cast<int>(i);
    };
    for_building_cells(building, grid, raise);
  }
  return surface;
}

}  // namespace gable
