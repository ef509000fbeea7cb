#include <gable/engine/ogr_polygon.h>
#include <gable/engine/plan_overlay.h>
#include <gable/grammar/ring.h>
#include <ogr_geometry.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace gable {
namespace {

constexpr double kLeastArea = 1e-4;  // square metres

using Geometry = std::unique_ptr<OGRGeometry>;

OGRMultiPolygon geometry_of(const PlanShape& shape) {
  OGRMultiPolygon geometry;
  for (const PlanPolygon& polygon : shape) {
    const OGRPolygon part = ogr_polygon(polygon);
    geometry.addGeometry(&part);
  }
  return geometry;
}

Ring ring_of(const OGRLinearRing& points, bool anticlockwise) {
  Ring ring;
  for (int i = 0; i + 1 < points.getNumPoints(); ++i) {
    ring.emplace_back(points.getX(i), points.getY(i));
  }
  if ((signed_area(ring) > 0.0) != anticlockwise) std::reverse(ring.begin(), ring.end());
  return ring;
}

void append_polygons(const OGRGeometry* geometry, PlanShape* shape) {
  if (geometry == nullptr) return;
  const OGRwkbGeometryType type = wkbFlatten(geometry->getGeometryType());
  if (type == wkbPolygon) {
    const OGRPolygon* rings = geometry->toPolygon();
    if (rings->getExteriorRing() == nullptr || rings->get_Area() < kLeastArea) return;
    PlanPolygon polygon{ring_of(*rings->getExteriorRing(), true), {}};
    for (int i = 0; i < rings->getNumInteriorRings(); ++i) {
      Ring hole = ring_of(*rings->getInteriorRing(i), false);
      if (std::abs(signed_area(hole)) >= kLeastArea) polygon.holes.push_back(std::move(hole));
    }
    shape->push_back(std::move(polygon));
  } else if (type == wkbMultiPolygon || type == wkbGeometryCollection) {
    for (const OGRGeometry* part : *geometry->toGeometryCollection()) append_polygons(part, shape);
  }
}

PlanShape shape_of(const Geometry& geometry) {
  PlanShape shape;
  append_polygons(geometry.get(), &shape);
  return shape;
}

}  // namespace

PlanShape union_of(const PlanShape& a, const PlanShape& b) {
  const OGRMultiPolygon first = geometry_of(a), second = geometry_of(b);
  return shape_of(Geometry(first.Union(&second)));
}

PlanShape common_of(const PlanShape& a, const PlanShape& b) {
  const OGRMultiPolygon first = geometry_of(a), second = geometry_of(b);
  return shape_of(Geometry(first.Intersection(&second)));
}

PlanShape difference_of(const PlanShape& a, const PlanShape& b) {
  const OGRMultiPolygon first = geometry_of(a), second = geometry_of(b);
  return shape_of(Geometry(first.Difference(&second)));
}

PlanShape moved(PlanShape shape, const Eigen::Vector2d& step) {
  for (PlanPolygon& polygon : shape) {
    for (Eigen::Vector2d& p : polygon.outer) p += step;
    for (Ring& hole : polygon.holes) {
      for (Eigen::Vector2d& p : hole) p += step;
    }
  }
  return shape;
}

double area_of(const PlanShape& shape) {
  double area = 0.0;
  for (const PlanPolygon& polygon : shape) {
    area += std::abs(signed_area(polygon.outer));
    for (const Ring& hole : polygon.holes) area -= std::abs(signed_area(hole));
  }
  return area;
}

}  // namespace gable
