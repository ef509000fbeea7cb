#include <gable/grammar/ring.h>
#include <gable/grammar/solid/validity.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

namespace gable {
namespace {

using Points2 = std::vector<Eigen::Vector2d>;

// Twice the area vector of a ring (Newell), relative to its first vertex.
Eigen::Vector3d ring_normal(const Solid& solid, const std::vector<int>& ring) {
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  for (size_t i = 1; i + 1 < ring.size(); ++i) {
    normal += (solid.vertices[ring[i]] - solid.vertices[ring[0]])
                  .cross(solid.vertices[ring[i + 1]] - solid.vertices[ring[0]]);
  }
  return normal;
}

double cross(const Eigen::Vector2d& o, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return (a.x() - o.x()) * (b.y() - o.y()) - (a.y() - o.y()) * (b.x() - o.x());
}

bool segments_cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
                    const Eigen::Vector2d& d) {
  constexpr double kEps = 1e-12;
  return cross(a, b, c) * cross(a, b, d) < -kEps && cross(c, d, a) * cross(c, d, b) < -kEps;
}

bool any_crossing(const std::vector<Points2>& rings) {
  std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>> segments;
  for (const Points2& ring : rings) {
    for (size_t i = 0; i < ring.size(); ++i) {
      segments.emplace_back(ring[i], ring[(i + 1) % ring.size()]);
    }
  }
  for (size_t i = 0; i < segments.size(); ++i) {
    for (size_t j = i + 1; j < segments.size(); ++j) {
      if (segments_cross(segments[i].first, segments[i].second, segments[j].first,
                         segments[j].second)) {
        return true;
      }
    }
  }
  return false;
}

bool faces_its_way(SurfaceType type, double normal_z) {
  if (type == SurfaceType::kRoof) return normal_z > 0.01;
  if (type == SurfaceType::kGround) return normal_z < -0.01;
  return std::abs(normal_z) < 0.7;
}

// Largest distance of the vertices from the plane that fits them best.
double distance_from_mean_plane(const Solid& solid, const std::vector<int>& vertices,
                                const Eigen::Vector3d& center) {
  if (vertices.size() < 4) return 0.0;
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const int v : vertices) {
    const Eigen::Vector3d p = solid.vertices[v] - center;
    scatter += p * p.transpose();
  }
  const Eigen::Vector3d normal =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(scatter).eigenvectors().col(0);
  double distance = 0.0;
  for (const int v : vertices) {
    distance = std::max(distance, std::abs(normal.dot(solid.vertices[v] - center)));
  }
  return distance;
}

void check_face(const Solid& solid, const Face& face, const ValidityTolerance& tolerance,
                SolidValidity* validity) {
  std::vector<int> all;
  bool short_ring = face.rings.empty();
  for (const std::vector<int>& ring : face.rings) {
    short_ring = short_ring || ring.size() < 3;
    all.insert(all.end(), ring.begin(), ring.end());
  }
  std::sort(all.begin(), all.end());
  if (short_ring || std::adjacent_find(all.begin(), all.end()) != all.end()) {
    ++validity->bad_rings;
    return;
  }
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  for (const std::vector<int>& ring : face.rings) normal += ring_normal(solid, ring);
  for (const int v : all) center += solid.vertices[v];
  center /= static_cast<double>(all.size());
  if (!(normal.norm() > tolerance.resolution * tolerance.resolution)) {
    ++validity->bad_rings;
    return;
  }
  normal.normalize();
  const double off = distance_from_mean_plane(solid, all, center);
  validity->planarity = std::max(validity->planarity, off);
  if (off > tolerance.planarity) ++validity->non_planar_faces;
  if (!faces_its_way(face.type, normal.z())) ++validity->misfacing;

  const Eigen::Vector3d u = normal.unitOrthogonal();
  const Eigen::Vector3d w = normal.cross(u);
  std::vector<Points2> rings;
  for (const std::vector<int>& ring : face.rings) {
    Points2& points = rings.emplace_back();
    for (const int v : ring) {
      const Eigen::Vector3d p = solid.vertices[v] - center;
      points.emplace_back(p.dot(u), p.dot(w));
    }
  }
  if (any_crossing(rings)) ++validity->crossing_rings;
  if (signed_area(rings[0]) <= 0.0) ++validity->misplaced_holes;
  for (size_t i = 1; i < rings.size(); ++i) {
    bool fits = signed_area(rings[i]) < 0.0 && ring_holds(rings[0], rings[i][0]);
    for (size_t j = 1; j < rings.size(); ++j) {
      fits = fits && (i == j || !ring_holds(rings[j], rings[i][0]));
    }
    if (!fits) ++validity->misplaced_holes;
  }
}

struct DirectedEdge {
  int from, to, face, after;  // after: where the ring goes on from `to`
  bool operator<(const DirectedEdge& other) const {
    return from != other.from ? from < other.from : to < other.to;
  }
};

std::vector<DirectedEdge> sorted_edges(const Solid& solid) {
  std::vector<DirectedEdge> edges;
  for (size_t f = 0; f < solid.faces.size(); ++f) {
    for (const std::vector<int>& ring : solid.faces[f].rings) {
      const size_t n = ring.size();
      for (size_t i = 0; i < n; ++i) {
        edges.push_back({ring[i], ring[(i + 1) % n], static_cast<int>(f), ring[(i + 2) % n]});
      }
    }
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

void check_near(const Solid& solid, const std::vector<DirectedEdge>& edges, double resolution,
                SolidValidity* validity) {
  const int n = static_cast<int>(solid.vertices.size());
  for (int i = 0; i < n; ++i) {
    for (int j = i + 1; j < n; ++j) {
      // Written so that a vertex that is not a number counts as near.
      if (!((solid.vertices[i] - solid.vertices[j]).norm() >= resolution)) {
        ++validity->near_vertices;
      }
    }
  }
  for (const DirectedEdge& edge : edges) {
    const Eigen::Vector3d& from = solid.vertices[edge.from];
    const Eigen::Vector3d along = solid.vertices[edge.to] - from;
    const double squared_length = along.squaredNorm();
    for (int v = 0; v < n; ++v) {
      if (v == edge.from || v == edge.to) continue;
      const Eigen::Vector3d offset = solid.vertices[v] - from;
      const double share = offset.dot(along) / squared_length;
      if (share <= 0.0 || share >= 1.0) continue;
      if ((offset - share * along).norm() < resolution) ++validity->near_edges;
    }
  }
}

// The edges are known to pair up. Walks round each vertex from face to face.
void check_vertices(const Solid& solid, const std::vector<DirectedEdge>& edges,
                    SolidValidity* validity) {
  const auto position = [&edges](int from, int to) {
    return static_cast<size_t>(
        std::lower_bound(edges.begin(), edges.end(), DirectedEdge{from, to, 0, 0}) - edges.begin());
  };
  std::vector<bool> seen(edges.size(), false);
  std::vector<int> fans(solid.vertices.size(), 0);
  for (size_t first = 0; first < edges.size(); ++first) {
    if (seen[first]) continue;
    const int vertex = edges[first].to;
    ++fans[vertex];
    // Into the vertex along `e`, out to `after`; the way back in is the next face's edge.
    for (size_t e = first; !seen[e]; e = position(edges[e].after, vertex)) seen[e] = true;
  }
  for (const int count : fans) validity->non_manifold_vertices += count != 1;
}

int count_components(const Solid& solid, const std::vector<DirectedEdge>& edges) {
  std::vector<int> group(solid.faces.size());
  std::iota(group.begin(), group.end(), 0);
  const auto root = [&group](int i) {
    while (group[i] != i) i = group[i] = group[group[i]];
    return i;
  };
  for (const DirectedEdge& edge : edges) {
    const auto back =
        std::lower_bound(edges.begin(), edges.end(), DirectedEdge{edge.to, edge.from, 0, 0});
    if (back != edges.end() && back->from == edge.to && back->to == edge.from) {
      group[root(edge.face)] = root(back->face);
    }
  }
  int components = 0;
  for (size_t f = 0; f < group.size(); ++f)
    components += root(static_cast<int>(f)) == static_cast<int>(f);
  return components;
}

double signed_volume(const Solid& solid) {
  double volume = 0.0;
  for (const Face& face : solid.faces) {
    for (const std::vector<int>& ring : face.rings) {
      volume += ring_normal(solid, ring).dot(solid.vertices[ring[0]] - solid.vertices[0]) / 6.0;
    }
  }
  return volume;
}

}  // namespace

bool SolidValidity::valid() const {
  return bad_rings == 0 && near_vertices == 0 && near_edges == 0 && crossing_rings == 0 &&
         misplaced_holes == 0 && non_planar_faces == 0 && open_edges == 0 &&
         non_manifold_edges == 0 && non_manifold_vertices == 0 && misfacing == 0 &&
         components == 1 && volume > 0.0;
}

std::string SolidValidity::describe() const {
  if (valid()) return "valid";
  std::string text;
  const auto name = [&text](int count, const char* what) {
    if (count == 0) return;
    text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + what;
  };
  name(bad_rings, "bad rings");
  name(near_vertices, "pairs of vertices too near");
  name(near_edges, "vertices too near an edge");
  name(crossing_rings, "faces whose edges cross");
  name(misplaced_holes, "misplaced holes");
  name(non_planar_faces, "faces that are not planar");
  name(open_edges, "open edges");
  name(non_manifold_edges, "edges of more than two faces");
  name(non_manifold_vertices, "non-manifold vertices");
  name(misfacing, "faces that look the wrong way");
  if (components != 1) name(components, "components");
  if (volume <= 0.0) name(1, "shell inside out");
  return text.empty() ? "no components" : text;
}

SolidValidity check_solid(const Solid& solid, const ValidityTolerance& tolerance) {
  SolidValidity validity;
  for (const Face& face : solid.faces) check_face(solid, face, tolerance, &validity);
  const std::vector<DirectedEdge> edges = sorted_edges(solid);
  for (size_t i = 0; i < edges.size(); ++i) {
    const bool repeated = i > 0 && !(edges[i - 1] < edges[i]);
    if (repeated) ++validity.non_manifold_edges;
    const DirectedEdge back = {edges[i].to, edges[i].from, 0, 0};
    if (!std::binary_search(edges.begin(), edges.end(), back)) ++validity.open_edges;
  }
  check_near(solid, edges, tolerance.resolution, &validity);
  validity.components = count_components(solid, edges);
  if (validity.bad_rings == 0) validity.volume = signed_volume(solid);
  if (validity.open_edges == 0 && validity.non_manifold_edges == 0 && validity.bad_rings == 0) {
    check_vertices(solid, edges, &validity);
  }
  return validity;
}

}  // namespace gable
