#include <gable/grammar/random.h>
#include <gable/grammar/solid/block_alignment.h>

#include <algorithm>
#include <cmath>

namespace gable {
namespace {

constexpr double kSameCoordinate = 0.02;
constexpr double kSameHeight = 0.01;
constexpr double kLeastRun = 0.05;

// The position of the level nearest to a value and within reach, or -1.
template <typename Level>
int nearest_level(double value, double reach, const std::vector<Level>& levels) {
  int nearest = -1;
  for (size_t i = 0; i < levels.size(); ++i) {
    const double distance = std::abs(levels[i].value - value);
    if (distance < reach && (nearest < 0 || distance < std::abs(levels[nearest].value - value))) {
      nearest = static_cast<int>(i);
    }
  }
  return nearest;
}

// Hips and ridges too short to build vanish.
void tidy_hips(Block<double>* block) {
  using namespace block_value;
  double& start = (*block)[kHipStart];
  double& end = (*block)[kHipEnd];
  const double length =
      block->ridge == Axis::kX ? (*block)[kX1] - (*block)[kX0] : (*block)[kY1] - (*block)[kY0];
  start = std::clamp(start, 0.0, 0.5);
  end = std::clamp(end, 0.0, 0.5);
  if (start * length < kLeastRun) start = 0.0;
  if (end * length < kLeastRun) end = 0.0;
  if ((1.0 - start - end) * length < kLeastRun) start = end = 0.5;
}

// A break too near the eaves to build moves in, one that would make the lower side the less steep
// one moves up.
void tidy_break(Block<double>* block) {
  using namespace block_value;
  const double width =
      block->ridge == Axis::kX ? (*block)[kY1] - (*block)[kY0] : (*block)[kX1] - (*block)[kX0];
  double& run = (*block)[kBreakRun];
  run = std::clamp(run, std::min(0.5, 2.0 * kLeastRun / width), 0.5);
  (*block)[kBreakHeight] = std::clamp((*block)[kBreakHeight], run, 1.0);
}

}  // namespace

int BlockAlignment::level_at(double value, double tolerance, std::vector<Level>* levels) {
  const int nearest = nearest_level(value, tolerance, *levels);
  if (nearest >= 0) return nearest;
  levels->push_back({value});
  return static_cast<int>(levels->size()) - 1;
}

void BlockAlignment::add_derived(int low, int high, double share, std::vector<Level>* levels) {
  const double value = (1.0 - share) * (*levels)[low].value + share * (*levels)[high].value;
  for (const Level& level : *levels) {
    if (std::abs(level.value - value) < kSameCoordinate) return;
  }
  levels->push_back({value, low, high, share});
}

Shake shake_of_attempt(int attempt) {
  Shake shake;
  if (attempt == 0) return shake;
  shake.scope = attempt % 2 == 1 ? Shake::Scope::kLevels : Shake::Scope::kBlocks;
  shake.amplitude = 0.004 + 0.001 * (attempt - 1);
  shake.seed = static_cast<uint64_t>(attempt);
  return shake;
}

BlockAlignment::BlockAlignment(const std::vector<Block<double>>& blocks, double base) {
  using namespace block_value;
  heights_.push_back({base});
  for (const Block<double>& block : blocks) {
    AlignedBlock aligned;
    aligned.shape = block;
    for (const int edge : {kX0, kX1}) {
      aligned.edges[edge] = level_at(block[edge], kSameCoordinate, &x_);
    }
    for (const int edge : {kY0, kY1}) {
      aligned.edges[edge] = level_at(block[edge], kSameCoordinate, &y_);
    }
    aligned.eaves = level_at(block[kEaves], kSameHeight, &heights_);
    aligned.ridge = aligned.eaves;
    if (!block.flat) {
      aligned.ridge = level_at(block[kEaves] + block[kRise], kSameHeight, &heights_);
    }
    if (heights_[aligned.ridge].value <= heights_[aligned.eaves].value) {
      aligned.shape.flat = true;
      aligned.ridge = aligned.eaves;
    }
    if (!aligned.shape.flat) {
      const bool along_x = block.ridge == Axis::kX;
      std::vector<Level>& along = along_x ? x_ : y_;
      std::vector<Level>& across = along_x ? y_ : x_;
      const int* u = aligned.edges + (along_x ? kX0 : kY0);
      const int* v = aligned.edges + (along_x ? kY0 : kX0);
      add_derived(v[0], v[1], 0.5, &across);
      if (block.mansard) {
        tidy_break(&aligned.shape);
        const double share = 0.5 * aligned.shape[kBreakRun];
        add_derived(v[0], v[1], share, &across);
        add_derived(v[0], v[1], 1.0 - share, &across);
        add_derived(aligned.eaves, aligned.ridge, aligned.shape[kBreakHeight], &heights_);
        aligned_.push_back(aligned);
        continue;
      }
      tidy_hips(&aligned.shape);
      const double start = aligned.shape[kHipStart], end = aligned.shape[kHipEnd];
      if (start > 0.0) add_derived(u[0], u[1], start, &along);
      if (end > 0.0) add_derived(u[0], u[1], 1.0 - end, &along);
    }
    aligned_.push_back(aligned);
  }
}

bool BlockAlignment::has_area(int block) const {
  using namespace block_value;
  const AlignedBlock& aligned = aligned_[block];
  return x_[aligned.edges[kX0]].value < x_[aligned.edges[kX1]].value &&
         y_[aligned.edges[kY0]].value < y_[aligned.edges[kY1]].value;
}

std::vector<double> BlockAlignment::shaken(const std::vector<Level>& levels, const Shake& shake,
                                           uint64_t stream) {
  std::vector<double> values;
  Random random(shake.seed * 4 + stream);
  const bool moves = shake.scope == Shake::Scope::kLevels;
  for (const Level& level : levels) {
    const double step = moves ? random.uniform(-shake.amplitude, shake.amplitude) : 0.0;
    values.push_back(level.low < 0 ? level.value + step
                                   : (1.0 - level.share) * values[level.low] +
                                         level.share * values[level.high]);
  }
  return values;
}

std::vector<Block<double>> BlockAlignment::blocks(const Shake& shake) const {
  using namespace block_value;
  const std::vector<double> x = shaken(x_, shake, 0);
  const std::vector<double> y = shaken(y_, shake, 1);
  const std::vector<double> heights = shaken(heights_, shake, 2);
  Random random(shake.seed * 4 + 3);
  const auto step = [&] {
    return shake.scope == Shake::Scope::kBlocks ? random.uniform(-shake.amplitude, shake.amplitude)
                                                : 0.0;
  };
  std::vector<Block<double>> blocks;
  for (const AlignedBlock& aligned : aligned_) {
    Block<double>& block = blocks.emplace_back(aligned.shape);
    for (const int edge : {kX0, kX1}) block[edge] = x[aligned.edges[edge]] + step();
    for (const int edge : {kY0, kY1}) block[edge] = y[aligned.edges[edge]] + step();
    const double lift = step();
    block[kEaves] = heights[aligned.eaves] + lift;
    block[kRise] = heights[aligned.ridge] - heights[aligned.eaves];
  }
  return blocks;
}

PlanPolygon BlockAlignment::outline(PlanPolygon polygon, const Shake& shake) const {
  const std::vector<double> x = shaken(x_, shake, 0);
  const std::vector<double> y = shaken(y_, shake, 1);
  const auto align = [](const std::vector<Level>& levels, const std::vector<double>& values,
                        double* coordinate) {
    const int level = nearest_level(*coordinate, kSameCoordinate, levels);
    if (level >= 0) *coordinate = values[level];
  };
  const auto align_ring = [&](std::vector<Eigen::Vector2d>* ring) {
    for (Eigen::Vector2d& p : *ring) {
      align(x_, x, &p.x());
      align(y_, y, &p.y());
    }
  };
  align_ring(&polygon.outer);
  for (auto& hole : polygon.holes) align_ring(&hole);
  return polygon;
}

}  // namespace gable
