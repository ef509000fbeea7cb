#include <gable/engine/reconstruct/neighbours/neighbour_groups.h>

#include <algorithm>
#include <set>

namespace gable {
namespace {

using Graph = std::vector<std::set<int>>;

/// Breadth first from `start`; marks what it visits.
std::vector<int> walk(const Graph& graph, int start, std::vector<char>* visited) {
  std::vector<int> order = {start};
  (*visited)[start] = 1;
  for (size_t i = 0; i < order.size(); ++i) {
    for (int next : graph[order[i]]) {
      if ((*visited)[next]) continue;
      (*visited)[next] = 1;
      order.push_back(next);
    }
  }
  return order;
}

}  // namespace

std::vector<std::vector<int>> neighbour_groups(int num_houses,
                                               const std::vector<NeighbourRelation>& relations,
                                               int most) {
  Graph graph(num_houses);
  for (const NeighbourRelation& relation : relations) {
    if (relation.kind != NeighbourRelationKind::kPartyWall) continue;
    graph[relation.house_a].insert(relation.house_b);
    graph[relation.house_b].insert(relation.house_a);
  }
  std::vector<std::vector<int>> groups;
  std::vector<char> seen(num_houses, 0), visited(num_houses, 0);
  for (int first = 0; first < num_houses; ++first) {
    if (seen[first] || graph[first].empty()) continue;
    std::vector<int> group = walk(graph, first, &seen);
    const int start = *std::min_element(group.begin(), group.end(), [&](int a, int b) {
      return graph[a].size() != graph[b].size() ? graph[a].size() < graph[b].size() : a < b;
    });
    group = walk(graph, start, &visited);
    for (size_t from = 0; from < group.size(); from += static_cast<size_t>(most)) {
      const size_t to = std::min(group.size(), from + static_cast<size_t>(most));
      if (to - from > 1) groups.emplace_back(group.begin() + from, group.begin() + to);
    }
  }
  return groups;
}

}  // namespace gable
