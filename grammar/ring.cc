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

}  // namespace gable
