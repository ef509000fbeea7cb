#pragma once

#include <gable/engine/scan.h>
#include <gable/grammar/random.h>
#include <gable/residuals/oriented_plane.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

namespace gable {

enum class HouseKind { kBox, kGable, kHip, kEvenHip };

/// A house as flat facets, in national coordinates, and points on it.
struct SyntheticHouse {
  std::vector<std::vector<Eigen::Vector3d>> facets;  ///< rings, outward normals
  double diagonal = 0.0;

  OrientedPlane plane(size_t facet) const {
    const auto& ring = facets[facet];
    const Eigen::Vector3d normal = (ring[1] - ring[0]).cross(ring[2] - ring[0]).normalized();
    return {normal, normal.dot(ring[0])};
  }
};

/// A house of random size, turned by a random azimuth: a box with a flat roof, or walls under a
/// gabled roof, a hipped roof whose ends are of another slope than its sides, or one of a single
/// slope all around. No floor.
inline SyntheticHouse random_house(HouseKind kind, Random* random) {
  const double length = random->uniform(8.0, 16.0), width = random->uniform(5.0, 9.0);
  const double eaves = random->uniform(2.5, 7.0);
  const double rise = 0.5 * width * std::tan(random->uniform(0.35, 1.0));
  const bool hipped = kind == HouseKind::kHip || kind == HouseKind::kEvenHip;
  const double own_hip = random->uniform(0.15, 0.45) * length;
  const double hip = !hipped ? 0.0 : kind == HouseKind::kHip ? own_hip : width / 2;
  const double azimuth = random->uniform(0.0, 3.14);
  const auto at = [&](double x, double y, double z) {
    return Eigen::Vector3d(Eigen::AngleAxisd(azimuth, Eigen::Vector3d::UnitZ()) *
                               Eigen::Vector3d(x - length / 2, y - width / 2, z) +
                           Eigen::Vector3d(85000.0, 446000.0, 3.0));
  };
  const double l = length, w = width, top = eaves + rise;
  SyntheticHouse house;
  house.facets.push_back({at(0, 0, 0), at(l, 0, 0), at(l, 0, eaves), at(0, 0, eaves)});
  house.facets.push_back({at(l, w, 0), at(0, w, 0), at(0, w, eaves), at(l, w, eaves)});
  std::vector<Eigen::Vector3d> near_end{at(0, w, 0), at(0, 0, 0), at(0, 0, eaves), at(0, w, eaves)};
  std::vector<Eigen::Vector3d> far_end{at(l, 0, 0), at(l, w, 0), at(l, w, eaves), at(l, 0, eaves)};
  if (kind == HouseKind::kBox) {
    house.facets.push_back({at(0, 0, eaves), at(l, 0, eaves), at(l, w, eaves), at(0, w, eaves)});
  } else {
    const Eigen::Vector3d ridge[] = {at(hip, w / 2, top), at(l - hip, w / 2, top)};
    house.facets.push_back({at(0, 0, eaves), at(l, 0, eaves), ridge[1], ridge[0]});
    house.facets.push_back({at(l, w, eaves), at(0, w, eaves), ridge[0], ridge[1]});
    if (hipped) {
      house.facets.push_back({at(0, w, eaves), at(0, 0, eaves), ridge[0]});
      house.facets.push_back({at(l, 0, eaves), at(l, w, eaves), ridge[1]});
    } else {
      near_end.insert(near_end.begin() + 3, ridge[0]);
      far_end.insert(far_end.begin() + 3, ridge[1]);
    }
  }
  house.facets.push_back(near_end);
  house.facets.push_back(far_end);
  Eigen::AlignedBox3d box;
  for (const auto& ring : house.facets) {
    for (const Eigen::Vector3d& p : ring) box.extend(p);
  }
  house.diagonal = box.diagonal().norm();
  return house;
}

/// About `count` points, spread evenly over the house's area and moved by normal noise in x, y and
/// z; a share of `outliers` lies up to ten times the noise off its facet. shape_of: their facets.
inline Scan scan_house(const SyntheticHouse& house, int count, double noise, double outliers,
                       Random* random, std::vector<int>* shape_of) {
  struct Triangle {
    Eigen::Vector3d a, b, c;
    int facet;
    double area;
  };
  std::vector<Triangle> triangles;
  double area = 0.0;
  for (size_t f = 0; f < house.facets.size(); ++f) {
    const auto& ring = house.facets[f];
    for (size_t i = 2; i < ring.size(); ++i) {
      const double own = 0.5 * (ring[i - 1] - ring[0]).cross(ring[i] - ring[0]).norm();
      triangles.push_back({ring[0], ring[i - 1], ring[i], static_cast<int>(f), own});
      area += own;
    }
  }
  Scan scan;
  shape_of->clear();
  for (const Triangle& t : triangles) {
    const Eigen::Vector3d normal = (t.b - t.a).cross(t.c - t.a).normalized();
    const int points = static_cast<int>(std::lround(count * t.area / area));
    for (int i = 0; i < points; ++i) {
      double u = random->uniform(0.0, 1.0), v = random->uniform(0.0, 1.0);
      if (u + v > 1.0) u = 1.0 - u, v = 1.0 - v;
      Eigen::Vector3d p = t.a + u * (t.b - t.a) + v * (t.c - t.a);
      p += Eigen::Vector3d(random->normal(noise), random->normal(noise), random->normal(noise));
      if (random->chance(outliers)) p += normal * random->uniform(-10.0, 10.0) * noise;
      scan.points.push_back(p);
      shape_of->push_back(t.facet);
    }
  }
  return scan;
}

}  // namespace gable
