#include <gable/grammar/synthesis/houses/distinct.h>
#include <gable/grammar/synthesis/houses/random_blocks.h>
#include <gable/grammar/synthesis/houses/random_roof.h>
#include <gable/grammar/synthesis/houses/rectangle.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace gable {
namespace {

/// A block under construction. The pitch is kept because neighbours often share it.
struct Draft {
  Rectangle rectangle;
  Rule roof;
  double pitch = 0.0;
};

double eaves_of(const Draft& block) { return block.roof[param::roof::kEaves]; }

double top_of(const Draft& block) { return eaves_of(block) + block.roof[param::roof::kRise]; }

Draft random_single(Random* random) {
  Draft block;
  const double width = random->uniform(5.0, 10.0);
  const double length = std::max(7.0, width * random->uniform(1.0, 1.9));
  block.rectangle = {0.0, std::min(length, 18.0), 0.0, width};
  block.pitch = random_pitch(random);
  const double eaves = random_eaves(random);
  if (random->chance(0.03)) {
    block.roof = make_flat_roof(std::max(eaves, kFlatBlockHeight));
    return block;
  }
  const bool across = block.rectangle.size_x() <= 10.0 && random->chance(0.25);
  block.roof =
      random_roof(block.rectangle, across ? Axis::kY : Axis::kX, eaves, block.pitch, random);
  return block;
}

/// The first block of a II or III: ridge along x.
Draft random_main(bool terrace, Random* random) {
  Draft block;
  const double width = random->uniform(5.5, 9.0);
  const double length =
      terrace ? random->uniform(5.5, 9.0) : std::max(7.0, width * random->uniform(0.9, 1.7));
  block.rectangle = {0.0, length, 0.0, width};
  block.pitch = random_pitch(random);
  block.roof =
      terrace ? make_roof(block.rectangle, Axis::kX, random_eaves(random), block.pitch,
                          RoofEnd::kGable, RoofEnd::kGable, random)
              : random_roof(block.rectangle, Axis::kX, random_eaves(random), block.pitch, random);
  return block;
}

double child_pitch(const Draft& parent, Random* random) {
  return random->chance(0.6) ? parent.pitch : random_pitch(random);
}

/// How far a block whose ridge runs into a roof must reach under it until its ridge is covered.
double reach_under(const Draft& parent, double top) {
  const double half_span = 0.5 * parent.rectangle.size_y();
  const double slope = parent.roof[param::roof::kRise] / half_span;
  const double needed = slope > 0.0 ? (top - eaves_of(parent)) / slope : 0.0;
  return std::clamp(needed, 0.0, half_span);
}

/// A cross wing on one long side, its ridge at right angles to the parent's, stepping in from both
/// of the parent's ends (or out over them).
Draft attach_wing(const Draft& parent, int side, Random* random) {
  Draft block;
  const Rectangle& p = parent.rectangle;
  const double width = random->uniform(4.0, std::max(4.5, std::min(8.0, p.size_x() - 2.4)));
  const double reach = random->uniform(3.0, 7.0);
  const double slack = std::max(0.0, p.size_x() - width - 2.4);
  const double x0 = p.x0 + 1.2 + random->uniform(0.0, 1.0) * slack;
  block.pitch = child_pitch(parent, random);
  const double eaves = random->chance(0.6)
                           ? eaves_of(parent)
                           : std::max(2.4, eaves_of(parent) - random->uniform(0.3, 2.6));
  const double top = eaves + 0.5 * width * std::tan(block.pitch);
  const double under = reach_under(parent, top);
  const RoofEnd outer = random->chance(0.6) ? RoofEnd::kGable : RoofEnd::kHip;
  if (side > 0) {
    block.rectangle = {x0, x0 + width, p.y1 - under, p.y1 + reach};
    block.roof =
        make_roof(block.rectangle, Axis::kY, eaves, block.pitch, RoofEnd::kGable, outer, random);
  } else {
    block.rectangle = {x0, x0 + width, p.y0 - reach, p.y0 + under};
    block.roof =
        make_roof(block.rectangle, Axis::kY, eaves, block.pitch, outer, RoofEnd::kGable, random);
  }
  return block;
}

/// A neighbour at one end, ridges parallel: staggered to one side, or narrower (wider) at both.
Draft attach_neighbour(const Draft& parent, int side, Random* random) {
  Draft block;
  const Rectangle& p = parent.rectangle;
  const double length = random->uniform(5.0, 10.0);
  double width = p.size_y() * random->uniform(0.9, 1.1);
  double y0 = 0.0;
  if (random->chance(0.65)) {  // staggered
    const double step = random->uniform(1.3, 3.0) + 0.5 * std::abs(width - p.size_y());
    y0 = p.mid_y() - 0.5 * width + (random->chance(0.5) ? step : -step);
  } else {
    const double difference = random->uniform(2.4, 4.5);
    width = p.size_y() > 7.2 ? p.size_y() - difference : p.size_y() + difference;
    const double play = 0.5 * (difference - 2.4);
    y0 = p.mid_y() - 0.5 * width + random->uniform(-play, play);
  }
  const double x0 = side > 0 ? p.x1 : p.x0 - length;
  block.rectangle = {x0, x0 + length, y0, y0 + width};
  block.pitch = child_pitch(parent, random);
  const double eaves = random->chance(0.6)
                           ? eaves_of(parent)
                           : std::max(2.4, eaves_of(parent) - random->uniform(0.5, 2.6));
  const RoofEnd outer = random->chance(0.6) ? RoofEnd::kGable : RoofEnd::kHip;
  block.roof = side > 0 ? make_roof(block.rectangle, Axis::kX, eaves, block.pitch, RoofEnd::kGable,
                                    outer, random)
                        : make_roof(block.rectangle, Axis::kX, eaves, block.pitch, outer,
                                    RoofEnd::kGable, random);
  return block;
}

/// A lower extension at one end or on one long side, whose eaves and ridge both step down. It may
/// end flush with the parent. `at_end`: at a gable end, otherwise on a long side.
Draft attach_extension(const Draft& parent, bool at_end, int side, Random* random) {
  Draft block;
  const Rectangle& p = parent.rectangle;
  const double wall = at_end ? p.size_y() : p.size_x();
  const double along = random->chance(0.3) ? wall : random->uniform(0.5, 0.95) * wall;
  const double depth = random->uniform(3.0, 6.0);
  const double free = wall - along;
  const double place =
      random->chance(0.5) ? (random->chance(0.5) ? 0.0 : free) : random->uniform(0.0, free);
  if (at_end) {
    const double x0 = side > 0 ? p.x1 : p.x0 - depth;
    block.rectangle = {x0, x0 + depth, p.y0 + place, p.y0 + place + along};
  } else {
    const double y0 = side > 0 ? p.y1 : p.y0 - depth;
    block.rectangle = {p.x0 + place, p.x0 + place + along, y0, y0 + depth};
  }
  const double eaves = std::max(2.4, eaves_of(parent) - random->uniform(1.1, 3.0));
  block.pitch = child_pitch(parent, random);
  if (eaves >= kFlatBlockHeight && random->chance(0.3)) {
    block.roof = make_flat_roof(eaves);
    return block;
  }
  // The ridge runs along the longer side; where that is into the wall, the inner end is a gable.
  const bool along_x = block.rectangle.size_x() > block.rectangle.size_y();
  const bool into_wall = along_x == at_end;
  const auto end = [&](bool inner) {
    return into_wall && inner ? RoofEnd::kGable
                              : (random->chance(0.5) ? RoofEnd::kGable : RoofEnd::kHip);
  };
  const RoofEnd start_end = end(side > 0);
  const RoofEnd end_end = end(side < 0);
  block.roof = make_roof(block.rectangle, along_x ? Axis::kX : Axis::kY, eaves, block.pitch,
                         start_end, end_end, random);
  return block;
}

Draft attach_any(const Draft& parent, Random* random) {
  const int side = random->chance(0.5) ? 1 : -1;
  const double kind = random->uniform(0.0, 1.0);
  if (kind < 0.45) return attach_wing(parent, side, random);
  if (kind < 0.70) return attach_neighbour(parent, side, random);
  return attach_extension(parent, random->chance(0.5), side, random);
}

std::vector<Draft> random_drafts(int count, Random* random) {
  if (count == 1) return {random_single(random)};
  const bool terrace = count == 3 && random->chance(0.25);
  std::vector<Draft> blocks = {random_main(terrace, random)};
  if (terrace) {
    blocks.push_back(attach_neighbour(blocks[0], 1, random));
    blocks.push_back(attach_neighbour(blocks[1], 1, random));
    return blocks;
  }
  while (static_cast<int>(blocks.size()) < count) {
    const Draft child = attach_any(blocks[0], random);
    blocks.push_back(child);
  }
  return blocks;
}

/// Blocks attached to the same parent keep a metre apart, so that they stay blocks of their own.
bool siblings_keep_apart(const std::vector<Draft>& blocks) {
  if (blocks.size() < 3) return true;
  int close = 0;
  for (int i = 0; i < 3; ++i) {
    if (distance(blocks[i].rectangle, blocks[(i + 1) % 3].rectangle) < 1.0) ++close;
  }
  return close <= 2;
}

/// A wing that rises over the ridge of the block it dies into would show its cut end.
bool later_blocks_stay_below(const std::vector<Draft>& blocks) {
  for (size_t i = 1; i < blocks.size(); ++i) {
    if (shared_area(blocks[0].rectangle, blocks[i].rectangle) > 0.0 &&
        top_of(blocks[i]) > top_of(blocks[0]) + 1e-9) {
      return false;
    }
  }
  return true;
}

}  // namespace

House random_blocks(Foundation foundation, Random* random) {
  std::vector<Draft> blocks;
  do {
    blocks = random_drafts(num_components(foundation), random);
  } while (!siblings_keep_apart(blocks) || !later_blocks_stay_below(blocks));

  House house = make_house(foundation);
  for (size_t i = 0; i < blocks.size(); ++i) {
    using namespace param::rectangle;
    Rule& footprint = house.footprints[i];
    const Rectangle& r = blocks[i].rectangle;
    footprint[kCenterX] = r.mid_x();
    footprint[kCenterY] = r.mid_y();
    footprint[kLength] = r.size_x();
    footprint[kWidth] = r.size_y();
    house.roofs[i] = blocks[i].roof;
  }
  return house;
}

}  // namespace gable
