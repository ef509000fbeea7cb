#include <ceres/product_manifold.h>
#include <ceres/sphere_manifold.h>
#include <gable/residuals/oriented_plane.h>

namespace gable {

ceres::Manifold* make_plane_manifold() {
  return new ceres::ProductManifold<ceres::SphereManifold<3>, ceres::EuclideanManifold<1>>();
}

}  // namespace gable
