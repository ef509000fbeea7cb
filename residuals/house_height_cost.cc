#include <ceres/jet.h>
#include <gable/grammar/height_field.h>
#include <gable/residuals/house_height_cost.h>
#include <gable/residuals/robust_loss.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gable {
namespace {

// Derivatives with respect to one block's values.
using BlockJet = ceres::Jet<double, kNumBlockValues>;
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

struct PreparedBlock {
  Block<double> block;
  Block<BlockJet> jets;
  bool on_roof = false;
};

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
  const SoftL1 loss(options_.loss_scale);
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
  std::vector<PreparedBlock> prepared(num_blocks);
  for (int b = 0; b < num_blocks; ++b) {
    const BlockSource& source = sources[b];
    PreparedBlock& p = prepared[b];
    p.block = expand_block<double>(
        house_, source, parameters[source.own_rule],
        source.footprint_rule < 0 ? nullptr : parameters[source.footprint_rule]);
    p.on_roof = stands_on_roof(source.role);
    if constexpr (kDerivatives) {
      p.jets.ridge = p.block.ridge;
      p.jets.flat = p.block.flat;
      for (int k = 0; k < kNumBlockValues; ++k) p.jets.values[k] = BlockJet(p.block[k], k);
    }
  }

  const double cosine = std::cos(parameters[0][0]);
  const double sine = std::sin(parameters[0][0]);
  const SoftL1 loss(options_.loss_scale);
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
      const Block<double>& block = prepared[b].block;
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

      int main_block = -1, roof_block = -1;
      double main = ground, lift = 0.0;
      BlockSample<double> main_sample, roof_sample;
      for (int b = 0; b < num_blocks; ++b) {
        if (c < ranges[b].begin || c >= ranges[b].end) continue;
        const auto sample = sample_block<double, double>(prepared[b].block, x, y, support);
        if (!(sample.coverage > 0.0)) continue;
        if (prepared[b].on_roof) {
          const double gain = sample.coverage * (sample.height - main);
          if (gain > lift) {
            lift = gain;
            roof_block = b;
            roof_sample = sample;
          }
        } else {
          const double height = sample.coverage * (sample.height - ground) + ground;
          if (main_block < 0 || height > main) {
            main = height;
            main_block = b;
            main_sample = sample;
          }
        }
      }
      const double residual = main + lift - image_->height[i];
      if constexpr (!kDerivatives) {
        squared += weight * loss.cost(residual);
        continue;
      }
      double robust, slope;
      loss.evaluate(residual, &robust, &slope);
      const double root_weight = weight == 1.0 ? 1.0 : std::sqrt(weight);
      robust *= root_weight;
      slope *= root_weight;
      squared += robust * robust;

      // d h / d (values of a block), and the azimuth through the sample point: h depends on x only
      // through x - x0 and x - x1, hence dh/dx = -(dh/dx0 + dh/dx1), likewise y; and turning the
      // house by d moves the point in the house frame by (y, -x) d.
      const auto fill = [&](int b, double scale_height, double scale_coverage, SumVector* v) {
        const auto jet = sample_block<BlockJet, double>(prepared[b].jets, x, y, support);
        v->head<kNumBlockValues>() =
            slope * (scale_height * jet.height.v + scale_coverage * jet.coverage.v);
        const double dx = -((*v)[kX0] + (*v)[kX1]);
        const double dy = -((*v)[kY0] + (*v)[kY1]);
        (*v)[kAzimuthRow] = dx * y - dy * x;
        (*v)[kResidualRow] = 0.0;
      };
      if (main_block < 0 && roof_block < 0) continue;
      SumVector v, w;
      const double through = roof_block < 0 ? 1.0 : 1.0 - roof_sample.coverage;
      if (main_block >= 0) {
        fill(main_block, through * main_sample.coverage, through * (main_sample.height - ground),
             &v);
      }
      if (roof_block < 0) {
        v[kResidualRow] = robust;
        sums->pair(main_block, main_block).noalias() += v * v.transpose();
        continue;
      }
      fill(roof_block, roof_sample.coverage, roof_sample.height - main, &w);
      w[kResidualRow] = robust;
      sums->pair(roof_block, roof_block).noalias() += w * w.transpose();
      if (main_block >= 0) {
        sums->pair(main_block, main_block).noalias() += v * v.transpose();
        sums->pair(main_block, roof_block).noalias() += v * w.transpose();
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
          if (a != b) {
            // The transposed pair. Its J'r part was summed with block b's own, so only J'J.
            if (row != num_parameters_ && col != num_parameters_) {
              normal->jtj(col, row) += product(i, j);
            }
          }
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
