#pragma once

#include <Eigen/Core>
#include <vector>

#include <gable/grammar/block.h>

namespace gable {

/// Height of a block's roof at a point (x, y) inside its rectangle, house frame, metres. The roof
/// is eaves + rise * min(across, start, end): `across` falls from 1 at the ridge to 0 at the eaves,
/// `start` and `end` rise from 0 at the gable wall to 1 where the hip meets the ridge.
/// T: the block's scalar; P: the point's scalar (double, or T where the point moves as well).
template <typename T, typename P>
T roof_height(const Block<T>& block, const P& x, const P& y) {
  using namespace block_value;
  if (block.flat) return block[kEaves];
  const bool along_x = block.ridge == Axis::kX;
  const T& u0 = along_x ? block[kX0] : block[kY0];
  const T& u1 = along_x ? block[kX1] : block[kY1];
  const T& v0 = along_x ? block[kY0] : block[kX0];
  const T& v1 = along_x ? block[kY1] : block[kX1];
  const P& u = along_x ? x : y;
  const P& v = along_x ? y : x;

  const T half_width = (v1 - v0) * T(0.5);
  const T from_start = u - u0;
  const T from_end = u1 - u;
  const T from_low = v - v0;
  const T from_high = v1 - v;
  const T& to_eaves = from_high < from_low ? from_high : from_low;
  const T length = u1 - u0;
  const T start_run = block[kHipStart] * length;
  const T end_run = block[kHipEnd] * length;
  // Compare run against run before dividing: a gable end has no hip run at all.
  // to_eaves / half_width > from_start / start_run, both runs positive.
  const bool start_hip = from_start * half_width < to_eaves * start_run;
  const bool end_hip = from_end * half_width < to_eaves * end_run;
  if (start_hip && (!end_hip || from_start * end_run <= from_end * start_run)) {
    return block[kEaves] + block[kRise] * from_start / start_run;
  }
  if (end_hip) return block[kEaves] + block[kRise] * from_end / end_run;
  return block[kEaves] + block[kRise] * to_eaves / half_width;
}

/// What a block shows to a sample with a square support.
template <typename T>
struct BlockSample {
  T coverage{};  ///< share of the support that the block's rectangle covers, in [0, 1]
  T height{};    ///< roof height at the centroid of the covered share; set where coverage > 0
};

/// Samples a block at (x, y), house frame, with a support of width `support` metres (axis-aligned
/// in the house frame). coverage * height is exactly the support's integral of the roof over its
/// area wherever the roof is one plane there, which gives the height a derivative with respect to
/// the rectangle's edges. support = 0: a point sample, coverage 0 or 1.
template <typename T, typename P>
BlockSample<T> sample_block(const Block<T>& block, const P& x, const P& y, double support) {
  using namespace block_value;
  BlockSample<T> sample;
  sample.coverage = T(0.0);
  if (support <= 0.0) {
    if (x < block[kX0] || x >= block[kX1] || y < block[kY0] || y >= block[kY1]) return sample;
    sample.coverage = T(1.0);
    sample.height = roof_height(block, x, y);
    return sample;
  }
  const double half = 0.5 * support;
  const P x_low = x - P(half), x_high = x + P(half);
  const P y_low = y - P(half), y_high = y + P(half);
  if (x_low >= block[kX0] && x_high <= block[kX1] && y_low >= block[kY0] && y_high <= block[kY1]) {
    sample.coverage = T(1.0);
    sample.height = roof_height(block, x, y);
    return sample;
  }
  const T x_from = x_low < block[kX0] ? block[kX0] : T(x_low);
  const T x_to = x_high > block[kX1] ? block[kX1] : T(x_high);
  const T y_from = y_low < block[kY0] ? block[kY0] : T(y_low);
  const T y_to = y_high > block[kY1] ? block[kY1] : T(y_high);
  if (!(x_from < x_to) || !(y_from < y_to)) return sample;
  sample.coverage = (x_to - x_from) * (y_to - y_from) * T(1.0 / (support * support));
  const T centroid_x = (x_from + x_to) * T(0.5);
  const T centroid_y = (y_from + y_to) * T(0.5);
  sample.height = roof_height(block, centroid_x, centroid_y);
  return sample;
}

/// Whether a block stands on what the others form (dormers, chimneys) instead of on the ground.
inline bool stands_on_roof(BlockRole role) {
  return role == BlockRole::kDormer || role == BlockRole::kChimney;
}

/// The height field of a house at (x, y) in the house frame over a terrain of height `ground`
/// there (metres, relative to House::origin):
///
///   main = max over components and garages b of  c_b z_b + (1 - c_b) ground   (ground if none)
///   h    = main + max over dormers and chimneys a of  c_a max(0, z_a - main)
///
/// With support -> 0 this is the upper envelope of all blocks and the ground outside. Dormers and
/// chimneys are blended over the roof, not over the ground, because that is what is beside them:
/// otherwise their edges would shrink by the share of the support they do not cover.
/// See docs/height-field.md.
template <typename T, typename P>
T height_at(const std::vector<Block<T>>& blocks, const std::vector<BlockSource>& sources, const P& x,
            const P& y, double support, double ground) {
  T main = T(ground);
  bool covered = false;
  T lift = T(0.0);
  for (size_t i = 0; i < blocks.size(); ++i) {  // components and garages come first
    const BlockSample<T> sample = sample_block(blocks[i], x, y, support);
    if (!(sample.coverage > T(0.0))) continue;
    if (stands_on_roof(sources[i].role)) {
      const T gain = sample.coverage * (sample.height - main);
      if (gain > lift) lift = gain;
    } else {
      const T height = sample.coverage * (sample.height - T(ground)) + T(ground);
      if (!covered || height > main) main = height;
      covered = true;
    }
  }
  return main + lift;
}

/// The height field of a house with its current parameters, prepared for many samples.
class HeightField {
 public:
  explicit HeightField(const House& house);

  /// Height (metres above House::origin) at a point of the local frame.
  double at_local(const Eigen::Vector2d& local, double support, double ground) const;

  /// Height at a point of the house frame.
  double at_house(const Eigen::Vector2d& point, double support, double ground) const;

  /// Number of the block (index into blocks()) that is seen from above at a point of the house
  /// frame, or -1 for the ground.
  int block_at_house(const Eigen::Vector2d& point) const;

  Eigen::Vector2d house_from_local(const Eigen::Vector2d& local) const;
  Eigen::Vector2d local_from_house(const Eigen::Vector2d& point) const;

  const std::vector<Block<double>>& blocks() const { return blocks_; }
  const std::vector<BlockSource>& sources() const { return sources_; }

 private:
  std::vector<BlockSource> sources_;
  std::vector<Block<double>> blocks_;
  double cos_, sin_;
};

}  // namespace gable
