#pragma once

#include <gable/engine/reconstruct/heights/rectified_view.h>

#include <vector>

namespace gable {

/// Where block edges may lie: cell boundaries of a rectified view, ascending.
struct EdgeLines {
  std::vector<int> columns;  ///< boundary c lies left of column c
  std::vector<int> rows;     ///< boundary r lies below row r
};

/// How edge lines are picked.
struct EdgeLineOptions {
  int max_lines = 9;        ///< per axis, [2, 20]
  double separation = 1.2;  ///< least distance of two lines, metres, > 0
  double widest_gap = 3.5;  ///< larger gaps between lines get lines of their own, metres, > 0
};

/// Picks lines where many cells along the line show a step in height (walls, steps between blocks),
/// the outermost ones around the mask among them, and fills wide gaps: the refinement captures an
/// edge from about 1.5 m away.
EdgeLines find_edge_lines(const RectifiedView& view, const EdgeLineOptions& options);

}  // namespace gable
