#pragma once

#include <gable/engine/scan.h>
#include <gable/training/scans/labelled_surface.h>

#include <cstdint>
#include <string>

namespace gable {

/// How a surface is scanned. Lengths are shares of the diagonal of the surface's bounding box, so
/// that a shed and a hall are scanned alike.
struct SampleOptions {
  int num_points = 143000;  ///< outliers included, [1, 1e9]
  double noise = 0.0;       ///< standard deviation along each axis, share of the diagonal, [0, 1]
  double outlier_share = 0.0;    ///< of all points, [0, 1]; uniform in the box enlarged by 10 %
  double least_normal_z = -1.0;  ///< only triangles whose normal has at least this z, [-1, 1]:
                                 ///< -0.2 leaves what is seen from above
  bool with_normals = false;     ///< the exact normals; zero for outliers
  uint64_t seed = 1;
};

/// Empty if the options are in range; otherwise names the violated bound.
std::string check(const SampleOptions& options);

/// A cloud of points on the surface, uniform by area, with isotropic Gaussian noise and outliers,
/// in random order. Labels "scale_1" (detail) to "scale_3" (hull) hold the plane of every point at
/// each scale, -1 for outliers. The surface must have a triangle of positive area that is seen.
Scan sample_surface(const LabelledSurface& surface, const SampleOptions& options);

}  // namespace gable
