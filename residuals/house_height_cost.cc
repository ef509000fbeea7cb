#include <ceres/jet.h>
#include <gable/grammar/height_field.h>
#include <gable/residuals/house_height_cost.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gable {
namespace {

// Derivatives with respect to the values of `n` blocks, one after the other.
template <int n>
using BlocksJet = ceres::Jet<double, n * kNumBlockValues>;
// Derivatives of a block's values with respect to its own rule and its footprint rule.
using ChainJet = ceres::Jet<double, 2 * kMaxRuleParameters>;

// Per block: its values, the azimuth, and the residual itself, so that one outer product per pixel
// sums J'J, J'r and r'r.
constexpr int kAzimuthRow = kNumBlockValues;
constexpr int kResidualRow = kNumBlockValues + 1;
constexpr int kSumSize = kNumBlockValues + 2;
using SumMatrix = Eigen::Matrix<double, kSumSize, kSumSize>;
using SumVector = Eigen::Matrix<double, kSumSize, 1>;

struct ColumnRange {
  int begin = 0;
  int end = 0;
};

// A block with its values as independent variables, in slot `slot` of the jet.
template <int n>
Block<BlocksJet<n>> independent(const Block<double>& block, int slot) {
  Block<BlocksJet<n>> out;
  out.ridge = block.ridge;
  out.flat = block.flat;
  for (int k = 0; k < kNumBlockValues; ++k) {
    out.values[k] = BlocksJet<n>(block[k], slot * kNumBlockValues + k);
  }
  return out;
}

// E(p) over the blocks given (metres squared).
template <typename T>
T sample_cost(std::span<const Block<T>> blocks, double x, double y, double support, double ground,
              double height, const RobustLoss& loss) {
  const Layers<T> seen = layers_at<T, double>(blocks, x, y, support);
  T cost = seen.ground_share * loss.cost(ground - height);
  for (int k = 0; k < seen.count; ++k) {
    cost += seen.layers[k].share * loss.cost(seen.layers[k].height - height);
  }
  return cost;
}

// The blocks that a pixel sees, highest first, at most kMaxLayers.
struct Seen {
  int count = 0;
  bool top_only = false;  // the highest block covers the whole support
  std::array<int, kMaxLayers> blocks;
  std::array<double, kMaxLayers> heights;
};

// The same choice as layers_at makes, and nothing below a block that covers the whole support.
Seen seen_blocks(const std::vector<Block<double>>& blocks, const std::vector<ColumnRange>& ranges,
                 int column, double x, double y, double support) {
  Seen seen;
  std::array<bool, kMaxLayers> full;
  const double whole = support * support * (1.0 - 1e-12);
  for (int b = 0; b < static_cast<int>(blocks.size()); ++b) {
    if (column < ranges[b].begin || column >= ranges[b].end) continue;
    const auto part = covered_part<double, double>(blocks[b], x, y, support);
    if (part.empty()) continue;
    const double height = roof_height<double, double>(blocks[b], 0.5 * (part.x0 + part.x1),
                                                      0.5 * (part.y0 + part.y1));
    int at = seen.count;
    while (at > 0 && seen.heights[at - 1] < height) --at;
    if (at == kMaxLayers) continue;
    seen.count = std::min(seen.count + 1, kMaxLayers);
    for (int i = seen.count - 1; i > at; --i) {
      seen.blocks[i] = seen.blocks[i - 1];
      seen.heights[i] = seen.heights[i - 1];
      full[i] = full[i - 1];
    }
    seen.blocks[at] = b;
    seen.heights[at] = height;
    full[at] = part.area() >= whole;
  }
  for (int k = 0; k < seen.count; ++k) {
    if (!full[k]) continue;
    seen.count = k + 1;
    seen.top_only = k == 0;
  }
  return seen;
}

// The residual sqrt(weight E) of a pixel that sees `n` blocks and perhaps the ground, and its
// derivatives by block.
template <int n>
double edge_residual(const std::vector<Block<double>>& blocks, const Seen& seen, double x, double y,
                     double support, double ground, double height, double weight,
                     const RobustLoss& loss, SumVector* derivatives) {
  std::array<Block<BlocksJet<n>>, n> jets;
  for (int k = 0; k < n; ++k) jets[k] = independent<n>(blocks[seen.blocks[k]], k);
  const BlocksJet<n> cost = sample_cost<BlocksJet<n>>(jets, x, y, support, ground, height, loss);
  // Far below a millimetre the root has no derivative, and no need of one.
  const double residual = std::sqrt(weight * std::max(cost.a, 1e-12));
  for (int k = 0; k < n; ++k) {
    derivatives[k].template head<kNumBlockValues>() =
        (0.5 * weight / residual) * cost.v.template segment<kNumBlockValues>(k * kNumBlockValues);
  }
  return residual;
}

// Columns c for which low <= offset + slope * c <= high.
void clip_columns(double offset, double slope, double low, double high, ColumnRange* range) {
  if (std::abs(slope) < 1e-12) {
    if (offset < low || offset > high) range->end = range->begin;
    return;
  }
  double from = (low - offset) / slope, to = (high - offset) / slope;
  if (from > to) std::swap(from, to);
  range->begin = std::max(range->begin, static_cast<int>(std::ceil(std::max(from, -1.0))));
  range->end = std::min<int>(range->end, static_cast<int>(std::floor(std::min(to, 1e8))) + 1);
  range->end = std::max(range->end, range->begin);
}

}  // namespace

struct HouseHeightEvaluator::Sums {
  explicit Sums(int n)
      : num_blocks(n), used(static_cast<size_t>(n) * n, 0), pairs(static_cast<size_t>(n) * n) {}

  // Sums of products of the derivatives with respect to block a (rows) and block b (columns).
  SumMatrix& pair(int a, int b) {
    const size_t i = static_cast<size_t>(a) * num_blocks + b;
    if (!used[i]) {
      used[i] = 1;
      pairs[i].setZero();
    }
    return pairs[i];
  }

  int num_blocks;
  std::vector<char> used;
  std::vector<SumMatrix> pairs;
};

HouseHeightEvaluator::HouseHeightEvaluator(const House& house, const HeightImage* image,
                                           const HeightCostOptions& options)
    : house_(house), image_(image), options_(options) {
  for (const Rule* rule : static_cast<const House&>(house_).derivation()) {
    offsets_.push_back(num_parameters_);
    num_parameters_ += rule->size();
  }
  const RobustLoss loss(options_.loss, options_.loss_scale);
  const int stride = options_.stride;
  const int used_cols = (image->cols + stride - 1) / stride;
  for (int row = 0; row < image->rows; row += stride) {
    double sum = 0.0;
    ground_cost_.push_back(sum);
    for (int c = 0; c < used_cols; ++c) {
      const size_t i = image->index(row, c * stride);
      if (image->weight[i] > 0.0f) {
        const double weight = image->weight[i];
        sum += weight * loss.cost(static_cast<double>(image->ground[i]) - image->height[i]);
        ++num_samples_;
      }
      ground_cost_.push_back(sum);
    }
  }
}

template <bool kDerivatives>
double HouseHeightEvaluator::accumulate(double const* const* parameters, Sums* sums) const {
  using namespace block_value;
  const std::vector<BlockSource> sources = block_sources(house_);
  const int num_blocks = static_cast<int>(sources.size());
  std::vector<Block<double>> blocks;
  blocks.reserve(num_blocks);
  for (const BlockSource& source : sources) {
    blocks.push_back(expand_block<double>(
        house_, source, parameters[source.own_rule],
        source.footprint_rule < 0 ? nullptr : parameters[source.footprint_rule]));
  }
  std::vector<Block<BlocksJet<1>>> jets;
  if constexpr (kDerivatives) {
    for (const Block<double>& block : blocks) jets.push_back(independent<1>(block, 0));
  }

  const double cosine = std::cos(parameters[0][0]);
  const double sine = std::sin(parameters[0][0]);
  const RobustLoss loss(options_.loss, options_.loss_scale);
  const double support = options_.support;
  const int stride = options_.stride;
  const int used_cols = (image_->cols + stride - 1) / stride;
  const double step = image_->gsd * stride;
  std::vector<ColumnRange> ranges(num_blocks);
  double squared = 0.0;

  for (int used_row = 0; used_row * stride < image_->rows; ++used_row) {
    const int row = used_row * stride;
    const double local_y = image_->first_center.y() - row * image_->gsd;
    const double local_x0 = image_->first_center.x();
    // House coordinates are affine in the column.
    const double x_offset = cosine * local_x0 + sine * local_y, x_slope = cosine * step;
    const double y_offset = -sine * local_x0 + cosine * local_y, y_slope = -sine * step;
    int begin = used_cols, end = 0;
    for (int b = 0; b < num_blocks; ++b) {
      const Block<double>& block = blocks[b];
      ColumnRange range{0, used_cols};
      const double half = 0.5 * support;
      clip_columns(x_offset, x_slope, block[kX0] - half, block[kX1] + half, &range);
      clip_columns(y_offset, y_slope, block[kY0] - half, block[kY1] + half, &range);
      ranges[b] = range;
      if (range.begin < range.end) {
        begin = std::min(begin, range.begin);
        end = std::max(end, range.end);
      }
    }
    const double* ground_cost = &ground_cost_[static_cast<size_t>(used_row) * (used_cols + 1)];
    if (begin >= end) {
      squared += ground_cost[used_cols];
      continue;
    }
    squared += ground_cost[begin] + (ground_cost[used_cols] - ground_cost[end]);

    for (int c = begin; c < end; ++c) {
      const size_t i = image_->index(row, c * stride);
      const double weight = image_->weight[i];
      if (!(weight > 0.0)) continue;
      const double x = x_offset + x_slope * c;
      const double y = y_offset + y_slope * c;
      const double ground = image_->ground[i];

      const double height = image_->height[i];

      const Seen seen = seen_blocks(blocks, ranges, c, x, y, support);
      if (seen.count == 0) {
        squared += weight * loss.cost(ground - height);
        continue;
      }
      if constexpr (!kDerivatives) {
        if (seen.top_only) {
          squared += weight * loss.cost(seen.heights[0] - height);
        } else {
          std::array<Block<double>, kMaxLayers> some;
          for (int k = 0; k < kMaxLayers && k < seen.count; ++k) some[k] = blocks[seen.blocks[k]];
          squared += weight * sample_cost<double>({some.data(), static_cast<size_t>(seen.count)}, x,
                                                  y, support, ground, height, loss);
        }
        continue;
      }
      std::array<SumVector, kMaxLayers> v;
      double residual;
      int count = seen.count;
      if (seen.top_only) {
        count = 1;
        double slope;
        loss.evaluate(seen.heights[0] - height, &residual, &slope);
        const double root_weight = weight == 1.0 ? 1.0 : std::sqrt(weight);
        residual *= root_weight;
        v[0].head<kNumBlockValues>() =
            (slope * root_weight) * roof_height<BlocksJet<1>, double>(jets[seen.blocks[0]], x, y).v;
      } else if (count == 1) {
        residual =
            edge_residual<1>(blocks, seen, x, y, support, ground, height, weight, loss, v.data());
      } else if (count == 2) {
        residual =
            edge_residual<2>(blocks, seen, x, y, support, ground, height, weight, loss, v.data());
      } else if (count == 3) {
        residual =
            edge_residual<3>(blocks, seen, x, y, support, ground, height, weight, loss, v.data());
      } else {
        residual =
            edge_residual<4>(blocks, seen, x, y, support, ground, height, weight, loss, v.data());
      }
      squared += residual * residual;
      for (int k = 0; k < count; ++k) {
        // The azimuth moves the sample point: the residual depends on x only through x - x0 and
        // x - x1 of every block, hence d/dx = -sum (d/dx0 + d/dx1), likewise y; and turning the
        // house by d moves the point in the house frame by (y, -x) d.
        const double dx = -(v[k][kX0] + v[k][kX1]);
        const double dy = -(v[k][kY0] + v[k][kY1]);
        v[k][kAzimuthRow] = dx * y - dy * x;
        v[k][kResidualRow] = 0.0;
        for (int l = 0; l < k; ++l) {
          sums->pair(seen.blocks[l], seen.blocks[k]).noalias() += v[l] * v[k].transpose();
        }
      }
      for (int k = 0; k < count; ++k) {
        v[k][kResidualRow] = residual;
        sums->pair(seen.blocks[k], seen.blocks[k]).noalias() += v[k] * v[k].transpose();
      }
    }
  }
  return squared;
}

double HouseHeightEvaluator::squared_residuals(double const* const* parameters) const {
  return accumulate<false>(parameters, nullptr);
}

void HouseHeightEvaluator::normal_equations(double const* const* parameters,
                                            NormalEquations* normal) const {
  const std::vector<BlockSource> sources = block_sources(house_);
  const auto rules = static_cast<const House&>(house_).derivation();
  const int num_blocks = static_cast<int>(sources.size());
  Sums sums(num_blocks);
  normal->set_zero(num_parameters_);
  normal->squared_residuals = accumulate<true>(parameters, &sums);

  // Chain from the blocks' values to the parameters. Columns: the rules the block is made from,
  // the azimuth, and one for the residual, which is appended to the parameters as the last row.
  struct Chain {
    Eigen::Matrix<double, kSumSize, Eigen::Dynamic> matrix;
    std::vector<int> columns;
  };
  std::vector<Chain> chains(num_blocks);
  for (int b = 0; b < num_blocks; ++b) {
    const BlockSource& source = sources[b];
    std::array<ChainJet, kMaxRuleParameters> own, footprint;
    Chain& chain = chains[b];
    const int own_size = rules[source.own_rule]->size();
    for (int k = 0; k < own_size; ++k) {
      own[k] = ChainJet(parameters[source.own_rule][k], k);
      chain.columns.push_back(offsets_[source.own_rule] + k);
    }
    int footprint_size = 0;
    if (source.footprint_rule >= 0) {
      footprint_size = rules[source.footprint_rule]->size();
      for (int k = 0; k < footprint_size; ++k) {
        footprint[k] = ChainJet(parameters[source.footprint_rule][k], kMaxRuleParameters + k);
        chain.columns.push_back(offsets_[source.footprint_rule] + k);
      }
    }
    chain.columns.push_back(offsets_[0]);
    chain.columns.push_back(num_parameters_);
    const Block<ChainJet> block =
        expand_block<ChainJet>(house_, source, own.data(), footprint.data());
    const int n = own_size + footprint_size;
    chain.matrix.setZero(kSumSize, n + 2);
    for (int k = 0; k < kNumBlockValues; ++k) {
      chain.matrix.row(k).head(own_size) = block[k].v.head(own_size).transpose();
      chain.matrix.row(k).segment(own_size, footprint_size) =
          block[k].v.segment(kMaxRuleParameters, footprint_size).transpose();
    }
    chain.matrix(kAzimuthRow, n) = 1.0;
    chain.matrix(kResidualRow, n + 1) = 1.0;
  }

  const auto add = [&](int row, int col, double value) {
    if (row == num_parameters_) return;  // r'J is J'r again, r'r is summed apart
    if (col == num_parameters_) {
      normal->jtr[row] += value;
    } else {
      normal->jtj(row, col) += value;
    }
  };
  for (int a = 0; a < num_blocks; ++a) {
    for (int b = 0; b < num_blocks; ++b) {
      if (!sums.used[static_cast<size_t>(a) * num_blocks + b]) continue;
      const Eigen::MatrixXd product =
          chains[a].matrix.transpose() * sums.pair(a, b) * chains[b].matrix;
      for (size_t i = 0; i < chains[a].columns.size(); ++i) {
        for (size_t j = 0; j < chains[b].columns.size(); ++j) {
          const int row = chains[a].columns[i], col = chains[b].columns[j];
          add(row, col, product(i, j));
          // Pairs of two blocks are summed once and carry no residual.
          if (a != b) add(col, row, product(i, j));
        }
      }
    }
  }
}

HouseHeightCost::HouseHeightCost(const House& house, const HeightImage* image,
                                 const HeightCostOptions& options)
    : evaluator_(house, image, options) {
  for (const Rule* rule : evaluator_.house().derivation()) {
    mutable_parameter_block_sizes()->push_back(rule->size());
  }
  set_num_residuals(evaluator_.num_parameters() + 1);
}

bool HouseHeightCost::Evaluate(double const* const* parameters, double* residuals,
                               double** jacobians) const {
  const int n = evaluator_.num_parameters();
  Eigen::Map<Eigen::VectorXd> out(residuals, n + 1);
  if (jacobians == nullptr) {
    out.setZero();
    out[n] = std::sqrt(evaluator_.squared_residuals(parameters));
    return true;
  }
  NormalEquations normal;
  evaluator_.normal_equations(parameters, &normal);
  const CompressedResiduals compressed = compress(normal);
  out = compressed.residuals;
  const auto& sizes = parameter_block_sizes();
  for (size_t b = 0; b < sizes.size(); ++b) {
    if (jacobians[b] == nullptr) continue;
    Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
        jacobians[b], n + 1, sizes[b]) =
        compressed.jacobian.middleCols(evaluator_.offsets()[b], sizes[b]);
  }
  return true;
}

}  // namespace gable
