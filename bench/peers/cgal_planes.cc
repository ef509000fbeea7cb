#include "cgal_planes.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Shape_detection/Efficient_RANSAC.h>
#include <CGAL/Shape_detection/Region_growing/Region_growing.h>
#include <CGAL/Shape_detection/Region_growing/Region_growing_on_point_set.h>
#include <CGAL/pca_estimate_normals.h>
#include <CGAL/property_map.h>

#include <cmath>
#include <tuple>

namespace gable {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
/// Where a point is, its normal, and its number before any reordering.
using Element = std::tuple<Kernel::Point_3, Kernel::Vector_3, size_t>;
using Cloud = std::vector<Element>;
using PointMap = CGAL::Nth_of_tuple_property_map<0, Element>;
using NormalMap = CGAL::Nth_of_tuple_property_map<1, Element>;

Cloud cloud_of(const std::vector<Eigen::Vector3d>& points,
               const std::vector<Eigen::Vector3d>& normals) {
  Cloud cloud;
  cloud.reserve(points.size());
  for (size_t i = 0; i < points.size(); ++i) {
    cloud.emplace_back(Kernel::Point_3(points[i].x(), points[i].y(), points[i].z()),
                       Kernel::Vector_3(normals[i].x(), normals[i].y(), normals[i].z()), i);
  }
  return cloud;
}

}  // namespace

std::vector<Eigen::Vector3d> cgal_normals(const std::vector<Eigen::Vector3d>& points, int k) {
  Cloud cloud = cloud_of(points, points);
  CGAL::pca_estimate_normals<CGAL::Sequential_tag>(
      cloud, k, CGAL::parameters::point_map(PointMap()).normal_map(NormalMap()));
  std::vector<Eigen::Vector3d> normals;
  normals.reserve(points.size());
  for (const auto& [point, normal, number] : cloud) {
    normals.emplace_back(normal.x(), normal.y(), normal.z());
  }
  return normals;
}

std::vector<int> cgal_region_growing(const std::vector<Eigen::Vector3d>& points,
                                     const std::vector<Eigen::Vector3d>& normals,
                                     const CgalPlaneOptions& options) {
  namespace point_set = CGAL::Shape_detection::Point_set;
  using Neighbours = point_set::K_neighbor_query<Kernel, Cloud, PointMap>;
  using Region = point_set::Least_squares_plane_fit_region<Kernel, Cloud, PointMap, NormalMap>;
  using Sorting = point_set::Least_squares_plane_fit_sorting<Kernel, Cloud, Neighbours, PointMap>;
  const Cloud cloud = cloud_of(points, normals);
  Neighbours neighbours(cloud, options.neighbours);
  Region region(cloud, options.epsilon, options.angle, options.least_points);
  Sorting sorting(cloud, neighbours);
  sorting.sort();
  CGAL::Shape_detection::Region_growing<Cloud, Neighbours, Region, Sorting::Seed_map> growing(
      cloud, neighbours, region, sorting.seed_map());
  std::vector<std::vector<size_t>> regions;
  growing.detect(std::back_inserter(regions));
  std::vector<int> plane_of(points.size(), -1);
  for (size_t i = 0; i < regions.size(); ++i) {
    for (const size_t point : regions[i]) plane_of[point] = static_cast<int>(i);
  }
  return plane_of;
}

std::vector<int> cgal_efficient_ransac(const std::vector<Eigen::Vector3d>& points,
                                       const std::vector<Eigen::Vector3d>& normals,
                                       const CgalPlaneOptions& options) {
  using Traits = CGAL::Shape_detection::Efficient_RANSAC_traits<Kernel, Cloud, PointMap, NormalMap>;
  using Ransac = CGAL::Shape_detection::Efficient_RANSAC<Traits>;
  Cloud cloud = cloud_of(points, normals);
  CGAL::get_default_random() = CGAL::Random(options.seed);
  Ransac ransac;
  ransac.set_input(cloud);
  ransac.add_shape_factory<CGAL::Shape_detection::Plane<Traits>>();
  Ransac::Parameters parameters;
  parameters.probability = options.probability;
  parameters.min_points = options.least_points;
  parameters.epsilon = options.epsilon;
  parameters.cluster_epsilon = options.cluster_epsilon;
  parameters.normal_threshold = std::cos(options.angle * M_PI / 180.0);
  ransac.detect(parameters);
  std::vector<int> plane_of(points.size(), -1);
  int number = 0;
  for (const auto& shape : ransac.shapes()) {
    for (const size_t point : shape->indices_of_assigned_points()) {
      // Detection reorders the cloud.
      plane_of[std::get<2>(cloud[point])] = number;
    }
    ++number;
  }
  return plane_of;
}

}  // namespace gable
