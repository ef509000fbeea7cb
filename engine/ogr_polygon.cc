#include <gable/engine/ogr_polygon.h>
#include <gable/grammar/ring.h>

namespace gable {
namespace {

OGRLinearRing ogr_ring(const Ring& ring) {
  OGRLinearRing out;
  for (const Eigen::Vector2d& p : ring) out.addPoint(p.x(), p.y());
  out.closeRings();
  return out;
}

}  // namespace

OGRPolygon ogr_polygon(const PlanPolygon& polygon) {
  OGRPolygon out;
  OGRLinearRing outer = ogr_ring(polygon.outer);
  out.addRing(&outer);
  for (const Ring& hole : polygon.holes) {
    OGRLinearRing inner = ogr_ring(hole);
    out.addRing(&inner);
  }
  return out;
}

}  // namespace gable
