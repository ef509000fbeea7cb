#include <gable/training/scans/sofa_shape.h>

namespace gable {

SofaShape random_sofa_shape(Random* random) {
  SofaShape s;
  s.seats = random->integer(1, 4);
  s.arms = random->chance(0.88);
  s.arm_width = s.arms ? random->uniform(0.14, 0.26) : 0.0;
  s.width = s.seats * random->uniform(0.55, 0.72) + 2.0 * s.arm_width + (s.seats == 1 ? 0.2 : 0.0);
  s.depth = random->uniform(0.82, 1.0);
  s.seat_height = random->uniform(0.38, 0.46);
  s.back_width = random->uniform(0.16, 0.24);
  s.leg = random->uniform(0.05, 0.12);
  s.base = s.leg + random->uniform(0.1, 0.15);
  s.back_height = s.seat_height + random->uniform(0.36, 0.5);
  s.lean = random->uniform(0.03, 0.08);
  s.arm_height = s.seat_height + random->uniform(0.14, 0.22);
  s.cushions_behind = random->chance(0.75);
  s.radius = random->uniform(0.025, 0.05);
  s.steps = random->integer(2, 4);
  s.bulge = random->uniform(0.006, 0.02);
  s.chaise = s.seats > 1 && random->chance(0.25) ? random->uniform(0.5, 0.75) : 0.0;
  s.rolled = random->chance(0.3);
  s.pillows = s.seats > 1 && random->chance(0.4) ? random->integer(1, 2) : 0;
  return s;
}

}  // namespace gable
