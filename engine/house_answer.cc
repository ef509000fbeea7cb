#include <gable/engine/house_answer.h>

#include <Eigen/Geometry>

namespace gable {

Eigen::Vector2d CropFrame::world_from_crop(const Eigen::Vector2d& crop) const {
  return north_west +
         Eigen::Rotation2Dd(azimuth) * Eigen::Vector2d(pixel * crop.x(), -pixel * crop.y());
}

Eigen::Vector2d CropFrame::crop_from_world(const Eigen::Vector2d& world) const {
  const Eigen::Vector2d house = Eigen::Rotation2Dd(-azimuth) * (world - north_west);
  return Eigen::Vector2d(house.x(), -house.y()) / pixel;
}

}  // namespace gable
