#include <gable/engine/reconstruct/choice/block_proposals.h>
#include <gable/engine/reconstruct/first_values/roof_fit.h>
#include <gable/engine/reconstruct/heights/pixel_regions.h>
#include <gable/grammar/height_field.h>
#include <gable/residuals/height_image.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>

namespace gable {
namespace {

constexpr float kNothing = -std::numeric_limits<float>::infinity();

// Shortest side of a block, metres.
constexpr double kShortest = 1.9;

// Unexplained cells in parts narrower than this are walls that lie a little off, metres.
constexpr double kNarrow = 1.4;

// Fewer cells say little of a block's size, however large they are.
constexpr size_t kFewestCells = 10;

// Lines at which a component may be split are first tried this far apart, metres.
constexpr double kCoarse = 1.0;

// Regions are arms of one block if their sides differ by no more than this, metres.
constexpr double kAlignment = 1.5;

// Of a region's box, lines of cells at its sides with a smaller share of the region are cut off.
constexpr double kFullSide = 0.4;

// As regions go on the largest few are worth a block.
constexpr size_t kMostRegions = 4;

// A ridge must save as much as a flat roof does not, as in the search for first values.
constexpr double kRisePenalty = 0.3;

// A footprint and a hip; less where the roof turns out simpler.
constexpr int kBlockParameters = 8;
constexpr int kFlatBlockParameters = 5;

// What stands over each cell of a view.
class Surface {
 public:
  Surface(const RectifiedView& view, const House& house) : view_(view) {
    const HeightField field(house);
    rest_ = view.ground;
    for (size_t b = 0; b < field.blocks().size(); ++b) {
      const std::span<const Block<double>> one(&field.blocks()[b], 1);
      const bool component = field.sources()[b].role == BlockRole::kComponent;
      std::vector<float> heights(view.height.size(), kNothing);
      const CellRectangle near = cells_around(field.blocks()[b]);
      for (int row = near.row0; row < near.row1; ++row) {
        for (int col = near.col0; col < near.col1; ++col) {
          const Layers<double> seen = layers_at<double, double>(
              one, view.x_edge(col) + 0.5 * view.cell, view.y_edge(row) + 0.5 * view.cell, 0.0);
          if (seen.count == 0) continue;
          const auto height = static_cast<float>(seen.layers[0].height);
          const size_t i = view.index(row, col);
          heights[i] = height;
          if (!component) rest_[i] = std::max(rest_[i], height);
        }
      }
      if (component) components_.push_back(std::move(heights));
    }
  }

  int num_components() const { return static_cast<int>(components_.size()); }

  // Heights without one component; -1: of all.
  std::vector<float> without(int left_out) const {
    std::vector<float> out = rest_;
    for (int c = 0; c < num_components(); ++c) {
      if (c == left_out) continue;
      for (size_t i = 0; i < out.size(); ++i) out[i] = std::max(out[i], components_[c][i]);
    }
    return out;
  }

  // The component seen at a cell, or -1.
  int seen(size_t cell) const {
    int top = -1;
    float height = rest_[cell];
    for (int c = 0; c < num_components(); ++c) {
      if (components_[c][cell] > height) {
        height = components_[c][cell];
        top = c;
      }
    }
    return top;
  }

 private:
  // No cell beyond these has its centre in the block.
  CellRectangle cells_around(const Block<double>& block) const {
    using namespace block_value;
    const auto cell = [&](double at, double from, int most) {
      return static_cast<int>(std::clamp((at - from) / view_.cell, 0.0, static_cast<double>(most)));
    };
    return {cell(block[kX0], view_.x0, view_.cols),
            std::min(view_.cols, cell(block[kX1], view_.x0, view_.cols) + 1),
            cell(block[kY0], view_.y0, view_.rows),
            std::min(view_.rows, cell(block[kY1], view_.y0, view_.rows) + 1)};
  }

  const RectifiedView& view_;
  std::vector<float> rest_;  // ground, garages and details
  std::vector<std::vector<float>> components_;
};

class Proposer {
 public:
  Proposer(const RectifiedView& view, const House& house, const BlockProposalOptions& options)
      : view_(view),
        options_(options),
        loss_(options.loss, options.loss_scale),
        blocks_(roofed_rectangles(house)),
        surface_(view, house),
        all_(surface_.without(-1)) {}

  std::vector<BlockProposal> proposals() {
    std::vector<double> unexplained(blocks_.size(), 0.0);
    std::vector<CellRectangle> missing;
    for (const bool above : {true, false}) {
      const std::vector<PixelRegion> regions = unexplained_regions(above);
      for (size_t r = 0; r < std::min(regions.size(), kMostRegions); ++r) {
        const double cost = cost_of(regions[r]);
        for (size_t i : regions[r].pixels) {
          const int component = surface_.seen(i);
          if (component >= 0) unexplained[component] += cost_at(i, all_[i]);
        }
        if (!above || !(cost > price(kFlatBlockParameters))) continue;
        missing.push_back(bulk(regions[r]));
        add_block(missing.back());
      }
    }
    // Two arms of one block that crosses the house.
    for (size_t a = 0; a < missing.size(); ++a) {
      for (size_t b = a + 1; b < missing.size(); ++b) {
        if (are_in_line(missing[a], missing[b])) add_block(around(missing[a], missing[b]));
      }
    }
    for (size_t b = 0; b < blocks_.size(); ++b) {
      if (unexplained[b] > price(kFlatBlockParameters)) split(static_cast<int>(b));
    }
    std::stable_sort(out_.begin(), out_.end(), [](const BlockProposal& a, const BlockProposal& b) {
      return a.gain > b.gain;
    });
    return std::move(out_);
  }

 private:
  double price(int parameters) const { return parameters * options_.parameter_price; }

  double cost_at(size_t cell, float height) const {
    return view_.weight[cell] * loss_.cost(static_cast<double>(height) - view_.height[cell]);
  }

  double cost_of(const PixelRegion& region) const {
    double sum = 0.0;
    for (size_t i : region.pixels) sum += cost_at(i, all_[i]);
    return sum;
  }

  std::vector<PixelRegion> unexplained_regions(bool above) const {
    cv::Mat mask = cv::Mat::zeros(view_.rows, view_.cols, CV_8U);
    for (int row = 0; row < view_.rows; ++row) {
      for (int col = 0; col < view_.cols; ++col) {
        const size_t i = view_.index(row, col);
        if (view_.weight[i] < 0.5f) continue;
        const float residual = view_.height[i] - all_[i];
        mask.at<unsigned char>(row, col) =
            (above ? residual : -residual) > options_.least_residual ? 1 : 0;
      }
    }
    const int width = std::max(2, static_cast<int>(std::ceil(kNarrow / view_.cell)));
    cv::morphologyEx(mask, mask, cv::MORPH_OPEN, cv::Mat::ones(width, width, CV_8U));
    std::vector<PixelRegion> regions = largest_regions(mask);
    std::erase_if(regions, [&](const PixelRegion& region) {
      return region.pixels.size() < kFewestCells ||
             static_cast<double>(region.pixels.size()) * view_.cell * view_.cell <
                 options_.least_area;
    });
    return regions;
  }

  // The view with what `base` explains already left out of fits.
  RectifiedView left_by(const std::vector<float>& base) const {
    RectifiedView left = view_;
    for (size_t i = 0; i < left.weight.size(); ++i) {
      const bool built = base[i] > view_.ground[i] + 0.5f;
      if (built && std::abs(base[i] - view_.height[i]) <= options_.least_residual) {
        left.weight[i] = 0.0f;
      }
    }
    return left;
  }

  RoofFit best_roof(const RectifiedView& left, const CellRectangle& r) const {
    RoofFit x = fit_roof(left, r, Axis::kX, options_.loss_scale, kRisePenalty);
    RoofFit y = fit_roof(left, r, Axis::kY, options_.loss_scale, kRisePenalty);
    return x.gain >= y.gain ? x : y;
  }

  // Cost of the cells of a rectangle under `base` and, where not null, a roof.
  double cost_over(const CellRectangle& r, const std::vector<float>& base,
                   const RoofFit* roof) const {
    double sum = 0.0;
    size_t k = 0;
    for (int row = r.row0; row < r.row1; ++row) {
      for (int col = r.col0; col < r.col1; ++col, ++k) {
        const size_t i = view_.index(row, col);
        sum += cost_at(i, roof != nullptr ? std::max(base[i], roof->heights[k]) : base[i]);
      }
    }
    return sum;
  }

  int parameters_of(const RoofFit& fit) const {
    return fit.flat ? kFlatBlockParameters : kBlockParameters;
  }

  // The bulk of a region's box: lines at its sides that hold little of it are cut off.
  CellRectangle bulk(const PixelRegion& region) const {
    cv::Mat mask = cv::Mat::zeros(view_.rows, view_.cols, CV_8U);
    for (size_t i : region.pixels) {
      mask.at<unsigned char>(static_cast<int>(i) / view_.cols, static_cast<int>(i) % view_.cols) =
          1;
    }
    CellRectangle r{region.box.col0, region.box.col1, region.box.row0, region.box.row1};
    while (r.cols() > 1 && r.rows() > 1) {
      const auto share = [&](int row0, int row1, int col0, int col1) {
        const cv::Rect box(col0, row0, col1 - col0, row1 - row0);
        return cv::countNonZero(mask(box)) / static_cast<double>(box.area());
      };
      const double sides[] = {
          share(r.row0, r.row1, r.col0, r.col0 + 1), share(r.row0, r.row1, r.col1 - 1, r.col1),
          share(r.row0, r.row0 + 1, r.col0, r.col1), share(r.row1 - 1, r.row1, r.col0, r.col1)};
      const auto least = std::min_element(std::begin(sides), std::end(sides)) - std::begin(sides);
      if (sides[least] >= kFullSide) break;
      if (least == 0) ++r.col0;
      if (least == 1) --r.col1;
      if (least == 2) ++r.row0;
      if (least == 3) --r.row1;
    }
    return r;
  }

  bool is_long_enough(int cells) const { return cells * view_.cell >= kShortest; }

  // Whether one lies beyond the other along an axis and they are about as wide across it.
  bool are_in_line(const CellRectangle& a, const CellRectangle& b) const {
    const auto near = [&](int p, int q) { return std::abs(p - q) * view_.cell <= kAlignment; };
    const bool columns = near(a.col0, b.col0) && near(a.col1, b.col1);
    const bool rows = near(a.row0, b.row0) && near(a.row1, b.row1);
    return (columns && (a.row1 <= b.row0 || b.row1 <= a.row0)) ||
           (rows && (a.col1 <= b.col0 || b.col1 <= a.col0));
  }

  static CellRectangle around(const CellRectangle& a, const CellRectangle& b) {
    return {std::min(a.col0, b.col0), std::max(a.col1, b.col1), std::min(a.row0, b.row0),
            std::max(a.row1, b.row1)};
  }

  void add_block(const CellRectangle& r) {
    if (static_cast<int>(blocks_.size()) >= options_.most_blocks) return;
    if (!is_long_enough(r.cols()) || !is_long_enough(r.rows())) return;
    const RoofFit roof = best_roof(left_by(all_), r);
    BlockProposal proposal;
    proposal.gain =
        cost_over(r, all_, nullptr) - cost_over(r, all_, &roof) - price(parameters_of(roof));
    if (!(proposal.gain > 0.0)) return;
    proposal.blocks = blocks_;
    proposal.changed = {static_cast<int>(blocks_.size())};
    proposal.blocks.push_back(roofed_rectangle(view_, roof));
    out_.push_back(std::move(proposal));
  }

  // Cells whose centres a component covers.
  CellRectangle cells_of(const RoofedRectangle& b) const {
    const auto cell = [&](double at, double from, int most) {
      return std::clamp(static_cast<int>(std::lround((at - from) / view_.cell)), 0, most);
    };
    return {cell(b.x0, view_.x0, view_.cols), cell(b.x1, view_.x0, view_.cols),
            cell(b.y0, view_.y0, view_.rows), cell(b.y1, view_.y0, view_.rows)};
  }

  // One side of a split: a roof of its own, or nothing.
  struct Part {
    RoofFit roof;
    bool kept = false;
    double cost = 0.0;  // with the price
  };

  Part part_of(const RectifiedView& left, const std::vector<float>& base,
               const CellRectangle& r) const {
    Part part;
    part.cost = cost_over(r, base, nullptr);
    part.roof = best_roof(left, r);
    const double with = cost_over(r, base, &part.roof) + price(parameters_of(part.roof));
    if (with < part.cost) {
      part.cost = with;
      part.kept = true;
    }
    return part;
  }

  void split(int component) {
    const std::vector<float> base = surface_.without(component);
    const RectifiedView left = left_by(base);
    const CellRectangle whole = cells_of(blocks_[component]);
    const double before =
        cost_over(whole, all_, nullptr) + price(blocks_[component].roof.kind == RuleKind::kRoofFlat
                                                    ? kFlatBlockParameters
                                                    : kBlockParameters);
    const int shortest = static_cast<int>(std::ceil(kShortest / view_.cell));
    const int step = std::max(1, static_cast<int>(std::lround(kCoarse / view_.cell)));
    for (const bool along_columns : {true, false}) {
      const int begin = along_columns ? whole.col0 : whole.row0;
      const int end = along_columns ? whole.col1 : whole.row1;
      Part low, high;
      int best = -1;
      const auto attempt = [&](int at) {
        if (at < begin + shortest || at > end - shortest) return;
        CellRectangle a = whole, b = whole;
        (along_columns ? a.col1 : a.row1) = at;
        (along_columns ? b.col0 : b.row0) = at;
        Part first = part_of(left, base, a), second = part_of(left, base, b);
        if (best >= 0 && first.cost + second.cost >= low.cost + high.cost) return;
        best = at;
        low = std::move(first);
        high = std::move(second);
      };
      for (int at = begin + shortest; at <= end - shortest; at += step) attempt(at);
      if (best < 0) continue;
      const int coarse = best;
      for (int at = coarse - step + 1; at < coarse + step; ++at) {
        if (at != coarse) attempt(at);
      }
      add_split(component, along_columns, low, high, before);
    }
  }

  void add_split(int component, bool along_columns, const Part& low, const Part& high,
                 double before) {
    BlockProposal proposal;
    proposal.gain = before - low.cost - high.cost;
    if (!(proposal.gain > 0.0) || (!low.kept && !high.kept)) return;
    if (low.kept && high.kept && static_cast<int>(blocks_.size()) >= options_.most_blocks) return;
    proposal.blocks = blocks_;
    // The outer edges stay where they were, finer than cells.
    const RoofedRectangle& old = blocks_[component];
    const auto place = [&](const Part& part, bool is_low) {
      RoofedRectangle r = roofed_rectangle(view_, part.roof);
      const double cut = along_columns ? (is_low ? r.x1 : r.x0) : (is_low ? r.y1 : r.y0);
      const Rule roof = r.roof;
      r = old;
      r.roof = roof;
      (along_columns ? (is_low ? r.x1 : r.x0) : (is_low ? r.y1 : r.y0)) = cut;
      return r;
    };
    proposal.blocks[component] = place(low.kept ? low : high, low.kept);
    proposal.changed = {component};
    if (low.kept && high.kept) {
      proposal.changed.push_back(static_cast<int>(proposal.blocks.size()));
      proposal.blocks.push_back(place(high, false));
    }
    out_.push_back(std::move(proposal));
  }

  const RectifiedView& view_;
  const BlockProposalOptions& options_;
  const RobustLoss loss_;
  const std::vector<RoofedRectangle> blocks_;
  const Surface surface_;
  const std::vector<float> all_;
  std::vector<BlockProposal> out_;
};

}  // namespace

std::vector<BlockProposal> propose_blocks(const RectifiedView& view, const House& house,
                                          const BlockProposalOptions& options) {
  if (view.rows == 0 || view.cols == 0) return {};
  return Proposer(view, house, options).proposals();
}

}  // namespace gable
