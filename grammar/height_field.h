#pragma once

#include <gable/grammar/block.h>

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

namespace gable {

/// The planes a roof is made of, named in the direction of the ridge: kLow and kHigh are the sides
/// at the rectangle's lower and higher coordinate across the ridge, kStart and kEnd the hips. A
/// mansard's sides are kLow and kHigh up to the break, kUpperLow and kUpperHigh above it.
enum class Facet : unsigned char { kFlat, kLow, kHigh, kStart, kEnd, kUpperLow, kUpperHigh };
inline constexpr int kNumFacets = 7;

/// Whether a block's roof has a facet of this name. The roof is the minimum of these planes.
template <typename T>
bool has_facet(const Block<T>& block, Facet facet) {
  using namespace block_value;
  switch (facet) {
    case Facet::kFlat:
      return block.flat;
    case Facet::kLow:
    case Facet::kHigh:
      return !block.flat;
    case Facet::kStart:
      return !block.flat && !block.mansard && block[kHipStart] > T(0.0);
    case Facet::kEnd:
      return !block.flat && !block.mansard && block[kHipEnd] > T(0.0);
    default:
      return !block.flat && block.mansard;
  }
}

namespace internal {

// Mansards are rare. Out of line, they cost the other roofs nothing in the innermost loops, where
// what is inlined decides about a tenth of a refinement's time.

/// Half the width of a mansard, and how far a point is from the eaves of its lower and higher side.
template <typename T>
struct MansardRuns {
  T half_width, from_low, from_high;
};

template <typename T, typename P>
MansardRuns<T> mansard_runs(const Block<T>& block, const P& x, const P& y) {
  using namespace block_value;
  const bool along_x = block.ridge == Axis::kX;
  const T& v0 = along_x ? block[kY0] : block[kX0];
  const T& v1 = along_x ? block[kY1] : block[kX1];
  const P& v = along_x ? y : x;
  return {(v1 - v0) * T(0.5), v - v0, v1 - v};
}

template <typename T, typename P>
[[gnu::noinline]] Facet mansard_facet(const Block<T>& block, const P& x, const P& y) {
  const MansardRuns<T> runs = mansard_runs(block, x, y);
  const bool high = runs.from_high < runs.from_low;
  const T& from_eaves = high ? runs.from_high : runs.from_low;
  if (from_eaves > block[block_value::kBreakRun] * runs.half_width) {
    return high ? Facet::kUpperHigh : Facet::kUpperLow;
  }
  return high ? Facet::kHigh : Facet::kLow;
}

template <typename T, typename P>
[[gnu::noinline]] T mansard_facet_height(const Block<T>& block, Facet facet, const P& x,
                                         const P& y) {
  using namespace block_value;
  const MansardRuns<T> runs = mansard_runs(block, x, y);
  const bool high = facet == Facet::kHigh || facet == Facet::kUpperHigh;
  const T& from_eaves = high ? runs.from_high : runs.from_low;
  const T break_run = block[kBreakRun] * runs.half_width;
  const T& break_height = block[kBreakHeight];
  if (facet == Facet::kLow || facet == Facet::kHigh) {
    return block[kEaves] + block[kRise] * break_height * from_eaves / break_run;
  }
  const T above_break = (from_eaves - break_run) / (runs.half_width - break_run);
  return block[kEaves] + block[kRise] * (break_height + (T(1.0) - break_height) * above_break);
}

}  // namespace internal

/// The facet of a block's roof over a point (x, y) inside its rectangle, house frame: that of the
/// least height. T: the block's scalar; P: the point's (double, or T where the point moves as
/// well).
template <typename T, typename P>
[[gnu::always_inline]] inline Facet roof_facet(const Block<T>& block, const P& x, const P& y) {
  using namespace block_value;
  if (block.flat) return Facet::kFlat;
  if (block.mansard) [[unlikely]]
    return internal::mansard_facet(block, x, y);
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
  const bool high = from_high < from_low;
  const T& to_eaves = high ? from_high : from_low;
  const T start_run = block[kHipStart] * (u1 - u0);
  const T end_run = block[kHipEnd] * (u1 - u0);
  // Compare run against run instead of dividing: a gable end has no hip run at all.
  // to_eaves / half_width > from_start / start_run, both runs positive.
  const bool start_hip = from_start * half_width < to_eaves * start_run;
  const bool end_hip = from_end * half_width < to_eaves * end_run;
  if (start_hip && (!end_hip || from_start * end_run <= from_end * start_run)) return Facet::kStart;
  if (end_hip) return Facet::kEnd;
  return high ? Facet::kHigh : Facet::kLow;
}

/// Height at (x, y) of the plane that a facet lies in, house frame, metres: eaves + rise * the
/// share of the run from the facet's eaves to the ridge; a mansard's sides lie in the planes
/// through eaves and break, and through break and ridge. Linear in the point.
template <typename T, typename P>
[[gnu::always_inline]] inline T facet_height(const Block<T>& block, Facet facet, const P& x,
                                             const P& y) {
  using namespace block_value;
  if (facet == Facet::kFlat) return block[kEaves];
  if (block.mansard) [[unlikely]]
    return internal::mansard_facet_height(block, facet, x, y);
  const bool along_x = block.ridge == Axis::kX;
  const T& u0 = along_x ? block[kX0] : block[kY0];
  const T& u1 = along_x ? block[kX1] : block[kY1];
  const T& v0 = along_x ? block[kY0] : block[kX0];
  const T& v1 = along_x ? block[kY1] : block[kX1];
  const P& u = along_x ? x : y;
  const P& v = along_x ? y : x;
  if (facet == Facet::kStart) {
    return block[kEaves] + block[kRise] * (u - u0) / (block[kHipStart] * (u1 - u0));
  }
  if (facet == Facet::kEnd) {
    return block[kEaves] + block[kRise] * (u1 - u) / (block[kHipEnd] * (u1 - u0));
  }
  const T half_width = (v1 - v0) * T(0.5);
  if (facet == Facet::kHigh) return block[kEaves] + block[kRise] * (v1 - v) / half_width;
  return block[kEaves] + block[kRise] * (v - v0) / half_width;
}

/// Height of a block's roof at a point (x, y) inside its rectangle, house frame, metres: eaves +
/// rise * min(across, start, end), where `across` falls from 1 at the ridge to 0 at the eaves, and
/// `start` and `end` rise from 0 at the gable wall to 1 where the hip meets the ridge. A mansard is
/// the minimum of its lower and upper sides.
template <typename T, typename P>
T roof_height(const Block<T>& block, const P& x, const P& y) {
  return facet_height(block, roof_facet(block, x, y), x, y);
}

/// The part of a sample's square support that blocks cover, as a rectangle of the house frame.
template <typename T>
struct CoveredPart {
  T x0, x1, y0, y1;
  bool empty() const { return !(x0 < x1) || !(y0 < y1); }
  T area() const { return (x1 - x0) * (y1 - y0); }
};

template <typename T, typename P>
CoveredPart<T> covered_part(const Block<T>& block, const P& x, const P& y, double support) {
  using namespace block_value;
  const double half = 0.5 * support;
  const P x_low = x - P(half), x_high = x + P(half);
  const P y_low = y - P(half), y_high = y + P(half);
  return {x_low < block[kX0] ? block[kX0] : T(x_low), x_high > block[kX1] ? block[kX1] : T(x_high),
          y_low < block[kY0] ? block[kY0] : T(y_low), y_high > block[kY1] ? block[kY1] : T(y_high)};
}

template <typename T>
CoveredPart<T> intersect(const CoveredPart<T>& a, const CoveredPart<T>& b) {
  return {a.x0 < b.x0 ? b.x0 : a.x0, a.x1 > b.x1 ? b.x1 : a.x1, a.y0 < b.y0 ? b.y0 : a.y0,
          a.y1 > b.y1 ? b.y1 : a.y1};
}

/// Which height stands for a roof's over the covered part of a support.
enum class RoofSampling {
  kCentroid,  ///< that at the centroid: one surface, as a first return sees it
  kMean,      ///< the mean, by Gauss' rule of 2 x 2 points: exact on planes, near so across ridges
};

/// The points of the rule, as shares of a rectangle's sides.
inline constexpr std::array<double, 2> kGaussPoints = {0.21132486540518712, 0.78867513459481288};

/// Mean height of a block's roof over a part of its rectangle, metres.
template <typename T>
T mean_roof_height(const Block<T>& block, const CoveredPart<T>& part) {
  T sum(0.0);
  for (const double u : kGaussPoints) {
    for (const double v : kGaussPoints) {
      sum = sum + roof_height(block, part.x0 * T(1.0 - u) + part.x1 * T(u),
                              part.y0 * T(1.0 - v) + part.y1 * T(v));
    }
  }
  return sum * T(0.25);
}

/// At most this many blocks are told apart in one sample.
inline constexpr int kMaxLayers = 4;

/// A block as one sample sees it.
template <typename T>
struct Layer {
  int block = -1;  ///< number of the block in the list given
  T height{};      ///< of the roof over the covered part of the support, see RoofSampling, metres
  T share{};       ///< visible share of the support, in [0, 1]
};

/// The blocks that a sample at (x, y), house frame, sees from above.
template <typename T>
struct Layers {
  std::array<Layer<T>, kMaxLayers> layers;  ///< highest first
  int count = 0;
  T ground_share{};  ///< share of the support that no block covers
};

/// Sorts the blocks over a sample by height and gives each its visible share of the support, a
/// square of width `support` metres, axis-aligned in the house frame: the area of its covered part
/// that no higher one covers, by inclusion and exclusion of rectangles, hence exact. The shares are
/// what gives heights a derivative with respect to the rectangles' edges; share * height is exactly
/// the support's integral of a roof wherever it is one plane there. Of more than kMaxLayers blocks
/// the highest count. support = 0: a point sample, one layer with share 1, or none.
template <typename T, typename P>
Layers<T> layers_at(std::span<const Block<T>> blocks, const P& x, const P& y, double support,
                    RoofSampling sampling = RoofSampling::kCentroid) {
  using namespace block_value;
  Layers<T> out;
  out.ground_share = T(1.0);
  std::array<CoveredPart<T>, kMaxLayers> parts;
  const double area = support * support;
  for (size_t b = 0; b < blocks.size(); ++b) {
    Layer<T> layer;
    layer.block = static_cast<int>(b);
    CoveredPart<T> part;
    if (support > 0.0) {
      part = covered_part(blocks[b], x, y, support);
      if (part.empty()) continue;
      layer.height =
          sampling == RoofSampling::kMean
              ? mean_roof_height(blocks[b], part)
              : roof_height(blocks[b], (part.x0 + part.x1) * T(0.5), (part.y0 + part.y1) * T(0.5));
    } else {
      if (x < blocks[b][kX0] || x >= blocks[b][kX1] || y < blocks[b][kY0] || y >= blocks[b][kY1]) {
        continue;
      }
      layer.height = roof_height(blocks[b], x, y);
      if (out.count > 0 && layer.height <= out.layers[0].height) continue;
      layer.share = T(1.0);
      out.layers[0] = layer;
      out.count = 1;
      out.ground_share = T(0.0);
      continue;
    }
    int at = out.count;
    while (at > 0 && out.layers[at - 1].height < layer.height) --at;
    if (at == kMaxLayers) continue;
    out.count = out.count < kMaxLayers ? out.count + 1 : kMaxLayers;
    for (int i = out.count - 1; i > at; --i) {
      out.layers[i] = out.layers[i - 1];
      parts[i] = parts[i - 1];
    }
    out.layers[at] = layer;
    parts[at] = part;
  }
  if (support <= 0.0) return out;
  for (int k = 0; k < out.count; ++k) {
    // Sum over the sets of higher layers of (-1)^|set| times the area common to the set and k.
    T visible(0.0);
    for (int set = 0; set < (1 << k); ++set) {
      CoveredPart<T> common = parts[k];
      bool odd = false;
      for (int j = 0; j < k; ++j) {
        if (!(set & (1 << j))) continue;
        common = intersect(common, parts[j]);
        odd = !odd;
      }
      if (common.empty()) continue;
      visible = odd ? visible - common.area() : visible + common.area();
    }
    out.layers[k].share = visible * T(1.0 / area);
    out.ground_share = out.ground_share - out.layers[k].share;
  }
  return out;
}

/// The height field of a house at (x, y) in the house frame over a terrain of height `ground` there
/// (metres, relative to House::origin): the mean over the support of the upper envelope of all
/// blocks, and the ground outside. With support = 0, the envelope itself. See
/// docs/height-field.md.
template <typename T, typename P>
T height_at(std::span<const Block<T>> blocks, const P& x, const P& y, double support,
            double ground) {
  const Layers<T> seen = layers_at(blocks, x, y, support, RoofSampling::kMean);
  T height = seen.ground_share * T(ground);
  for (int k = 0; k < seen.count; ++k) {
    height = height + seen.layers[k].share * seen.layers[k].height;
  }
  return height;
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
