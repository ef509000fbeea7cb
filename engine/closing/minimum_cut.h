#pragma once

#include <cstddef>
#include <vector>

namespace gable {

/// A network with a source and a sink, and the cut of least capacity between them (Dinic 1970:
/// shortest augmenting paths, all of one length at a time).
class MinimumCut {
 public:
  explicit MinimumCut(int num_nodes);

  /// What the cut pays where the node is on the sink's side, and where it is on the source's; >= 0.
  void add_terminals(int node, double on_sink_side, double on_source_side);
  /// What the cut pays where `from` is on the source's side and `to` on the sink's; >= 0.
  void add_arc(int from, int to, double capacity);

  /// Finds the cut, once; returns its capacity.
  double solve();
  /// After `solve`: whether a node can still be reached from the source. Nodes that may as well be
  /// on either side are on the sink's.
  bool on_source_side(int node) const { return level_[node] >= 0; }

 private:
  struct Arc {
    int to;
    double capacity;
  };

  void link(int from, int to, double capacity);
  bool find_levels();
  double augment();

  int source_, sink_;
  std::vector<Arc> arcs_;  // 2 k and its reverse 2 k + 1
  std::vector<std::vector<int>> leaving_;
  std::vector<int> level_;
  std::vector<std::size_t> next_;  // of the leaving arcs, per node
  double least_ = 0.0;             // capacities below this count as used up
};

}  // namespace gable
