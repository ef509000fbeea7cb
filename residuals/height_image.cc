#include <gable/residuals/height_image.h>

#include <cmath>

namespace gable {
namespace {

// What stands higher over the terrain is a building, metres.
constexpr float kLeastHeight = 2.0f;

}  // namespace

HeightImage height_image(const HeightRaster& dsm, const HeightRaster& dtm,
                         const Eigen::Vector3d& origin) {
  const Grid& grid = dsm.grid;
  HeightImage image;
  image.origin = origin;
  image.gsd = grid.gsd;
  image.rows = grid.rows;
  image.cols = grid.cols;
  image.first_center = grid.center_of(0, 0) - origin.head<2>();
  for (size_t i = 0; i < grid.size(); ++i) {
    const float surface = dsm.values[i], terrain = dtm.values[i];
    const bool known = std::isfinite(surface) && std::isfinite(terrain);
    image.height.push_back(known ? static_cast<float>(surface - origin.z()) : 0.0f);
    image.ground.push_back(known ? static_cast<float>(terrain - origin.z()) : 0.0f);
    image.weight.push_back(known ? 1.0f : 0.0f);
    image.inside.push_back(known && surface - terrain > kLeastHeight);
  }
  return image;
}

}  // namespace gable
