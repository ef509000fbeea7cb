#include <gable/engine/closing/roof_defects.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace gable {
namespace {

// Planes that meet at a corner do so to this, metres, and neighbouring sectors to this, radians.
constexpr double kSameHeight = 1e-4;
constexpr double kSameAngle = 1e-9;

/// A sorting of things into square cells of the plan.
class Buckets {
 public:
  explicit Buckets(double size) : size_(size) {}

  void add(int number, const Eigen::Vector2d& low, const Eigen::Vector2d& high) {
    for_cells(low, high, [&](const Key& key) { cells_[key].push_back(number); });
  }
  std::vector<int> near(const Eigen::Vector2d& p, double distance) const {
    const Eigen::Vector2d around = Eigen::Vector2d::Constant(distance);
    std::vector<int> found;
    for_cells(p - around, p + around, [&](const Key& key) {
      const auto cell = cells_.find(key);
      if (cell != cells_.end()) {
        found.insert(found.end(), cell->second.begin(), cell->second.end());
      }
    });
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }

 private:
  using Key = std::pair<int, int>;

  template <typename Visit>
  void for_cells(const Eigen::Vector2d& low, const Eigen::Vector2d& high, Visit visit) const {
    const auto cell = [this](double at) { return static_cast<int>(std::floor(at / size_)); };
    for (int x = cell(low.x()); x <= cell(high.x()); ++x) {
      for (int y = cell(low.y()); y <= cell(high.y()); ++y) visit(Key{x, y});
    }
  }

  double size_;
  std::map<Key, std::vector<int>> cells_;
};

struct Edge {
  int from, to;
};

/// A region at one of its corners: between the ways to the next corner and to the one before.
struct Sector {
  int plane, region;
  double begin, width;  // angle of the first way, and that turned to the second
};

/// The corners and edges of all regions, each place once.
struct Corners {
  std::vector<Eigen::Vector2d> places;
  std::vector<std::vector<Sector>> sectors;
  std::vector<Edge> edges;
};

double angle_of(const Eigen::Vector2d& v) { return std::atan2(v.y(), v.x()); }

/// An angle turned into [0, 2 pi).
double turned(double angle) { return angle < 0.0 ? angle + 2.0 * M_PI : angle; }

Corners corners_of(const RoofPartition& roof) {
  Corners corners;
  std::map<std::pair<double, double>, int> number;
  const auto add_ring = [&](const std::vector<Eigen::Vector2d>& ring, int region) {
    std::vector<int> own;
    for (const Eigen::Vector2d& p : ring) {
      const auto [at, is_new] =
          number.try_emplace({p.x(), p.y()}, static_cast<int>(corners.places.size()));
      if (is_new) {
        corners.places.push_back(p);
        corners.sectors.emplace_back();
      }
      own.push_back(at->second);
    }
    const size_t n = ring.size();
    for (size_t i = 0; i < n; ++i) {
      corners.edges.push_back({own[i], own[(i + 1) % n]});
      const double begin = angle_of(ring[(i + 1) % n] - ring[i]);
      const double end = angle_of(ring[(i + n - 1) % n] - ring[i]);
      corners.sectors[own[i]].push_back(
          {roof.regions[region].plane, region, begin, turned(end - begin)});
    }
  };
  for (size_t r = 0; r < roof.regions.size(); ++r) {
    add_ring(roof.regions[r].polygon.outer, static_cast<int>(r));
    for (const auto& hole : roof.regions[r].polygon.holes) add_ring(hole, static_cast<int>(r));
  }
  return corners;
}

/// The planes that are at nearly but not quite the height of another one at a corner.
std::vector<int> nearly_level(const RoofPartition& roof, const Eigen::Vector2d& p,
                              const std::vector<Sector>& sectors, double least) {
  std::vector<std::pair<double, int>> heights;
  double slope = 0.0;
  for (const Sector& sector : sectors) {
    const Plane& plane = roof.planes[sector.plane];
    heights.emplace_back(plane.at(p), sector.plane);
    slope = std::max(slope, std::hypot(plane.a, plane.b));
  }
  std::sort(heights.begin(), heights.end());
  // Edges that go up from one height pass the next one by less than what lies between.
  const double apart = least * std::hypot(1.0, slope);
  std::vector<int> found;
  for (size_t i = 1; i < heights.size(); ++i) {
    const double step = heights[i].first - heights[i - 1].first;
    if (step <= kSameHeight || step >= apart) continue;
    found.push_back(heights[i - 1].second);
    found.push_back(heights[i].second);
  }
  return found;
}

/// The sectors around a corner, anticlockwise, with what is outside between them.
std::vector<RoofSector> around(std::vector<Sector> sectors) {
  std::sort(sectors.begin(), sectors.end(),
            [](const Sector& a, const Sector& b) { return a.begin < b.begin; });
  std::vector<RoofSector> result;
  const auto add = [&](int plane, double begin, double width) {
    const double middle = begin + 0.5 * width;
    result.push_back({{std::cos(middle), std::sin(middle)}, plane});
  };
  for (size_t i = 0; i < sectors.size(); ++i) {
    const Sector &own = sectors[i], &next = sectors[(i + 1) % sectors.size()];
    add(own.plane, own.begin, own.width);
    const double gap = turned(next.begin - own.begin) - own.width;
    const bool alone = sectors.size() == 1;
    if (alone || gap > kSameAngle) {
      add(-1, own.begin + own.width, alone ? 2.0 * M_PI - own.width : gap);
    }
  }
  return result;
}

/// Whether a region has more than one sector at a corner.
bool touches_itself(const std::vector<Sector>& sectors) {
  std::vector<int> regions;
  for (const Sector& sector : sectors) regions.push_back(sector.region);
  std::sort(regions.begin(), regions.end());
  return std::adjacent_find(regions.begin(), regions.end()) != regions.end();
}

/// Whether heights rise and fall more than once around a corner.
bool is_saddle(const RoofPartition& roof, const Eigen::Vector2d& p,
               const std::vector<RoofSector>& sectors) {
  std::vector<double> heights;
  for (const RoofSector& sector : sectors) {
    const double z = sector.plane < 0 ? -std::numeric_limits<double>::infinity()
                                      : roof.planes[sector.plane].at(p);
    if (heights.empty() || !(std::abs(z - heights.back()) <= kSameHeight || z == heights.back())) {
      heights.push_back(z);
    }
  }
  while (heights.size() > 1 && (std::abs(heights.front() - heights.back()) <= kSameHeight ||
                                heights.front() == heights.back())) {
    heights.pop_back();
  }
  const size_t n = heights.size();
  int peaks = 0;
  for (size_t i = 0; i < n; ++i) {
    peaks += heights[i] > heights[(i + n - 1) % n] && heights[i] > heights[(i + 1) % n];
  }
  return peaks > 1;
}

}  // namespace

RoofDefects find_roof_defects(const RoofPartition& roof, double least) {
  const Corners corners = corners_of(roof);
  Buckets places(1.0), edges(1.0);
  for (size_t i = 0; i < corners.places.size(); ++i) {
    places.add(static_cast<int>(i), corners.places[i], corners.places[i]);
  }
  for (size_t e = 0; e < corners.edges.size(); ++e) {
    const Eigen::Vector2d &p = corners.places[corners.edges[e].from],
                          &q = corners.places[corners.edges[e].to];
    edges.add(static_cast<int>(e), p.cwiseMin(q), p.cwiseMax(q));
  }
  RoofDefects defects;
  for (size_t i = 0; i < corners.places.size(); ++i) {
    const Eigen::Vector2d& p = corners.places[i];
    if (std::vector<int> level = nearly_level(roof, p, corners.sectors[i], least); !level.empty()) {
      defects.crowded.push_back({p, std::move(level)});
      continue;
    }
    bool apart = true;
    for (const int j : places.near(p, least)) {
      apart = apart && (j == static_cast<int>(i) || (corners.places[j] - p).norm() >= least);
    }
    for (const int e : edges.near(p, least)) {
      if (!apart) break;
      const auto [from, to] = corners.edges[e];
      if (from == static_cast<int>(i) || to == static_cast<int>(i)) continue;
      const Eigen::Vector2d along = corners.places[to] - corners.places[from];
      const double square = along.squaredNorm();
      const double t = std::clamp((p - corners.places[from]).dot(along) / square, 0.0, 1.0);
      apart = (p - corners.places[from] - t * along).norm() >= least;
    }
    if (!apart) {
      defects.crowded.push_back({p, {}});
      continue;
    }
    std::vector<RoofSector> sectors = around(corners.sectors[i]);
    if (touches_itself(corners.sectors[i]) || is_saddle(roof, p, sectors))
      defects.saddles.push_back({p, std::move(sectors)});
  }
  return defects;
}

}  // namespace gable
