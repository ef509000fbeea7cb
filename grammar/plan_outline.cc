#include <gable/grammar/block.h>
#include <gable/grammar/height_field.h>
#include <gable/grammar/plan_outline.h>
#include <gable/grammar/ring.h>

#include <algorithm>
#include <map>
#include <utility>

namespace gable {
namespace {

constexpr double kSame = 1e-6;

using Node = std::pair<int, int>;  // indices into the sorted x and y

std::vector<double> sorted_coordinates(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  std::vector<double> distinct;
  for (double v : values) {
    if (distinct.empty() || v - distinct.back() > kSame) distinct.push_back(v);
  }
  return distinct;
}

int index_of(const std::vector<double>& coordinates, double value) {
  const auto it = std::upper_bound(coordinates.begin(), coordinates.end(), value + 0.5 * kSame);
  return static_cast<int>(it - coordinates.begin()) - 1;
}

/// The plane cut along all edges of the blocks; a cell is covered or not.
struct Cells {
  std::vector<double> x, y;
  std::vector<bool> covered;

  explicit Cells(const std::vector<Block<double>>& blocks) {
    using namespace block_value;
    for (const auto& block : blocks) {
      x.insert(x.end(), {block[kX0], block[kX1]});
      y.insert(y.end(), {block[kY0], block[kY1]});
    }
    x = sorted_coordinates(x);
    y = sorted_coordinates(y);
    covered.assign(x.size() * y.size(), false);
    for (const auto& block : blocks) {
      for (int i = index_of(x, block[kX0]); i < index_of(x, block[kX1]); ++i) {
        for (int j = index_of(y, block[kY0]); j < index_of(y, block[kY1]); ++j) {
          covered[i * y.size() + j] = true;
        }
      }
    }
  }
  bool at(int i, int j) const {
    const int nx = static_cast<int>(x.size()), ny = static_cast<int>(y.size());
    return i >= 0 && j >= 0 && i < nx && j < ny && covered[i * ny + j];
  }
};

/// Directed edges with the covered cell to their left, by start node.
std::multimap<Node, Node> boundary_edges(const Cells& cells) {
  std::multimap<Node, Node> edges;
  for (int i = 0; i < static_cast<int>(cells.x.size()); ++i) {
    for (int j = 0; j < static_cast<int>(cells.y.size()); ++j) {
      if (!cells.at(i, j)) continue;
      if (!cells.at(i, j - 1)) edges.insert({{i, j}, {i + 1, j}});
      if (!cells.at(i + 1, j)) edges.insert({{i + 1, j}, {i + 1, j + 1}});
      if (!cells.at(i, j + 1)) edges.insert({{i + 1, j + 1}, {i, j + 1}});
      if (!cells.at(i - 1, j)) edges.insert({{i, j + 1}, {i, j}});
    }
  }
  return edges;
}

int turn(const Node& a, const Node& b, const Node& c) {
  return (b.first - a.first) * (c.second - b.second) - (b.second - a.second) * (c.first - b.first);
}

/// Takes one closed ring out of the edges. Where two cells meet at a node only, the ring turns
/// left, which keeps them separate rings.
std::vector<Node> take_ring(std::multimap<Node, Node>* edges) {
  const Node start = edges->begin()->first;
  std::vector<Node> ring = {start, edges->begin()->second};
  edges->erase(edges->begin());
  while (ring.back() != start) {
    const Node from = ring[ring.size() - 2];
    const auto [first, last] = edges->equal_range(ring.back());
    auto best = first;
    for (auto it = first; it != last; ++it) {
      if (turn(from, ring.back(), it->second) > turn(from, ring.back(), best->second)) best = it;
    }
    ring.push_back(best->second);
    edges->erase(best);
  }
  ring.pop_back();
  std::vector<Node> corners;
  for (size_t k = 0; k < ring.size(); ++k) {
    const Node& before = ring[(k + ring.size() - 1) % ring.size()];
    if (turn(before, ring[k], ring[(k + 1) % ring.size()]) != 0) corners.push_back(ring[k]);
  }
  return corners;
}

}  // namespace

std::vector<PlanPolygon> plan_outline(const House& house) {
  const HeightField field(house);
  std::vector<Block<double>> blocks;
  for (size_t i = 0; i < field.blocks().size(); ++i) {
    if (!stands_on_roof(field.sources()[i].role)) blocks.push_back(field.blocks()[i]);
  }
  const Cells cells(blocks);
  auto edges = boundary_edges(cells);
  std::vector<PlanPolygon> polygons;
  std::vector<std::vector<Eigen::Vector2d>> holes;
  while (!edges.empty()) {
    std::vector<Eigen::Vector2d> ring;
    for (const Node& node : take_ring(&edges))
      ring.push_back({cells.x[node.first], cells.y[node.second]});
    if (signed_area(ring) > 0.0) {
      polygons.push_back({ring, {}});
    } else {
      holes.push_back(ring);
    }
  }
  for (const auto& hole : holes) {
    // A point beside the first edge, outside the hole's void: on the covered side.
    const Eigen::Vector2d along = hole[1] - hole[0];
    const Eigen::Vector2d left = Eigen::Vector2d(-along.y(), along.x()).normalized() * kSame;
    const Eigen::Vector2d beside = 0.5 * (hole[0] + hole[1]) + 0.5 * left;
    for (PlanPolygon& polygon : polygons) {
      if (ring_holds(polygon.outer, beside)) polygon.holes.push_back(hole);
    }
  }
  for (PlanPolygon& polygon : polygons) {
    for (Eigen::Vector2d& p : polygon.outer) p = field.local_from_house(p);
    for (auto& hole : polygon.holes) {
      for (Eigen::Vector2d& p : hole) p = field.local_from_house(p);
    }
  }
  return polygons;
}

}  // namespace gable
