#include <gable/engine/io/models/building_plan.h>
#include <gable/engine/reconstruct/report/building_surface.h>

namespace gable {
namespace {

// A mean over a support is taken over so many points along its sides.
constexpr int kParts = 4;

}  // namespace

BuildingSurface::BuildingSurface(const Building& building, const Eigen::Vector3d& origin)
    : building_(building),
      offset_((origin_of(building) - origin).head<2>()),
      offset_z_(origin_of(building).z() - origin.z()) {
  if (building.house) house_.emplace(*building.house, building.walls);
}

double BuildingSurface::height(const Eigen::Vector2d& point, double support, double ground) const {
  const Eigen::Vector2d local = point - offset_;
  if (house_ && !house_->has_outline()) {
    return house_->field().at_local(local, support, ground - offset_z_) + offset_z_;
  }
  double sum = 0.0;
  for (int row = 0; row < kParts; ++row) {
    for (int col = 0; col < kParts; ++col) {
      const Eigen::Vector2d part((col + 0.5) / kParts - 0.5, (row + 0.5) / kParts - 0.5);
      sum += height_at(local + support * part, ground);
    }
  }
  return sum / (kParts * kParts);
}

double BuildingSurface::height_at(const Eigen::Vector2d& local, double ground) const {
  if (house_) {
    const auto seen = house_->at_local(local);
    return seen ? seen->height + offset_z_ : ground;
  }
  if (building_.roof) {
    const int region = region_at(*building_.roof, local);
    if (region < 0) return ground;
    return building_.roof->planes[building_.roof->regions[region].plane].at(local) + offset_z_;
  }
  return polygon_holds(building_.outline, local) ? building_.height + offset_z_ : ground;
}

SurfacePart BuildingSurface::part(const Eigen::Vector2d& point) const {
  const Eigen::Vector2d local = point - offset_;
  SurfacePart part;
  if (house_) {
    const auto seen = house_->at_local(local);
    if (seen) part = {seen->block, house_->field().sources()[seen->block].role};
  } else if (building_.roof) {
    part.block = region_at(*building_.roof, local);
  } else if (polygon_holds(building_.outline, local)) {
    part.block = 0;
  }
  return part;
}

}  // namespace gable
