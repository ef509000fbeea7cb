#pragma once

#include <Eigen/Core>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace gable {

/// Polygons over numbered points, one after the other.
class Facets {
 public:
  size_t size() const { return begins_.size() - 1; }
  bool empty() const { return size() == 0; }
  /// The corners of a facet, in order around it.
  std::span<const int> operator[](size_t facet) const {
    return std::span(corners_).subspan(begins_[facet], begins_[facet + 1] - begins_[facet]);
  }
  void add(std::span<const int> corners) {
    corners_.insert(corners_.end(), corners.begin(), corners.end());
    begins_.push_back(corners_.size());
  }
  bool operator==(const Facets&) const = default;

 private:
  std::vector<size_t> begins_{0};
  std::vector<int> corners_;
};

/// What a scanner or a reconstruction delivers: a cloud of points or a mesh, in any metric frame
/// with z up. Its *elements* are what planar shapes are made of: the points of a cloud, the facets
/// of a mesh. All values are finite; corners of facets are indices of points, but facets may be
/// degenerate (repeated or collinear corners) and edges may have any number of facets.
struct Scan {
  std::vector<Eigen::Vector3d> points;   ///< metres
  std::vector<Eigen::Vector3f> normals;  ///< per point, unit or zero (unknown); or none at all
  Facets facets;                         ///< none: a cloud
  /// Integers by name, one per element, -1 for none: known shapes, classes.
  std::map<std::string, std::vector<int>> labels;

  bool is_mesh() const { return !facets.empty(); }
  size_t num_elements() const { return is_mesh() ? facets.size() : points.size(); }
};

}  // namespace gable
