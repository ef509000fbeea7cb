#include <gable/training/scans/car_shape.h>

#include <algorithm>

namespace gable {

CarShape random_car_shape(Random* random) {
  CarShape c;
  const int style = random->integer(0, 4);  // saloon, hatchback, estate, off-roader, van
  c.length = style == 1 ? random->uniform(3.6, 4.2) : random->uniform(4.2, 4.9);
  c.width = random->uniform(1.64, 1.86);
  const double lift = style == 3 ? random->uniform(0.12, 0.22) : 0.0;
  c.sill = random->uniform(0.18, 0.25) + lift;
  c.wheel = random->uniform(0.29, 0.33) + 0.3 * lift;
  c.crease = 2.0 * c.wheel + random->uniform(0.1, 0.14) + 0.5 * lift;
  c.belt = c.crease + random->uniform(0.14, 0.2);
  c.nose = std::max(c.crease + 0.01, c.belt - random->uniform(0.12, 0.22));
  c.roof = c.belt + random->uniform(0.42, 0.52);
  c.front_axle = c.length * random->uniform(0.17, 0.2);
  c.bonnet_end = c.length * random->uniform(0.25, 0.29);
  c.roof_start = c.bonnet_end + random->uniform(0.65, 0.85);
  c.boot = style == 0;
  if (c.boot) {
    c.roof_end = c.length * random->uniform(0.66, 0.7);
    c.rear_window_end = c.length * random->uniform(0.85, 0.88);
    c.boot_height = c.belt + random->uniform(0.02, 0.08);
  } else {
    c.rear_window_end = c.length - random->uniform(0.02, 0.08);
    c.roof_end =
        c.rear_window_end - (style == 1 ? random->uniform(0.35, 0.6) : random->uniform(0.15, 0.3));
    c.boot_height = c.belt + random->uniform(0.0, 0.05);
  }
  if (style == 4) {
    c.roof += random->uniform(0.12, 0.22);
    c.bonnet_end = c.length * random->uniform(0.22, 0.24);
    c.roof_start = c.bonnet_end + random->uniform(0.6, 0.75);
  }
  c.rear_axle = c.length * random->uniform(0.78, 0.81);
  c.shoulder = random->uniform(0.045, 0.07);
  c.tumblehome = random->uniform(0.17, 0.25);
  c.corner = random->uniform(0.2, 0.3);
  c.taper = random->uniform(0.05, 0.09);
  c.crown = random->uniform(0.02, 0.04);
  c.bulge = random->uniform(0.01, 0.025);
  c.bow = random->uniform(0.03, 0.06);
  c.bumper = random->uniform(0.02, 0.045);
  c.underbody = random->chance(0.5);
  c.strips = random->integer(3, 5);
  return c;
}

}  // namespace gable
