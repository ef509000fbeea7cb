#pragma once

#include <gable/engine/scan.h>
#include <gable/grammar/random.h>

#include <Eigen/Core>

namespace gable {

/// Points of the parallelogram at `corner` with the sides u and v, metres, with normal noise of
/// `noise` metres in every coordinate.
inline void add_patch(const Eigen::Vector3d& corner, const Eigen::Vector3d& u,
                      const Eigen::Vector3d& v, int count, double noise, int label, Random* random,
                      Scan* scan) {
  for (int i = 0; i < count; ++i) {
    const double a = random->uniform(0.0, 1.0), b = random->uniform(0.0, 1.0);
    const Eigen::Vector3d jitter(random->normal(noise), random->normal(noise),
                                 random->normal(noise));
    scan->points.push_back(corner + a * u + b * v + jitter);
    scan->labels["truth"].push_back(label);
  }
}

/// The six faces of a box of 10 x 6 x 4 m, `count` points each.
inline Scan box_cloud(int count, double noise, uint64_t seed) {
  Random random(seed);
  Scan scan;
  const Eigen::Vector3d o = Eigen::Vector3d::Zero(), x(10, 0, 0), y(0, 6, 0), z(0, 0, 4);
  add_patch(o, x, y, count, noise, 0, &random, &scan);
  add_patch(z, x, y, count, noise, 1, &random, &scan);
  add_patch(o, x, z, count, noise, 2, &random, &scan);
  add_patch(y, x, z, count, noise, 3, &random, &scan);
  add_patch(o, y, z, count, noise, 4, &random, &scan);
  add_patch(x, y, z, count, noise, 5, &random, &scan);
  return scan;
}

}  // namespace gable
