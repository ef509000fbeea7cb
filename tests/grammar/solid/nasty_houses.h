#pragma once

#include <gable/grammar/block.h>
#include <gable/grammar/house.h>
#include <gable/grammar/random.h>

#include <cmath>
#include <cstdint>
#include <utility>

namespace gable {

/// Random derivations that seek out what is hard to build: coinciding and nearly coinciding edges,
/// equal heights, nodes over ridges, eaves and walls, nodes hidden in one another.
class NastyHouses {
 public:
  explicit NastyHouses(uint64_t seed) : random_(seed) {}

  House next() { return filled(make_house(static_cast<Foundation>(random_.integer(0, 4)))); }

  // Of four to eight blocks.
  House next_of_many() {
    House house = make_house(Foundation::kMany);
    const size_t count = static_cast<size_t>(random_.integer(4, 8));
    house.footprints.resize(count, house.footprints[0]);
    house.roofs.resize(count, house.roofs[0]);
    return filled(std::move(house));
  }

 private:
  House filled(House house) {
    house.azimuth[0] = random_.chance(0.2) ? 0.0 : random_.uniform(-3.2, 3.2);
    for (Rule& rule : house.footprints) set_footprint(&rule);
    if (random_.chance(0.6)) attach_footprints(&house);
    const double eaves = random_.uniform(2.3, 8.0), rise = random_.uniform(0.5, 5.0);
    for (Rule& rule : house.roofs) {
      rule = roof(rule.ridge);
      rule.values[param::roof::kEaves] =
          random_.chance(0.7) ? nearly(eaves) : random_.uniform(2.3, 8.0);
      if (rule.kind != RuleKind::kRoofFlat) {
        rule.values[param::roof::kRise] =
            random_.chance(0.6) ? nearly(rise) : random_.uniform(0.0, 5.0);
      }
    }
    const int dormers = random_.integer(0, 3), chimneys = random_.integer(0, 3);
    const int garages = random_.integer(0, 2);
    for (int i = 0; i < dormers; ++i) add_dormer(&house);
    for (int i = 0; i < chimneys; ++i) add_chimney(&house);
    for (int i = 0; i < garages; ++i) add_garage(&house);
    return house;
  }

  // A value that equals `v`, or misses it by anything from a nanometre to a few centimetres.
  double nearly(double v) {
    if (random_.chance(0.5)) return v;
    const double miss = std::pow(10.0, random_.uniform(-9.0, -1.3));
    return random_.chance(0.5) ? v + miss : v - miss;
  }

  // Sizes of the same few values coincide often.
  double size(double low, double high) {
    if (random_.chance(0.5)) return nearly(std::round(random_.uniform(low, high)));
    return random_.uniform(low, high);
  }

  void set_footprint(Rule* rule) {
    if (rule->kind == RuleKind::kFootprintI) {
      rule->values = {size(-6, 6), size(-6, 6), size(3, 16), size(3, 12)};
    } else if (rule->kind == RuleKind::kFootprintL) {
      const double width = size(3, 8);
      rule->values = {size(-6, 6), size(-6, 6), size(4, 16),
                      width,       size(4, 16), random_.chance(0.5) ? nearly(width) : size(3, 8)};
    } else {
      const double length = size(4, 16), width = size(3, 7);
      rule->values = {size(-6, 6),
                      size(-6, 6),
                      size(8, 24),
                      size(3, 8),
                      length,
                      nearly(width),
                      random_.chance(0.5) ? nearly(length) : size(4, 16),
                      nearly(width)};
    }
  }

  // Puts later rectangles against, across, inside or at a corner of the first.
  void attach_footprints(House* house) {
    using namespace param::rectangle;
    const Rule& first = house->footprints[0];
    for (size_t i = 1; i < house->footprints.size(); ++i) {
      Rule& rule = house->footprints[i];
      const double beside = 0.5 * (first[kLength] + rule[kLength]);
      const double behind = 0.5 * (first[kWidth] + rule[kWidth]);
      switch (random_.integer(0, 4)) {
        case 0:  // against its end, perhaps equally wide
          if (random_.chance(0.5)) rule[kWidth] = nearly(first[kWidth]);
          rule[kCenterX] = nearly(first[kCenterX] + beside);
          rule[kCenterY] = nearly(first[kCenterY]);
          break;
        case 1:  // against its side
          rule[kCenterX] = first[kCenterX] + size(-3, 3);
          rule[kCenterY] = nearly(first[kCenterY] + behind);
          break;
        case 2:  // corner to corner
          rule[kCenterX] = nearly(first[kCenterX] + beside);
          rule[kCenterY] = nearly(first[kCenterY] - behind);
          break;
        case 3:  // one edge in common
          rule[kCenterX] = nearly(first[kCenterX] + 0.5 * (first[kLength] - rule[kLength]));
          rule[kCenterY] = first[kCenterY] + size(-4, 4);
          break;
        default:  // across the middle
          rule[kCenterX] = nearly(first[kCenterX]);
          rule[kCenterY] = nearly(first[kCenterY]);
          break;
      }
    }
  }

  Rule roof(Axis ridge) {
    const int kind = random_.integer(0, 9);
    Rule rule = make_rule(kind < 2   ? RuleKind::kRoofFlat
                          : kind < 6 ? RuleKind::kRoofGable
                          : kind < 8 ? RuleKind::kRoofMansard
                                     : RuleKind::kRoofHip);
    rule.ridge = random_.chance(0.2) ? (ridge == Axis::kX ? Axis::kY : Axis::kX) : ridge;
    if (rule.kind == RuleKind::kRoofMansard) {
      namespace m = param::mansard;
      const int pick = random_.integer(0, 3);
      // Both shares one half: no break at all.
      rule[m::kBreakHeight] = pick == 0   ? 0.5
                              : pick == 1 ? 0.5 + std::pow(10.0, random_.uniform(-9, -1))
                              : pick == 2 ? 0.95
                                          : random_.uniform(0.5, 0.95);
      rule[m::kBreakRun] = pick < 2 ? 0.5 : random_.uniform(0.05, 0.5);
    }
    if (rule.kind == RuleKind::kRoofHip) {
      for (const int hip : {param::roof::kHipStart, param::roof::kHipEnd}) {
        const int pick = random_.integer(0, 3);
        rule.values[hip] = pick == 0   ? 0.0
                           : pick == 1 ? 0.5 - std::pow(10.0, random_.uniform(-9, -1))
                           : pick == 2 ? 0.5
                                       : random_.uniform(0.0, 0.5);
      }
    }
    return rule;
  }

  // A place on a component where something interesting passes: ridge, eaves, gable or anywhere.
  Eigen::Vector2d place(const Block<double>& block) {
    using namespace block_value;
    const auto pick = [this](double low, double high) {
      switch (random_.integer(0, 4)) {
        case 0:
          return nearly(low);
        case 1:
          return nearly(0.5 * (low + high));
        case 2:
          return nearly(high);
        default:
          return random_.uniform(low - 0.5, high + 0.5);
      }
    };
    return {pick(block[kX0], block[kX1]), pick(block[kY0], block[kY1])};
  }

  double roof_top(const Block<double>& block) {
    return block[block_value::kEaves] + block[block_value::kRise];
  }

  void add_dormer(House* house) {
    const int component = random_.integer(0, house->num_components() - 1);
    const Block<double> parent = expand_blocks(*house)[component];
    Rule rule = make_rule(RuleKind::kDormer);
    rule.component = component;
    const Eigen::Vector2d center = place(parent);
    const double eaves = parent[block_value::kEaves], top = roof_top(parent);
    rule.values = {center.x(),
                   center.y(),
                   size(0.7, 4),
                   size(0.7, 5),
                   random_.chance(0.2) ? nearly(eaves) : random_.uniform(eaves - 0.5, top + 0.5),
                   random_.chance(0.2) ? 0.0 : random_.uniform(0.0, 2.0)};
    if (random_.chance(0.2)) rule.values[5] = std::fmax(0.0, nearly(top - rule.values[4]));
    if (!house->dormers.empty() && random_.chance(0.4)) {  // touching the last one
      const Rule& last = house->dormers.back();
      rule.component = last.component;
      rule.values = last.values;
      const bool along_x = house->roofs[last.component].ridge == Axis::kX;
      rule.values[along_x ? 0 : 1] = nearly(rule.values[along_x ? 0 : 1] + last.values[2]);
    }
    house->dormers.push_back(rule);
  }

  void add_chimney(House* house) {
    const std::vector<Block<double>> blocks = expand_blocks(*house);
    const Block<double>& parent = blocks[random_.integer(0, static_cast<int>(blocks.size()) - 1)];
    Rule rule = make_rule(RuleKind::kChimney);
    const Eigen::Vector2d center = place(parent);
    rule.values = {center.x(), center.y(), size(0.4, 2.0),
                   random_.chance(0.2) ? nearly(roof_top(parent))
                                       : random_.uniform(2.0, roof_top(parent) + 2.0)};
    if (random_.chance(0.3)) {  // flush with the wall
      rule.values[0] = nearly(parent[block_value::kX0] + 0.5 * rule.values[2]);
    }
    house->chimneys.push_back(rule);
  }

  void add_garage(House* house) {
    using namespace block_value;
    const std::vector<Block<double>> blocks = expand_blocks(*house);
    const Block<double>& parent = blocks[0];
    const bool l_shaped = random_.chance(0.3);
    Rule rule = make_rule(l_shaped ? RuleKind::kGarageL : RuleKind::kGarageI);
    const double height = random_.chance(0.2) ? nearly(parent[kEaves]) : random_.uniform(2.0, 3.5);
    const double length = size(3, 7), width = size(2, 5);
    if (l_shaped) {
      const Eigen::Vector2d corner = place(parent);
      rule.values = {corner.x(), corner.y(),          length, nearly(0.5 * width),
                     length,     nearly(0.5 * width), height};
    } else {
      const double beside = nearly(parent[kX1] + 0.5 * length);
      const Eigen::Vector2d inside = place(parent);
      switch (random_.integer(0, 3)) {
        case 0:  // against the wall, flush with the front
          rule.values = {beside, nearly(parent[kY0] + 0.5 * width), length, width, height};
          break;
        case 1:  // corner to corner
          rule.values = {beside, nearly(parent[kY1] + 0.5 * width), length, width, height};
          break;
        case 2:  // across a wall or ridge
          rule.values = {inside.x(), inside.y(), length, width, height};
          break;
        default:  // apart
          rule.values = {beside + 1.0, inside.y(), length, width, height};
          break;
      }
    }
    house->garages.push_back(rule);
  }

  Random random_;
};

}  // namespace gable
