#include <gable/grammar/height_field.h>

#include <cmath>

namespace gable {

HeightField::HeightField(const House& house)
    : sources_(block_sources(house)),
      blocks_(expand_blocks(house)),
      cos_(std::cos(house.azimuth[0])),
      sin_(std::sin(house.azimuth[0])) {}

Eigen::Vector2d HeightField::house_from_local(const Eigen::Vector2d& local) const {
  return {cos_ * local.x() + sin_ * local.y(), -sin_ * local.x() + cos_ * local.y()};
}

Eigen::Vector2d HeightField::local_from_house(const Eigen::Vector2d& point) const {
  return {cos_ * point.x() - sin_ * point.y(), sin_ * point.x() + cos_ * point.y()};
}

double HeightField::at_local(const Eigen::Vector2d& local, double support, double ground) const {
  return at_house(house_from_local(local), support, ground);
}

double HeightField::at_house(const Eigen::Vector2d& point, double support, double ground) const {
  return height_at<double, double>(blocks_, point.x(), point.y(), support, ground);
}

int HeightField::block_at_house(const Eigen::Vector2d& point) const {
  const Layers<double> seen = layers_at<double, double>(blocks_, point.x(), point.y(), 0.0);
  return seen.count > 0 ? seen.layers[0].block : -1;
}

}  // namespace gable
