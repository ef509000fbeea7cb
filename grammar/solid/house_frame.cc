#include <gable/grammar/solid/house_frame.h>

#include <Eigen/Geometry>

namespace gable {

PlanPolygon house_from_local(PlanPolygon polygon, double azimuth) {
  const Eigen::Rotation2Dd house_from_local(-azimuth);
  for (Eigen::Vector2d& p : polygon.outer) p = house_from_local * p;
  for (auto& hole : polygon.holes) {
    for (Eigen::Vector2d& p : hole) p = house_from_local * p;
  }
  return polygon;
}

void turn_to_local(double azimuth, Solid* solid) {
  const Eigen::Rotation2Dd local_from_house(azimuth);
  for (Eigen::Vector3d& p : solid->vertices) p.head<2>() = local_from_house * p.head<2>();
}

}  // namespace gable
