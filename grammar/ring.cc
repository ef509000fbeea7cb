#include <gable/grammar/ring.h>

namespace gable {

double signed_area(const Ring& ring) {
  double twice = 0.0;
  for (size_t i = 2; i < ring.size(); ++i) {
    const Eigen::Vector2d a = ring[i - 1] - ring[0], b = ring[i] - ring[0];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return twice / 2.0;
}

bool ring_holds(const Ring& ring, const Eigen::Vector2d& p) {
  bool inside = false;
  for (size_t k = 0; k < ring.size(); ++k) {
    const Eigen::Vector2d& a = ring[k];
    const Eigen::Vector2d& b = ring[(k + 1) % ring.size()];
    if ((a.y() > p.y()) == (b.y() > p.y())) continue;
    if (p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) inside = !inside;
  }
  return inside;
}

bool rings_hold(std::span<const Ring> rings, const Eigen::Vector2d& point) {
  bool inside = false;
  for (const Ring& ring : rings) inside = inside != ring_holds(ring, point);
  return inside;
}

}  // namespace gable
