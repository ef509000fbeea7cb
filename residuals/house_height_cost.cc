#include <ceres/jet.h>
#include <gable/residuals/house_height_cost.h>
#include <gable/residuals/layered_sample.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace gable {
namespace {

// Derivatives of a block's values with respect to its own rule and its footprint rule.
using ChainJet = ceres::Jet<double, 2 * kMaxRuleParameters>;

// Per block: its values, the azimuth, and the residual itself, so that one outer product per pixel
// sums J'J, J'r and r'r.
constexpr int kAzimuthRow = kNumBlockValues;
constexpr int kResidualRow = kNumBlockValues + 1;
constexpr int kSumSize = kNumBlockValues + 2;
using SumMatrix = Eigen::Matrix<double, kSumSize, kSumSize>;
using SumVector = Eigen::Matrix<double, kSumSize, 1>;

// Moments of the positions q = (1, x - anchor.x, y - anchor.y) of pixels that see one facet and
// nothing else. With G the facet's gradient, a residual's derivatives are slope * G q, so J'J is
// G (sum slope^2 q q') G' and J'r is G (sum slope * residual * q): a few sums per pixel.
struct FacetSums {
  bool used = false;
  double s = 0.0, sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0, syy = 0.0;  // of slope^2
  double r = 0.0, rx = 0.0, ry = 0.0;                                   // of slope * residual

  void add(double x, double y, double slope, double residual, double pixel_weight) {
    used = true;
    const double weight = pixel_weight * slope * slope;
    const double product = pixel_weight * slope * residual;
    s += weight;
    sx += weight * x;
    sy += weight * y;
    sxx += weight * x * x;
    sxy += weight * x * y;
    syy += weight * y * y;
    r += product;
    rx += product * x;
    ry += product * y;
  }

  void add_to(const FacetGradient& gradient, SumMatrix* sum) const {
    Eigen::Matrix<double, kNumBlockValues + 1, 3> g;
    g.topRows<kNumBlockValues>() = gradient.values;
    // Turning the house by d moves the point in the house frame by (y, -x) d.
    g.row(kAzimuthRow) << gradient.slope.x() * gradient.anchor.y() -
                              gradient.slope.y() * gradient.anchor.x(),
        -gradient.slope.y(), gradient.slope.x();
    Eigen::Matrix3d moments;
    moments << s, sx, sy, sx, sxx, sxy, sy, sxy, syy;
    sum->topLeftCorner<kNumBlockValues + 1, kNumBlockValues + 1>() += g * moments * g.transpose();
    sum->topRightCorner<kNumBlockValues + 1, 1>() += g * Eigen::Vector3d(r, rx, ry);
  }
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
      : num_blocks(n),
        used(static_cast<size_t>(n) * n, 0),
        pairs(static_cast<size_t>(n) * n),
        facets(n) {}

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
  std::vector<std::array<FacetSums, kNumFacets>> facets;  // pixels that see one facet only
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
  FacetGradients gradients;
  if constexpr (kDerivatives) {
    gradients.resize(num_blocks);
    for (int b = 0; b < num_blocks; ++b) {
      for (int f = 0; f < kNumFacets; ++f) {
        const Facet facet = static_cast<Facet>(f);
        if (has_facet(blocks[b], facet)) gradients[b][f] = facet_gradient(blocks[b], facet);
      }
    }
  }

  const double cosine = std::cos(parameters[0][0]);
  const double sine = std::sin(parameters[0][0]);
  const RobustLoss loss(options_.loss, options_.loss_scale);
  const bool mean_heights = image_->spread > 0.0;
  const double support = std::max(image_->spread, options_.support);
  const RoofSampling sampling = mean_heights ? RoofSampling::kMean : RoofSampling::kCentroid;
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

      const SeenLayers seen = seen_layers(blocks, ranges, c, x, y, support, sampling);
      if (seen.count == 0) {
        squared += weight * loss.cost(ground - height);
        continue;
      }
      const SeenLayer& top = seen.layers[0];
      if constexpr (!kDerivatives) {
        if (seen.top_only) {
          squared += weight * loss.cost(top.height - height);
        } else if (mean_heights) {
          squared += weight * loss.cost(layered_mean(seen, layer_heights(seen, ground), support,
                                                     nullptr, nullptr) -
                                        height);
        } else {
          squared += weight * layered_mean(seen, layer_costs(seen, loss, ground, height), support,
                                           nullptr, nullptr);
        }
        continue;
      }
      if (sees_one_facet(seen)) {
        double residual, slope;
        loss.evaluate(top.height - height, &residual, &slope);
        squared += weight * residual * residual;
        const int facet = static_cast<int>(top.facets[0]);
        const Eigen::Vector2d& anchor = gradients[top.block][facet].anchor;
        sums->facets[top.block][facet].add(x - anchor.x(), y - anchor.y(), slope, residual, weight);
        continue;
      }
      std::array<BlockGradient, kMaxLayers> derivatives;
      double residual, by_mean;
      if (mean_heights) {
        const double mean = layered_mean(seen, layer_heights(seen, ground), support, &gradients,
                                         derivatives.data());
        loss.evaluate(mean - height, &residual, &by_mean);
        residual *= std::sqrt(weight);
        by_mean *= std::sqrt(weight);
        squared += residual * residual;
      } else {
        const double cost = layered_mean(seen, layer_costs(seen, loss, ground, height), support,
                                         &gradients, derivatives.data());
        squared += weight * cost;
        // Far below a millimetre the root has no derivative, and no need of one.
        residual = std::sqrt(weight * std::max(cost, 1e-12));
        by_mean = 0.5 * weight / residual;
      }
      std::array<SumVector, kMaxLayers> v;
      for (int k = 0; k < seen.count; ++k) {
        v[k].head<kNumBlockValues>() = by_mean * derivatives[k];
        // The azimuth moves the sample point: the residual depends on x only through x - x0 and
        // x - x1 of every block, hence d/dx = -sum (d/dx0 + d/dx1), likewise y; and turning the
        // house by d moves the point in the house frame by (y, -x) d.
        const double dx = -(v[k][kX0] + v[k][kX1]);
        const double dy = -(v[k][kY0] + v[k][kY1]);
        v[k][kAzimuthRow] = dx * y - dy * x;
        v[k][kResidualRow] = 0.0;
        for (int l = 0; l < k; ++l) {
          sums->pair(seen.layers[l].block, seen.layers[k].block).noalias() +=
              v[l] * v[k].transpose();
        }
      }
      for (int k = 0; k < seen.count; ++k) {
        v[k][kResidualRow] = residual;
        sums->pair(seen.layers[k].block, seen.layers[k].block).noalias() += v[k] * v[k].transpose();
      }
    }
  }
  if constexpr (kDerivatives) {
    for (int b = 0; b < num_blocks; ++b) {
      for (int f = 0; f < kNumFacets; ++f) {
        if (!sums->facets[b][f].used) continue;
        sums->facets[b][f].add_to(gradients[b][f], &sums->pair(b, b));
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
      const Eigen::MatrixXd product = chains[a].matrix.transpose().lazyProduct(
          sums.pair(a, b).lazyProduct(chains[b].matrix).eval());
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
  const auto& sizes = parameter_block_sizes();
  Eigen::Map<Eigen::VectorXd> out(residuals, n + 1);
  out.setZero();
  bool same_point = last_parameters_.size() == n;
  for (size_t b = 0; b < sizes.size() && same_point; ++b) {
    same_point = std::equal(parameters[b], parameters[b] + sizes[b],
                            last_parameters_.data() + evaluator_.offsets()[b]);
  }
  if (jacobians == nullptr) {
    out[n] = std::sqrt(same_point ? last_.residuals.squaredNorm()
                                  : evaluator_.squared_residuals(parameters));
    return true;
  }
  // Ceres asks for no Jacobian of constant blocks; what is compressed shrinks to the others.
  std::vector<int> columns;
  for (size_t b = 0; b < sizes.size(); ++b) {
    for (int k = 0; k < sizes[b] && jacobians[b] != nullptr; ++k) {
      columns.push_back(evaluator_.offsets()[b] + k);
    }
  }
  if (!same_point || columns != last_columns_) {
    NormalEquations normal;
    evaluator_.normal_equations(parameters, &normal);
    if (static_cast<int>(columns.size()) < n) {
      normal.jtj = normal.jtj(columns, columns).eval();
      normal.jtr = normal.jtr(columns).eval();
    }
    last_ = compress(normal);
    last_columns_ = columns;
    last_parameters_.resize(n);
    for (size_t b = 0; b < sizes.size(); ++b) {
      std::copy_n(parameters[b], sizes[b], last_parameters_.data() + evaluator_.offsets()[b]);
    }
  }
  const int m = static_cast<int>(columns.size());
  out.head(m) = last_.residuals.head(m);
  out[n] = last_.residuals[m];
  int column = 0;
  for (size_t b = 0; b < sizes.size(); ++b) {
    if (jacobians[b] == nullptr) continue;
    Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>> jacobian(
        jacobians[b], n + 1, sizes[b]);
    jacobian.setZero();
    jacobian.topRows(m) = last_.jacobian.topRows(m).middleCols(column, sizes[b]);
    column += sizes[b];
  }
  return true;
}

}  // namespace gable
