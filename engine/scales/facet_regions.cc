#include <gable/engine/scales/absorb_small_shapes.h>
#include <gable/engine/scales/facet_regions.h>
#include <gable/engine/scales/mesh_noise.h>
#include <gable/engine/scales/shape_plane.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <queue>

namespace gable {
namespace {

constexpr int kSmoothingRounds = 5;

struct MeshView {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double diagonal = 0.0;
  std::vector<int> place_of;  ///< per point: the lowest point at the same place
};

MeshView view_of(const std::vector<Eigen::Vector3d>& points) {
  MeshView view;
  Eigen::Vector3d low = points.front(), high = points.front();
  for (const Eigen::Vector3d& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  view.centre = 0.5 * (low + high);
  view.diagonal = (high - low).norm();
  std::vector<int> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  const auto key = [&](int i) { return std::array{points[i].x(), points[i].y(), points[i].z()}; };
  std::sort(order.begin(), order.end(),
            [&](int a, int b) { return key(a) != key(b) ? key(a) < key(b) : a < b; });
  view.place_of.resize(points.size());
  for (size_t i = 0; i < order.size(); ++i) {
    const bool same = i > 0 && key(order[i]) == key(order[i - 1]);
    view.place_of[order[i]] = same ? view.place_of[order[i - 1]] : order[i];
  }
  return view;
}

// A facet as its area and the exact second moments of its surface.
struct FacetPlane {
  PointMoments moments;
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< zero for a facet without area
};

FacetPlane facet_plane(const Scan& scan, const MeshView& view, size_t facet) {
  const std::span<const int> corners = scan.facets[facet];
  const auto corner = [&](size_t i) -> Eigen::Vector3d {
    return scan.points[corners[i]] - view.centre;
  };
  FacetPlane out;
  Eigen::Vector3d area_vector = Eigen::Vector3d::Zero();
  for (size_t i = 1; i + 1 < corners.size(); ++i) {
    const Eigen::Vector3d a = corner(0), b = corner(i), c = corner(i + 1);
    area_vector += 0.5 * (b - a).cross(c - a);
    out.moments += triangle_moments(a, b, c, Eigen::Vector3d::Zero());
  }
  // Below this share of the box squared, a normal is rounding.
  if (area_vector.norm() > 1e-14 * view.diagonal * view.diagonal) {
    out.normal = area_vector.normalized();
  }
  return out;
}

// Facets over each edge, as a list of (edge, facet) sorted by edge.
struct EdgeUse {
  int a, b, facet;
  auto operator<=>(const EdgeUse&) const = default;
};

// Pairs of facets that share an edge; all pairs in a row around an edge of more than two.
std::vector<std::pair<int, int>> facet_pairs(const Scan& scan, const MeshView& view) {
  std::vector<EdgeUse> uses;
  for (size_t f = 0; f < scan.facets.size(); ++f) {
    const std::span<const int> corners = scan.facets[f];
    for (size_t i = 0; i < corners.size(); ++i) {
      const int a = view.place_of[corners[i]];
      const int b = view.place_of[corners[(i + 1) % corners.size()]];
      if (a != b) uses.push_back({std::min(a, b), std::max(a, b), static_cast<int>(f)});
    }
  }
  std::sort(uses.begin(), uses.end());
  std::vector<std::pair<int, int>> pairs;
  for (size_t i = 1; i < uses.size(); ++i) {
    const EdgeUse &previous = uses[i - 1], &use = uses[i];
    if (previous.a == use.a && previous.b == use.b && previous.facet != use.facet) {
      pairs.push_back({previous.facet, use.facet});
    }
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

// The facets across the edges of each facet.
class FacetNeighbours {
 public:
  FacetNeighbours(size_t num_facets, const std::vector<std::pair<int, int>>& pairs)
      : begins_(num_facets + 1, 0), facets_(2 * pairs.size()) {
    for (const auto& [a, b] : pairs) ++begins_[a + 1], ++begins_[b + 1];
    std::partial_sum(begins_.begin(), begins_.end(), begins_.begin());
    std::vector<size_t> next(begins_.begin(), begins_.end() - 1);
    for (const auto& [a, b] : pairs) facets_[next[a]++] = b, facets_[next[b]++] = a;
  }
  std::span<const int> of(int facet) const {
    return std::span(facets_).subspan(begins_[facet], begins_[facet + 1] - begins_[facet]);
  }

 private:
  std::vector<size_t> begins_;
  std::vector<int> facets_;
};

// Normals of facets as means over those around, so that noise in the vertices averages out.
void smooth_normals(const FacetNeighbours& neighbours, std::vector<FacetPlane>* planes) {
  for (int round = 0; round < kSmoothingRounds; ++round) {
    const std::vector<FacetPlane> before = *planes;
    for (size_t f = 0; f < before.size(); ++f) {
      const Eigen::Vector3d& own = before[f].normal;
      Eigen::Vector3d sum = before[f].moments.weight * own;
      for (int other : neighbours.of(static_cast<int>(f))) {
        const Eigen::Vector3d& normal = before[other].normal;
        // Facets need not be oriented alike.
        sum += (normal.dot(own) < 0.0 ? -1.0 : 1.0) * before[other].moments.weight * normal;
      }
      if (!own.isZero() && !sum.isZero()) (*planes)[f].normal = sum.normalized();
    }
  }
}

}  // namespace

FirstShapes grow_facet_regions(const Scan& scan, const FirstShapesOptions& options) {
  FirstShapes first;
  const int n = static_cast<int>(scan.facets.size());
  first.shape_of.assign(n, -1);
  const MeshView view = view_of(scan.points);
  first.diagonal = view.diagonal;
  const double least_epsilon = options.epsilon_percent / 100.0 * view.diagonal;
  const double noise = options.epsilon_percent > 0.0 ? mesh_noise(scan) : 0.0;
  const bool noisy = options.epsilon_deviations * noise > least_epsilon;
  const double epsilon = noisy ? options.epsilon_deviations * noise : least_epsilon;
  const double min_cosine = std::cos(options.max_angle);

  std::vector<FacetPlane> planes;
  for (int f = 0; f < n; ++f) planes.push_back(facet_plane(scan, view, f));
  const std::vector<std::pair<int, int>> pairs = facet_pairs(scan, view);
  const FacetNeighbours neighbours(n, pairs);
  if (noisy) smooth_normals(neighbours, &planes);
  std::vector<int> order(n);
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
    return planes[a].moments.weight > planes[b].moments.weight;
  });

  std::vector<int>& shape_of = first.shape_of;
  for (int seed : order) {
    if (shape_of[seed] >= 0 || planes[seed].normal.isZero()) continue;
    const int shape = static_cast<int>(first.moments.size());
    shape_of[seed] = shape;
    PointMoments moments = planes[seed].moments;
    ShapePlane plane{moments.centroid(), planes[seed].normal};
    double next_fit = 1.25 * moments.weight;
    std::queue<int> front({seed});
    while (epsilon > 0.0 && !front.empty()) {
      for (int f : neighbours.of(front.front())) {
        if (shape_of[f] >= 0 || std::abs(planes[f].normal.dot(plane.normal)) < min_cosine) continue;
        bool near = true;
        for (int corner : scan.facets[f]) {
          const Eigen::Vector3d p = scan.points[corner] - view.centre - plane.centroid;
          near = near && std::abs(plane.normal.dot(p)) <= epsilon;
        }
        if (!near) continue;
        shape_of[f] = shape;
        moments += planes[f].moments;
        front.push(f);
        if (moments.weight >= next_fit) {
          plane = shape_plane(moments);
          next_fit = 1.25 * moments.weight;
        }
      }
      front.pop();
    }
    first.moments.push_back(moments);
  }
  for (const auto& [a, b] : pairs) {
    const int sa = shape_of[a], sb = shape_of[b];
    if (sa >= 0 && sb >= 0 && sa != sb) first.adjacent.push_back(std::minmax(sa, sb));
  }
  std::sort(first.adjacent.begin(), first.adjacent.end());
  first.adjacent.erase(std::unique(first.adjacent.begin(), first.adjacent.end()),
                       first.adjacent.end());
  if (noisy) absorb_small_shapes(options.min_inliers, &first);
  return first;
}

}  // namespace gable
