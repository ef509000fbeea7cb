#include <gable/grammar/solid/triangulate.h>
#include <gable/training/scans/plane_attachment.h>
#include <gable/training/scans/surface_builder.h>
#include <gable/training/scans/triangle_contact.h>
#include <glog/logging.h>

#include <algorithm>
#include <map>
#include <set>

namespace gable {
namespace {

using Eigen::Vector3d;

/// Points nearer than this are one, metres; triangles thinner are left out.
constexpr double kResolution = 1e-4;

Vector3d normal_sum(const SurfaceBuilder::Ring& ring) {
  Vector3d sum = Vector3d::Zero();
  for (size_t i = 1; i + 1 < ring.size(); ++i) {
    sum += (ring[i] - ring[0]).cross(ring[i + 1] - ring[0]);
  }
  return sum;
}

SurfaceBuilder::Ring distinct_points(const SurfaceBuilder::Ring& ring) {
  SurfaceBuilder::Ring out;
  for (const Vector3d& p : ring) {
    if (out.empty() || (p - out.back()).norm() > kResolution) out.push_back(p);
  }
  while (out.size() > 1 && (out.front() - out.back()).norm() <= kResolution) out.pop_back();
  return out;
}

bool is_thin(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
  return (b - a).cross(c - a).norm() <= kResolution * longest;
}

/// Names by first appearance, from 0.
class Renumbering {
 public:
  int operator()(int old) {
    return names_.try_emplace(old, static_cast<int>(names_.size())).first->second;
  }

 private:
  std::map<int, int> names_;
};

}  // namespace

int SurfaceBuilder::add_structure(int hull) {
  CHECK(hull == kTouching || (hull >= 0 && hull < num_hulls_));
  hull_of_.push_back(hull);
  return static_cast<int>(hull_of_.size()) - 1;
}

int SurfaceBuilder::add_detail(int structure) {
  CHECK(structure == kTouching ||
        (structure >= 0 && structure < static_cast<int>(hull_of_.size())));
  structure_of_.push_back(structure);
  return static_cast<int>(structure_of_.size()) - 1;
}

void SurfaceBuilder::add_polygon(int detail, const Ring& outer, const std::vector<Ring>& holes) {
  CHECK(detail >= 0 && detail < static_cast<int>(structure_of_.size()));
  Solid solid;
  Face face;
  const auto add_ring = [&](const Ring& points, const Vector3d& normal) {
    Ring ring = distinct_points(points);
    if (ring.size() < 3) return;
    if (normal_sum(ring).dot(normal) < 0.0) std::reverse(ring.begin(), ring.end());
    std::vector<int> corners;
    for (const Vector3d& p : ring) {
      corners.push_back(static_cast<int>(solid.vertices.size()));
      solid.vertices.push_back(pose_ * p);
    }
    face.rings.push_back(corners);
  };
  const Vector3d normal = normal_sum(outer);
  add_ring(outer, normal);
  if (face.rings.empty()) return;
  for (const Ring& hole : holes) add_ring(hole, -normal);
  const bool mirrored = pose_.linear().determinant() < 0.0;
  if (mirrored) {
    for (std::vector<int>& ring : face.rings) std::reverse(ring.begin(), ring.end());
  }
  const int first = static_cast<int>(vertices_.size());
  vertices_.insert(vertices_.end(), solid.vertices.begin(), solid.vertices.end());
  for (const std::array<int, 3>& t : triangulate(solid, face)) {
    if (is_thin(solid.vertices[t[0]], solid.vertices[t[1]], solid.vertices[t[2]])) continue;
    triangles_.push_back({first + t[0], first + t[1], first + t[2]});
    detail_of_.push_back(detail);
  }
}

int SurfaceBuilder::add_face(int structure, const Ring& outer, const std::vector<Ring>& holes) {
  const int detail = add_detail(structure);
  add_polygon(detail, outer, holes);
  return detail;
}

LabelledSurface SurfaceBuilder::build(double contact) const {
  LabelledSurface out;
  out.triangles = triangles_;

  // Details that have triangles, numbered without gaps.
  Renumbering number_detail;
  std::vector<int> details, structure_seed;
  for (int detail : detail_of_) {
    const int number = number_detail(detail);
    details.push_back(number);
    if (number == static_cast<int>(structure_seed.size())) {
      structure_seed.push_back(structure_of_[detail]);
    }
  }
  std::vector<TriangleCorners> corners;
  std::vector<PointMoments> moments(structure_seed.size());
  for (size_t i = 0; i < triangles_.size(); ++i) {
    const auto& [a, b, c] = triangles_[i];
    corners.push_back({vertices_[a], vertices_[b], vertices_[c]});
    moments[details[i]] +=
        triangle_moments(vertices_[a], vertices_[b], vertices_[c], Vector3d::Zero());
  }
  const auto adjacent = touching_groups(corners, details, contact);
  const std::vector<int> structures = attach_planes(moments, adjacent, structure_seed);

  int num_structures = 0;
  for (int s : structures) num_structures = std::max(num_structures, s + 1);
  std::vector<PointMoments> structure_moments(num_structures);
  std::vector<int> hull_seed(num_structures, kTouching);
  for (size_t d = 0; d < structures.size(); ++d) {
    structure_moments[structures[d]] += moments[d];
    const int s = structures[d];
    if (s < static_cast<int>(hull_of_.size())) hull_seed[s] = hull_of_[s];
  }
  std::set<std::pair<int, int>> structure_pairs;
  for (const auto& [a, b] : adjacent) {
    if (structures[a] != structures[b]) {
      structure_pairs.insert(std::minmax(structures[a], structures[b]));
    }
  }
  const std::vector<std::pair<int, int>> pairs(structure_pairs.begin(), structure_pairs.end());
  const std::vector<int> hulls = attach_planes(structure_moments, pairs, hull_seed);

  Renumbering number_structure, number_hull, number_vertex;
  for (int detail : details) {
    const int s = structures[detail];
    out.planes.push_back({detail, number_structure(s), number_hull(hulls[s])});
  }
  for (std::array<int, 3>& t : out.triangles) {
    for (int& v : t) {
      const int number = number_vertex(v);
      if (number == static_cast<int>(out.vertices.size())) out.vertices.push_back(vertices_[v]);
      v = number;
    }
  }
  return out;
}

}  // namespace gable
