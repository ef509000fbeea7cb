#include <gable/engine/reconstruct/first_values/block_search.h>
#include <gable/engine/reconstruct/first_values/edge_lines.h>
#include <gable/engine/reconstruct/first_values/roof_fit.h>
#include <gable/grammar/wing_polygons.h>
#include <gable/residuals/robust_loss.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace gable {
namespace {

// Indices of rectangles; unused entries are -1.
using Selection = std::array<int, 3>;

struct Scored {
  Selection blocks{-1, -1, -1};
  double gain = 0.0;
};

CellRectangle overlap(const CellRectangle& a, const CellRectangle& b) {
  return {std::max(a.col0, b.col0), std::min(a.col1, b.col1), std::max(a.row0, b.row0),
          std::min(a.row1, b.row1)};
}

bool empty(const CellRectangle& r) { return r.col0 >= r.col1 || r.row0 >= r.row1; }

// The roof and gain of a fitted rectangle at a cell of the view.
size_t cell_in(const RoofFit& fit, int row, int col) {
  return static_cast<size_t>(row - fit.rectangle.row0) * fit.rectangle.cols() +
         (col - fit.rectangle.col0);
}

bool covers(const RoofFit& fit, int row, int col) {
  return col >= fit.rectangle.col0 && col < fit.rectangle.col1 && row >= fit.rectangle.row0 &&
         row < fit.rectangle.row1;
}

// Gain of a set of blocks under their upper envelope: each block's own gain, less what overlaps
// count twice or show another block.
double envelope_gain(const std::vector<RoofFit>& fits, const Selection& blocks) {
  double gain = 0.0;
  for (size_t n = 0; n < blocks.size() && blocks[n] >= 0; ++n) {
    const RoofFit& fit = fits[blocks[n]];
    gain += fit.gain;
    // Cells of this block that earlier ones cover, each visited once.
    for (size_t e = 0; e < n; ++e) {
      const CellRectangle shared = overlap(fit.rectangle, fits[blocks[e]].rectangle);
      if (empty(shared)) continue;
      // Large overlaps are sampled: gains rank sets, nothing else.
      const int cells = shared.cols() * shared.rows();
      const int step = cells > 100 ? 2 : 1;
      const double share = static_cast<double>(cells) / (((shared.cols() + step - 1) / step) *
                                                         ((shared.rows() + step - 1) / step));
      for (int row = shared.row0; row < shared.row1; row += step) {
        for (int col = shared.col0; col < shared.col1; col += step) {
          // What the earlier blocks alone show here.
          int top = blocks[e];
          bool first = true;
          for (size_t o = 0; o < n; ++o) {
            if (o == e || !covers(fits[blocks[o]], row, col)) continue;
            if (o < e) first = false;
            const RoofFit& other = fits[blocks[o]];
            if (other.heights[cell_in(other, row, col)] >
                fits[top].heights[cell_in(fits[top], row, col)]) {
              top = blocks[o];
            }
          }
          if (!first) continue;
          const size_t mine = cell_in(fit, row, col), theirs = cell_in(fits[top], row, col);
          gain -= share * (fit.heights[mine] > fits[top].heights[theirs] ? fits[top].gains[theirs]
                                                                         : fit.gains[mine]);
        }
      }
    }
  }
  return gain;
}

// Which end of base's range the wing shares: -1 the low one, +1 the high one, 0 none.
int shared_end(int base0, int base1, int wing0, int wing1) {
  if (base0 == wing0 && wing1 < base1) return -1;
  if (base1 == wing1 && wing0 > base0) return 1;
  return 0;
}

// A base along x and a wing along y that share an outer corner, in any orientation. side_x, side_y:
// at which end of the base the wing stands, and to which side it goes.
struct LShape {
  bool valid = false;
  int side_x = 0;
  int side_y = 0;
};

LShape l_shape(const CellRectangle& base, const CellRectangle& wing) {
  LShape shape;
  shape.side_x = shared_end(base.col0, base.col1, wing.col0, wing.col1);
  // Seen along y the wing is the longer one; the base's far side is free.
  shape.side_y = -shared_end(wing.row0, wing.row1, base.row0, base.row1);
  shape.valid = shape.side_x != 0 && shape.side_y != 0;
  return shape;
}

// Keeps the best `count`, leaving out those that differ from a better one by edges closer than
// `near` cells.
class BestSet {
 public:
  BestSet(const std::vector<RoofFit>* fits, int count, int near)
      : fits_(fits), count_(count), near_(near) {}

  void add(const Scored& s) {
    if (static_cast<int>(best_.size()) >= pool() && s.gain <= best_.back().gain) return;
    best_.insert(std::upper_bound(best_.begin(), best_.end(), s,
                                  [](const Scored& a, const Scored& b) { return a.gain > b.gain; }),
                 s);
    if (static_cast<int>(best_.size()) > pool()) best_.pop_back();
  }

  std::vector<Scored> distinct() const {
    std::vector<Scored> out;
    for (const Scored& s : best_) {
      if (static_cast<int>(out.size()) >= count_) break;
      if (std::none_of(out.begin(), out.end(), [&](const Scored& o) { return near(o, s); })) {
        out.push_back(s);
      }
    }
    return out;
  }
  const std::vector<Scored>& pooled() const { return best_; }

  // A set of no more gain than this is not kept.
  double least() const {
    return static_cast<int>(best_.size()) < pool() ? -std::numeric_limits<double>::infinity()
                                                   : best_.back().gain;
  }

 private:
  int pool() const { return 12 * count_; }
  bool near(const Scored& a, const Scored& b) const {
    for (size_t i = 0; i < 3; ++i) {
      if (a.blocks[i] < 0) return b.blocks[i] < 0;
      if (b.blocks[i] < 0) return false;
      const RoofFit& p = (*fits_)[a.blocks[i]];
      const RoofFit& q = (*fits_)[b.blocks[i]];
      const auto far = [&](int u, int v) { return std::abs(u - v) > near_; };
      if (far(p.rectangle.col0, q.rectangle.col0) || far(p.rectangle.col1, q.rectangle.col1) ||
          far(p.rectangle.row0, q.rectangle.row0) || far(p.rectangle.row1, q.rectangle.row1)) {
        return false;
      }
      if (p.ridge != q.ridge && !p.flat && !q.flat) return false;
    }
    return true;
  }

  const std::vector<RoofFit>* fits_;
  int count_;
  int near_;
  std::vector<Scored> best_;
};

std::vector<RoofFit> fitted_rectangles(const RectifiedView& view,
                                       const BlockSearchOptions& options) {
  const EdgeLines lines = find_edge_lines(view, {});
  // Inside cells by summed area, to pass over rectangles that are mostly outside the mask.
  std::vector<int> sums(static_cast<size_t>(view.rows + 1) * (view.cols + 1), 0);
  const auto sum_at = [&](int r, int c) -> int& {
    return sums[static_cast<size_t>(r) * (view.cols + 1) + c];
  };
  for (int r = 0; r < view.rows; ++r) {
    for (int c = 0; c < view.cols; ++c) {
      sum_at(r + 1, c + 1) =
          view.inside[view.index(r, c)] + sum_at(r, c + 1) + sum_at(r + 1, c) - sum_at(r, c);
    }
  }
  const double shortest = 1.9 / view.cell;
  std::vector<RoofFit> fits;
  for (size_t i = 0; i < lines.columns.size(); ++i) {
    for (size_t j = i + 1; j < lines.columns.size(); ++j) {
      for (size_t k = 0; k < lines.rows.size(); ++k) {
        for (size_t l = k + 1; l < lines.rows.size(); ++l) {
          const CellRectangle r{lines.columns[i], lines.columns[j], lines.rows[k], lines.rows[l]};
          if (r.cols() < shortest || r.rows() < shortest) continue;
          const int count = sum_at(r.row1, r.col1) - sum_at(r.row0, r.col1) -
                            sum_at(r.row1, r.col0) + sum_at(r.row0, r.col0);
          if (count < 0.7 * r.cols() * r.rows()) continue;
          RoofFit along_x = fit_roof(view, r, Axis::kX, options.loss_scale, 0.3);
          RoofFit along_y = fit_roof(view, r, Axis::kY, options.loss_scale, 0.3);
          // Both ridges where they are nearly as good: a block partly under another one shows only
          // a part of its roof.
          const double better = std::max(along_x.gain, along_y.gain);
          if (along_x.gain > 0.9 * better) fits.push_back(std::move(along_x));
          if (along_y.gain > 0.9 * better && !along_y.flat) fits.push_back(std::move(along_y));
        }
      }
    }
  }
  std::stable_sort(fits.begin(), fits.end(),
                   [](const RoofFit& a, const RoofFit& b) { return a.gain > b.gain; });
  if (static_cast<int>(fits.size()) > options.max_rectangles) {
    fits.resize(options.max_rectangles);
  }
  return fits;
}

}  // namespace

std::vector<Hypothesis> search_blocks(const RectifiedView& view, const Eigen::Vector3d& origin,
                                      const BlockSearchOptions& options) {
  const std::vector<RoofFit> fits = fitted_rectangles(view, options);
  const int n = static_cast<int>(fits.size());
  const int near = static_cast<int>(std::lround(1.0 / view.cell));
  BestSet singles(&fits, options.per_foundation, near), pairs(&fits, options.per_foundation, near),
      triples(&fits, options.per_foundation, near), ls(&fits, options.per_foundation, near),
      us(&fits, options.per_foundation, near);

  for (int a = 0; a < n; ++a) singles.add({{a, -1, -1}, fits[a].gain});
  std::vector<std::vector<int>> wings(n);  // wings[a]: blocks that form an L with base a
  for (int a = 0; a < n; ++a) {
    for (int b = 0; b < n; ++b) {
      if (a == b) continue;
      // Gains of sets are at most the sums of their blocks' own.
      const double most = fits[a].gain + fits[b].gain;
      if (a < b && most > pairs.least()) {
        pairs.add({{a, b, -1}, envelope_gain(fits, {a, b, -1})});
      }
      if (l_shape(fits[a].rectangle, fits[b].rectangle).valid) {
        wings[a].push_back(b);
        if (most > ls.least()) ls.add({{a, b, -1}, envelope_gain(fits, {a, b, -1})});
      }
    }
  }
  for (const Scored& pair : pairs.pooled()) {
    for (int c = 0; c < n; ++c) {
      if (c == pair.blocks[0] || c == pair.blocks[1]) continue;
      if (pair.gain + fits[c].gain <= triples.least()) break;
      const Selection blocks{pair.blocks[0], pair.blocks[1], c};
      triples.add({blocks, envelope_gain(fits, blocks)});
    }
  }
  // U: two wings of one base on the same side, either along rows (base along x) or columns.
  const auto u_side = [&](int base, int a, int b, bool base_along_x) -> Eigen::Vector2d {
    const auto shape_of = [&](int w) {
      return base_along_x ? l_shape(fits[base].rectangle, fits[w].rectangle)
                          : l_shape(fits[w].rectangle, fits[base].rectangle);
    };
    const LShape p = shape_of(a), q = shape_of(b);
    if (!p.valid || !q.valid) return Eigen::Vector2d::Zero();
    const CellRectangle& ra = fits[a].rectangle;
    const CellRectangle& rb = fits[b].rectangle;
    const double gap = 1.0 / view.cell;
    if (base_along_x) {
      if (p.side_y != q.side_y || p.side_x == q.side_x) return Eigen::Vector2d::Zero();
      if (std::max(ra.col0, rb.col0) - std::min(ra.col1, rb.col1) < gap) {
        return Eigen::Vector2d::Zero();
      }
      return {0.0, static_cast<double>(p.side_y)};
    }
    // Base along y: wings run along x. side_x says at which end of the wing the base stands.
    if (p.side_x != q.side_x || p.side_y == q.side_y) return Eigen::Vector2d::Zero();
    if (std::max(ra.row0, rb.row0) - std::min(ra.row1, rb.row1) < gap) {
      return Eigen::Vector2d::Zero();
    }
    return {-static_cast<double>(p.side_x), 0.0};
  };
  std::vector<std::vector<int>> bases(n);  // bases[b]: blocks along x that wing b stands on
  for (int a = 0; a < n; ++a) {
    for (int b : wings[a]) bases[b].push_back(a);
  }
  for (int base = 0; base < n; ++base) {
    for (const auto* list : {&wings[base], &bases[base]}) {
      const bool base_along_x = list == &wings[base];
      for (size_t i = 0; i < list->size(); ++i) {
        for (size_t j = i + 1; j < list->size(); ++j) {
          if (u_side(base, (*list)[i], (*list)[j], base_along_x).isZero()) continue;
          const Selection blocks{base, (*list)[i], (*list)[j]};
          const double most = fits[blocks[0]].gain + fits[blocks[1]].gain + fits[blocks[2]].gain;
          if (most <= us.least()) continue;
          us.add({blocks, envelope_gain(fits, blocks)});
        }
      }
    }
  }

  std::vector<Hypothesis> out;
  const auto add = [&](House house, double gain) {
    house.origin = origin;
    out.push_back({std::move(house), gain});
  };
  const auto block = [&](int index) { return roofed_rectangle(view, fits[index]); };
  for (const BestSet* set : {&singles, &pairs, &triples}) {
    for (const Scored& s : set->distinct()) {
      std::vector<RoofedRectangle> blocks;
      for (int index : s.blocks) {
        if (index >= 0) blocks.push_back(block(index));
      }
      add(blocks_house(blocks, view.azimuth), s.gain);
    }
  }
  for (const Scored& s : ls.distinct()) {
    const LShape shape = l_shape(fits[s.blocks[0]].rectangle, fits[s.blocks[1]].rectangle);
    add(l_house(block(s.blocks[0]), block(s.blocks[1]), Side(shape.side_x, -shape.side_y),
                view.azimuth),
        s.gain);
  }
  for (const Scored& s : us.distinct()) {
    const bool along_x = l_shape(fits[s.blocks[0]].rectangle, fits[s.blocks[1]].rectangle).valid;
    const Side open = u_side(s.blocks[0], s.blocks[1], s.blocks[2], along_x);
    add(u_house(block(s.blocks[0]), block(s.blocks[1]), block(s.blocks[2]), open, view.azimuth),
        s.gain);
  }
  return out;
}

}  // namespace gable
