#include <gable/grammar/solid/surface_mesh.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace gable {
namespace {

constexpr double kStraight = 1e-4;  // metres off the line through the neighbours

struct DirectedEdge {
  int from, to, piece;
  bool operator<(const DirectedEdge& other) const {
    return from != other.from ? from < other.from : to < other.to;
  }
};

using Edges = std::vector<DirectedEdge>;

Edges sorted_edges(const std::vector<SurfacePiece>& pieces) {
  Edges edges;
  for (size_t p = 0; p < pieces.size(); ++p) {
    for (const std::vector<int>& ring : pieces[p].rings) {
      for (size_t i = 0; i < ring.size(); ++i) {
        edges.push_back({ring[i], ring[(i + 1) % ring.size()], static_cast<int>(p)});
      }
    }
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

// The piece on the other side of an edge, or -1.
int piece_across(const Edges& edges, const DirectedEdge& edge) {
  const DirectedEdge back = {edge.to, edge.from, 0};
  const auto found = std::lower_bound(edges.begin(), edges.end(), back);
  return found != edges.end() && !(back < *found) ? found->piece : -1;
}

bool is_manifold(const Edges& edges) {
  for (size_t i = 0; i < edges.size(); ++i) {
    if (i > 0 && !(edges[i - 1] < edges[i])) return false;
    if (piece_across(edges, edges[i]) < 0) return false;
  }
  return true;
}

Eigen::Vector3d ring_normal(const std::vector<Eigen::Vector3d>& vertices,
                            const std::vector<int>& ring) {
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  for (size_t i = 1; i + 1 < ring.size(); ++i) {
    normal +=
        (vertices[ring[i]] - vertices[ring[0]]).cross(vertices[ring[i + 1]] - vertices[ring[0]]);
  }
  return normal;
}

// Joins the group's outer edges into rings, the outer ring first. False where the group touches
// itself in a vertex.
bool join_boundary(const std::vector<Eigen::Vector3d>& vertices, Edges boundary,
                   std::vector<std::vector<int>>* rings) {
  std::sort(boundary.begin(), boundary.end());
  for (size_t i = 1; i < boundary.size(); ++i) {
    if (boundary[i - 1].from == boundary[i].from) return false;
  }
  std::vector<bool> used(boundary.size(), false);
  Eigen::Vector3d total = Eigen::Vector3d::Zero();
  for (size_t first = 0; first < boundary.size(); ++first) {
    if (used[first]) continue;
    std::vector<int> ring;
    for (size_t i = first; !used[i];) {
      used[i] = true;
      ring.push_back(boundary[i].from);
      const int to = boundary[i].to;
      i = static_cast<size_t>(
          std::lower_bound(boundary.begin(), boundary.end(), to,
                           [](const DirectedEdge& e, int v) { return e.from < v; }) -
          boundary.begin());
    }
    total += ring_normal(vertices, ring);
    rings->push_back(std::move(ring));
  }
  const auto is_outer = [&](const std::vector<int>& ring) {
    return ring_normal(vertices, ring).dot(total) > 0.0;
  };
  const auto outer_end = std::stable_partition(rings->begin(), rings->end(), is_outer);
  return outer_end - rings->begin() == 1;
}

std::vector<Face> merged_faces(const SurfaceMesh& mesh, const Edges& edges) {
  std::vector<int> group(mesh.pieces.size());
  std::iota(group.begin(), group.end(), 0);
  const auto root = [&group](int i) {
    while (group[i] != i) i = group[i] = group[group[i]];
    return i;
  };
  for (const DirectedEdge& edge : edges) {
    const int across = piece_across(edges, edge);
    const SurfacePiece& piece = mesh.pieces[edge.piece];
    if (piece.type != mesh.pieces[across].type || piece.surface != mesh.pieces[across].surface) {
      continue;
    }
    const auto [first, second] = std::minmax({root(edge.piece), root(across)});
    group[second] = first;
  }
  std::vector<Edges> boundary(mesh.pieces.size());
  for (const DirectedEdge& edge : edges) {
    if (root(edge.piece) != root(piece_across(edges, edge))) {
      boundary[root(edge.piece)].push_back(edge);
    }
  }
  std::vector<Face> faces;
  for (size_t p = 0; p < mesh.pieces.size(); ++p) {
    if (boundary[p].empty()) continue;
    Face face;
    face.type = mesh.pieces[p].type;
    if (join_boundary(mesh.vertices, boundary[p], &face.rings)) {
      faces.push_back(std::move(face));
      continue;
    }
    for (size_t q = p; q < mesh.pieces.size(); ++q) {
      if (root(static_cast<int>(q)) == static_cast<int>(p)) {
        faces.push_back({mesh.pieces[q].rings, mesh.pieces[q].type});
      }
    }
  }
  return faces;
}

// Marks vertices with two neighbours on a straight line with them, and unused ones.
std::vector<bool> needless_vertices(const std::vector<Eigen::Vector3d>& vertices,
                                    const std::vector<Face>& faces) {
  std::vector<std::vector<int>> neighbours(vertices.size());
  for (const Face& face : faces) {
    for (const std::vector<int>& ring : face.rings) {
      for (size_t i = 0; i < ring.size(); ++i) {
        neighbours[ring[i]].push_back(ring[(i + 1) % ring.size()]);
      }
    }
  }
  std::vector<bool> needless(vertices.size(), true);
  for (size_t v = 0; v < vertices.size(); ++v) {
    if (neighbours[v].empty()) continue;
    // In a closed boundary every edge at v leaves it once.
    if (neighbours[v].size() == 2) {
      const Eigen::Vector3d& a = vertices[neighbours[v][0]];
      const Eigen::Vector3d& b = vertices[neighbours[v][1]];
      const Eigen::Vector3d along = (b - a).normalized();
      const bool between = (vertices[v] - a).dot(along) > 0.0 && (b - vertices[v]).dot(along) > 0.0;
      if (between && (vertices[v] - a).cross(along).norm() < kStraight) continue;
    }
    needless[v] = false;
  }
  return needless;
}

}  // namespace

std::optional<Solid> merge_pieces(const SurfaceMesh& mesh) {
  const Edges edges = sorted_edges(mesh.pieces);
  if (!is_manifold(edges)) return std::nullopt;
  Solid solid;
  solid.faces = merged_faces(mesh, edges);
  const std::vector<bool> needless = needless_vertices(mesh.vertices, solid.faces);
  std::vector<int> number(mesh.vertices.size(), -1);
  for (size_t v = 0; v < mesh.vertices.size(); ++v) {
    if (needless[v]) continue;
    number[v] = static_cast<int>(solid.vertices.size());
    solid.vertices.push_back(mesh.vertices[v]);
  }
  for (Face& face : solid.faces) {
    for (std::vector<int>& ring : face.rings) {
      std::erase_if(ring, [&needless](int v) { return needless[v]; });
      for (int& v : ring) v = number[v];
    }
  }
  return solid;
}

}  // namespace gable
