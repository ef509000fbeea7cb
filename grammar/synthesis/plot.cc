#include <gable/grammar/synthesis/plot.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gable {
namespace {

double distance_to(const Rectangle& r, const Eigen::Vector2d& p) {
  return distance(r, Rectangle{p.x(), p.x(), p.y(), p.y()});
}

/// Whether a rectangle's own axes separate it from a polygon given in its frame.
bool separated(const Rectangle& r, const std::vector<Eigen::Vector2d>& polygon) {
  double x0 = polygon[0].x(), x1 = x0, y0 = polygon[0].y(), y1 = y0;
  for (const Eigen::Vector2d& p : polygon) {
    x0 = std::min(x0, p.x());
    x1 = std::max(x1, p.x());
    y0 = std::min(y0, p.y());
    y1 = std::max(y1, p.y());
  }
  return x1 <= r.x0 || x0 >= r.x1 || y1 <= r.y0 || y0 >= r.y1;
}

}  // namespace

Plot::Plot(const House& house) : house_(house), field_(house), center_(house.origin.head<2>()) {
  for (size_t i = 0; i < field_.blocks().size(); ++i) {
    if (stands_on_roof(field_.sources()[i].role)) continue;
    const Rectangle r = rectangle_of(field_.blocks()[i]);
    rectangles_.push_back(r);
    radius_ = std::max(radius_, std::hypot(std::max(std::abs(r.x0), std::abs(r.x1)),
                                           std::max(std::abs(r.y0), std::abs(r.y1))));
  }
}

Eigen::Vector2d Plot::house_from_world(const Eigen::Vector2d& world) const {
  return field_.house_from_local(world - center_);
}

std::vector<Eigen::Vector2d> Plot::world_corners(const Rectangle& r) const {
  std::vector<Eigen::Vector2d> corners;
  for (const Eigen::Vector2d& p : {Eigen::Vector2d(r.x0, r.y0), Eigen::Vector2d(r.x1, r.y0),
                                   Eigen::Vector2d(r.x1, r.y1), Eigen::Vector2d(r.x0, r.y1)}) {
    corners.push_back(center_ + field_.local_from_house(p));
  }
  return corners;
}

double Plot::distance(const Eigen::Vector2d& world) const {
  const Eigen::Vector2d p = house_from_world(world);
  double nearest = std::numeric_limits<double>::infinity();
  for (const Rectangle& r : rectangles_) nearest = std::min(nearest, distance_to(r, p));
  return nearest;
}

double Plot::distance(const Plot& other) const {
  // Two convex shapes overlap unless one of their edges separates them; apart, the shortest way
  // between them starts at a corner of one.
  double nearest = std::numeric_limits<double>::infinity();
  for (const Rectangle& mine : rectangles_) {
    for (const Rectangle& theirs : other.rectangles_) {
      std::vector<Eigen::Vector2d> their_corners, my_corners;
      for (const auto& p : other.world_corners(theirs))
        their_corners.push_back(house_from_world(p));
      for (const auto& p : world_corners(mine)) my_corners.push_back(other.house_from_world(p));
      if (!separated(mine, their_corners) && !separated(theirs, my_corners)) return 0.0;
      for (const auto& p : their_corners) nearest = std::min(nearest, distance_to(mine, p));
      for (const auto& p : my_corners) nearest = std::min(nearest, distance_to(theirs, p));
    }
  }
  return nearest;
}

double Plot::edge_towards(const Eigen::Vector2d& direction) const {
  double edge = 0.0;
  for (double t = 0.0; t <= radius_; t += 0.1) {
    if (field_.block_at_house(field_.house_from_local(t * direction)) >= 0) edge = t;
  }
  return edge;
}

}  // namespace gable
