#pragma once

#include <gable/grammar/house.h>

#include <array>
#include <vector>

namespace gable {

/// What a block stands for, which decides how it enters the height field and the solids.
enum class BlockRole {
  kComponent,  ///< a foundation component under its roof
  kGarage,     ///< a garage, or one wing of an L-shaped garage
  kDormer,     ///< stands on the roof, never outside its component's rectangle
  kChimney,    ///< stands on the roof or beside the wall
};

/// Whether a block stands on what the others form (dormers, chimneys) instead of on the ground.
inline bool stands_on_roof(BlockRole role) {
  return role == BlockRole::kDormer || role == BlockRole::kChimney;
}

/// Positions in Block::values. A roof has hips or broken sides, never both: the last two values are
/// the hips' or, of a mansard, the break's. The sums of the optimiser's innermost loop grow with
/// the square of the number of values.
namespace block_value {
enum {
  kX0,
  kX1,
  kY0,
  kY1,
  kEaves,
  kRise,
  kHipStart,
  kHipEnd,
  kBreakHeight = kHipStart,
  kBreakRun = kHipEnd
};
}
inline constexpr int kNumBlockValues = 8;

/// A rectangle of the house frame under a flat, gable, hip or mansard roof: what every rule expands
/// to. values: x0 < x1 and y0 < y1 (metres, house frame), eaves height and ridge rise (metres), and
/// the share of the length taken by the hip at the start and at the end of the ridge, or the shares
/// of the rise and of the half width at which a mansard's sides break.
template <typename T>
struct Block {
  std::array<T, kNumBlockValues> values;
  Axis ridge = Axis::kX;
  bool flat = false;     ///< no ridge: rise and hips are not read
  bool mansard = false;  ///< broken sides and no hips

  const T& operator[](int i) const { return values[i]; }
  T& operator[](int i) { return values[i]; }
};

/// Names the rules a block is made from.
struct BlockSource {
  BlockRole role = BlockRole::kComponent;
  int index = 0;     ///< component, garage, dormer or chimney number
  int wing = 0;      ///< L-shaped garages: 0 wing x, 1 wing y
  int own_rule = 0;  ///< position in House::derivation() of the roof, garage, dormer or chimney
  int footprint_rule = -1;  ///< position of the footprint rule it takes a rectangle from, or -1
};

/// All blocks of a house: components, garages, dormers, chimneys, in this order.
std::vector<BlockSource> block_sources(const House& house);

namespace internal {

template <typename T>
void set_rectangle(const T& x0, const T& x1, const T& y0, const T& y1, Block<T>* block) {
  using namespace block_value;
  (*block)[kX0] = x0;
  (*block)[kX1] = x1;
  (*block)[kY0] = y0;
  (*block)[kY1] = y1;
}

template <typename T>
void set_centered_rectangle(const T* p, Block<T>* block) {
  using namespace param::rectangle;
  const T half_length = p[kLength] * T(0.5);
  const T half_width = p[kWidth] * T(0.5);
  set_rectangle<T>(p[kCenterX] - half_length, p[kCenterX] + half_length, p[kCenterY] - half_width,
                   p[kCenterY] + half_width, block);
}

template <typename T>
void set_l_wing(const T* p, int wing, Block<T>* block) {
  using namespace param::l_polygon;
  const T& length = wing == 0 ? p[kWingXLength] : p[kWingYWidth];
  const T& width = wing == 0 ? p[kWingXWidth] : p[kWingYLength];
  set_rectangle<T>(p[kCornerX], p[kCornerX] + length, p[kCornerY], p[kCornerY] + width, block);
}

template <typename T>
void set_u_wing(const T* p, int wing, Block<T>* block) {
  using namespace param::u_polygon;
  const T x3 = p[kCornerX] + p[kBaseLength];
  if (wing == 0) {
    set_rectangle<T>(p[kCornerX], x3, p[kCornerY], p[kCornerY] + p[kBaseWidth], block);
  } else if (wing == 1) {
    set_rectangle<T>(p[kCornerX], p[kCornerX] + p[kLeftWidth], p[kCornerY],
                     p[kCornerY] + p[kLeftLength], block);
  } else {
    set_rectangle<T>(x3 - p[kRightWidth], x3, p[kCornerY], p[kCornerY] + p[kRightLength], block);
  }
}

/// The rectangle of component `component` from its footprint rule's parameters.
template <typename T>
void set_component_rectangle(RuleKind footprint_kind, const T* footprint, int component,
                             Block<T>* block) {
  if (footprint_kind == RuleKind::kFootprintL) {
    set_l_wing(footprint, component, block);
  } else if (footprint_kind == RuleKind::kFootprintU) {
    set_u_wing(footprint, component, block);
  } else {
    set_centered_rectangle(footprint, block);
  }
}

}  // namespace internal

/// Expands one block from the parameters of the rules it is made from. `own` and `footprint` are
/// the parameter blocks named by `source` (`footprint` is not read where source.footprint_rule is
/// -1). T: double or an automatic differentiation scalar.
template <typename T>
Block<T> expand_block(const House& house, const BlockSource& source, const T* own,
                      const T* footprint) {
  using namespace block_value;
  Block<T> block;
  for (T& v : block.values) v = T(0.0);
  switch (source.role) {
    case BlockRole::kComponent: {
      const Rule& rule = house.roofs[source.index];
      const Rule& footprint_rule = house.footprints[house.footprint_of_component(source.index)];
      internal::set_component_rectangle(footprint_rule.kind, footprint, source.index, &block);
      block.ridge = rule.ridge;
      block.flat = rule.kind == RuleKind::kRoofFlat;
      block[kEaves] = own[param::roof::kEaves];
      if (!block.flat) block[kRise] = own[param::roof::kRise];
      if (rule.kind == RuleKind::kRoofHip) {
        block[kHipStart] = own[param::roof::kHipStart];
        block[kHipEnd] = own[param::roof::kHipEnd];
      }
      block.mansard = rule.kind == RuleKind::kRoofMansard;
      if (block.mansard) {
        block[kBreakHeight] = own[param::mansard::kBreakHeight];
        block[kBreakRun] = own[param::mansard::kBreakRun];
      }
      break;
    }
    case BlockRole::kGarage: {
      block.flat = true;
      if (house.garages[source.index].kind == RuleKind::kGarageI) {
        internal::set_centered_rectangle(own, &block);
        block[kEaves] = own[param::garage::kHeightI];
      } else {
        internal::set_l_wing(own, source.wing, &block);
        block[kEaves] = own[param::garage::kHeightL];
      }
      break;
    }
    case BlockRole::kDormer: {
      namespace d = param::dormer;
      const Rule& rule = house.dormers[source.index];
      const Rule& footprint_rule = house.footprints[house.footprint_of_component(rule.component)];
      Block<T> parent;
      internal::set_component_rectangle(footprint_rule.kind, footprint, rule.component, &parent);
      // The dormer's ridge runs across its parent's; its width lies along the parent's ridge.
      const bool parent_along_x = house.roofs[rule.component].ridge == Axis::kX;
      block.ridge = parent_along_x ? Axis::kY : Axis::kX;
      const T half_x = (parent_along_x ? own[d::kWidth] : own[d::kDepth]) * T(0.5);
      const T half_y = (parent_along_x ? own[d::kDepth] : own[d::kWidth]) * T(0.5);
      const T x0 = own[d::kCenterX] - half_x;
      const T x1 = own[d::kCenterX] + half_x;
      const T y0 = own[d::kCenterY] - half_y;
      const T y1 = own[d::kCenterY] + half_y;
      // A dormer that leans over the eaves ends at the wall.
      internal::set_rectangle<T>(
          x0 < parent[kX0] ? parent[kX0] : x0, x1 > parent[kX1] ? parent[kX1] : x1,
          y0 < parent[kY0] ? parent[kY0] : y0, y1 > parent[kY1] ? parent[kY1] : y1, &block);
      block[kEaves] = own[d::kEaves];
      block[kRise] = own[d::kRise];
      break;
    }
    case BlockRole::kChimney: {
      namespace c = param::chimney;
      block.flat = true;
      const T half = own[c::kSide] * T(0.5);
      internal::set_rectangle<T>(own[c::kCenterX] - half, own[c::kCenterX] + half,
                                 own[c::kCenterY] - half, own[c::kCenterY] + half, &block);
      block[kEaves] = own[c::kHeight];
      break;
    }
  }
  return block;
}

/// All blocks of a house with its current parameters, in the order of `block_sources`.
std::vector<Block<double>> expand_blocks(const House& house);

}  // namespace gable
