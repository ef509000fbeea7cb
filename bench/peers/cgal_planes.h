#pragma once

#include <Eigen/Core>
#include <vector>

namespace gable {

/// What CGAL's plane detectors are given. Lengths in metres, angles in degrees.
struct CgalPlaneOptions {
  double epsilon = 0.1;         ///< largest distance of a point from its plane
  double angle = 25.0;          ///< largest angle between a point's normal and its plane's
  int least_points = 100;       ///< of a plane
  int neighbours = 12;          ///< region growing: of a point
  double cluster_epsilon = -1;  ///< RANSAC: reach of connectivity; negative: CGAL's default, 1 % of
                                ///< the diagonal
  double probability = 0.01;    ///< RANSAC: of missing the largest plane
  unsigned seed = 1;            ///< RANSAC
};

/// Unit normals by principal components over k neighbours (CGAL::pca_estimate_normals), one thread.
std::vector<Eigen::Vector3d> cgal_normals(const std::vector<Eigen::Vector3d>& points, int k);

/// Region growing (CGAL 5.5 Shape_detection: K_neighbor_query, Least_squares_plane_fit_region and
/// _sorting): the plane of every point, -1 for none.
std::vector<int> cgal_region_growing(const std::vector<Eigen::Vector3d>& points,
                                     const std::vector<Eigen::Vector3d>& normals,
                                     const CgalPlaneOptions& options);

/// Efficient RANSAC (Schnabel, Wahl and Klein 2007; CGAL 5.5 Shape_detection) for planes alone.
std::vector<int> cgal_efficient_ransac(const std::vector<Eigen::Vector3d>& points,
                                       const std::vector<Eigen::Vector3d>& normals,
                                       const CgalPlaneOptions& options);

}  // namespace gable
