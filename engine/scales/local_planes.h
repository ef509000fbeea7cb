#pragma once

#include <gable/engine/scales/neighbours.h>

#include <vector>

namespace gable {

/// The plane that best fits the surroundings of every point.
struct LocalPlanes {
  std::vector<Eigen::Vector3f> normals;  ///< unit, of arbitrary sign; zero where there is no plane
  std::vector<float> distances;          ///< of the point from its plane along the normal, metres
  std::vector<float> deviations;         ///< RMS distance of the surroundings to it, metres
};

/// How thick the surfaces of a cloud are, and how far one must look to see that they are surfaces.
struct SurfaceNoise {
  double deviation = 0.0;  ///< typical RMS distance of a flat neighbourhood to its plane, metres
  int thinning = 1;        ///< every so many-th point makes a cloud whose neighbourhoods are flat
};

/// Looks at the neighbourhoods of a sample of points in the cloud, in every second, fourth and so
/// on of its points, until most of them are flat, or fewer again. With noise much larger than the
/// distance between points, the nearest points are a ball that says nothing about the surface,
/// which is only seen from some three times the noise on; a thinner cloud has wider neighbourhoods.
/// `neighbours`: half the points of a neighbourhood.
SurfaceNoise estimate_surface_noise(const OrderedCloud& cloud, int neighbours, int threads);

/// Fits a plane to the surroundings of every point by principal component analysis: its
/// `neighbours`, or, in a cloud that has to be thinned for its surfaces to be seen, twice as many
/// points of the thinned one.
LocalPlanes fit_local_planes(const OrderedCloud& cloud, const Neighbours& neighbours,
                             const SurfaceNoise& noise, int threads);

}  // namespace gable
