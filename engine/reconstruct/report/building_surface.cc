#include <gable/engine/reconstruct/report/building_surface.h>

#include <vector>

namespace gable {
namespace {

const Eigen::Vector3d& origin_of(const Building& building) {
  return building.house ? building.house->origin : building.origin;
}

// Number of edges of a ring that a ray from the point towards +x crosses.
int crossings(const std::vector<Eigen::Vector2d>& ring, const Eigen::Vector2d& point) {
  int count = 0;
  for (size_t i = 0; i < ring.size(); ++i) {
    const Eigen::Vector2d& a = ring[i];
    const Eigen::Vector2d& b = ring[(i + 1) % ring.size()];
    if ((a.y() > point.y()) == (b.y() > point.y())) continue;
    const double x = a.x() + (point.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
    count += point.x() < x;
  }
  return count;
}

}  // namespace

bool contains(const PlanPolygon& polygon, const Eigen::Vector2d& point) {
  int count = crossings(polygon.outer, point);
  for (const auto& hole : polygon.holes) count += crossings(hole, point);
  return count % 2 == 1;
}

BuildingSurface::BuildingSurface(const Building& building, const Eigen::Vector3d& origin)
    : building_(building),
      offset_((origin_of(building) - origin).head<2>()),
      offset_z_(origin_of(building).z() - origin.z()) {
  if (building.house) field_.emplace(*building.house);
}

double BuildingSurface::height(const Eigen::Vector2d& point, double support, double ground) const {
  const Eigen::Vector2d local = point - offset_;
  if (field_) return field_->at_local(local, support, ground - offset_z_) + offset_z_;
  if (building_.roof) {
    const int region = region_at(*building_.roof, local);
    if (region < 0) return ground;
    return building_.roof->planes[building_.roof->regions[region].plane].at(local) + offset_z_;
  }
  return contains(building_.outline, local) ? building_.height + offset_z_ : ground;
}

SurfacePart BuildingSurface::part(const Eigen::Vector2d& point) const {
  const Eigen::Vector2d local = point - offset_;
  SurfacePart part;
  if (field_) {
    part.block = field_->block_at_house(field_->house_from_local(local));
    if (part.block >= 0) part.role = field_->sources()[part.block].role;
  } else if (building_.roof) {
    part.block = region_at(*building_.roof, local);
  } else if (contains(building_.outline, local)) {
    part.block = 0;
  }
  return part;
}

}  // namespace gable
