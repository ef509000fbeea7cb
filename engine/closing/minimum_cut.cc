#include <gable/engine/closing/minimum_cut.h>

#include <algorithm>
#include <limits>

namespace gable {

MinimumCut::MinimumCut(int num_nodes)
    : source_(num_nodes),
      sink_(num_nodes + 1),
      leaving_(num_nodes + 2),
      level_(num_nodes + 2, -1),
      next_(num_nodes + 2, 0) {}

void MinimumCut::link(int from, int to, double capacity) {
  leaving_[from].push_back(static_cast<int>(arcs_.size()));
  arcs_.push_back({to, capacity});
  leaving_[to].push_back(static_cast<int>(arcs_.size()));
  arcs_.push_back({from, 0.0});
}

void MinimumCut::add_terminals(int node, double on_sink_side, double on_source_side) {
  if (on_sink_side > 0.0) link(source_, node, on_sink_side);
  if (on_source_side > 0.0) link(node, sink_, on_source_side);
}

void MinimumCut::add_arc(int from, int to, double capacity) {
  if (capacity > 0.0) link(from, to, capacity);
}

bool MinimumCut::find_levels() {
  std::fill(level_.begin(), level_.end(), -1);
  std::vector<int> queue = {source_};
  level_[source_] = 0;
  for (size_t i = 0; i < queue.size(); ++i) {
    for (const int a : leaving_[queue[i]]) {
      const Arc& arc = arcs_[a];
      if (arc.capacity <= least_ || level_[arc.to] >= 0) continue;
      level_[arc.to] = level_[queue[i]] + 1;
      queue.push_back(arc.to);
    }
  }
  return level_[sink_] >= 0;
}

// One path of arcs that lead a level further each, from the source to the sink.
double MinimumCut::augment() {
  std::vector<int> path;
  int node = source_;
  while (node != sink_) {
    if (next_[node] == leaving_[node].size()) {
      if (path.empty()) return 0.0;
      node = arcs_[path.back() ^ 1].to;
      path.pop_back();
      ++next_[node];
      continue;
    }
    const int a = leaving_[node][next_[node]];
    const Arc& arc = arcs_[a];
    if (arc.capacity > least_ && level_[arc.to] == level_[node] + 1) {
      path.push_back(a);
      node = arc.to;
    } else {
      ++next_[node];
    }
  }
  double flow = std::numeric_limits<double>::infinity();
  for (const int a : path) flow = std::min(flow, arcs_[a].capacity);
  for (const int a : path) {
    arcs_[a].capacity -= flow;
    arcs_[a ^ 1].capacity += flow;
  }
  return flow;
}

double MinimumCut::solve() {
  double largest = 0.0;
  for (const Arc& arc : arcs_) largest = std::max(largest, arc.capacity);
  least_ = 1e-14 * largest;
  double total = 0.0;
  while (find_levels()) {
    std::fill(next_.begin(), next_.end(), 0);
    while (const double flow = augment()) total += flow;
  }
  return total;
}

}  // namespace gable
