// Planes refitted to noisy points with what they have to do with each other.
#include <gable/engine/solver/plane_refinement.h>
#include <gable/grammar/random.h>

#include <cstdio>

int main() {
  using namespace gable;
  // Two sides of a roof of 40 degrees and a wall, 150 points each, 5 cm of noise.
  const double pitch = 40.0 * M_PI / 180.0;
  const std::vector<OrientedPlane> truth = {{{0.0, -std::sin(pitch), std::cos(pitch)}, 6.0},
                                            {{0.0, std::sin(pitch), std::cos(pitch)}, 6.0},
                                            {{1.0, 0.0, 0.0}, 5.0}};
  Random random(1);
  std::vector<Eigen::Vector3d> points;
  std::vector<std::vector<int>> members(truth.size());
  std::vector<PointMoments> moments(truth.size());
  for (size_t i = 0; i < truth.size(); ++i) {
    for (int k = 0; k < 150; ++k) {
      Eigen::Vector3d p(random.uniform(-4, 4), random.uniform(-4, 4), random.uniform(-4, 4));
      p -= truth[i].normal() * (truth[i].signed_distance(p) + random.normal(0.05));
      members[i].push_back(static_cast<int>(points.size()));
      moments[i].add(p, 1.0);
      points.push_back(p);
    }
  }

  std::vector<OrientedPlane> planes = truth;
  for (OrientedPlane& plane : planes) {  // starts a few degrees off
    plane.values.head<3>() += Eigen::Vector3d(0.04, -0.03, 0.05);
    plane.values.head<3>().normalize();
  }
  refine_planes(points, members, {}, {}, &planes);
  const auto regularities = detect_regularities(planes, moments, {}, {});
  const auto summary = refine_planes(points, members, regularities, {}, &planes);

  std::printf("%zu regularities, points within %.3f m\n", regularities.size(), summary.rmse);
  for (size_t i = 0; i < planes.size(); ++i) {
    const double cosine = std::abs(planes[i].normal().dot(truth[i].normal()));
    std::printf("plane %zu is off by %.2f degrees\n", i,
                std::acos(std::min(1.0, cosine)) * 180.0 / M_PI);
  }
}
