#include <gable/grammar/block.h>
#include <gable/grammar/synthesis/houses/box_dormers.h>
#include <gable/grammar/synthesis/houses/distinct.h>
#include <gable/grammar/synthesis/houses/random_details.h>
#include <gable/grammar/synthesis/houses/random_garage.h>
#include <gable/grammar/synthesis/houses/random_roof.h>
#include <gable/grammar/synthesis/houses/rectangle.h>
#include <gable/grammar/synthesis/houses/training_house.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

namespace gable {
namespace {

namespace r = param::roof;

constexpr double kDegree = M_PI / 180.0;
constexpr double kAsPriorShare = 0.25;
constexpr double kFlatShare = 0.06;  // of I, beside those of the prior
constexpr double kLowestEaves = 2.2;

bool is_flat(const Rule& roof) { return roof.kind == RuleKind::kRoofFlat; }

/// Steepest slope of the sides of any roof, a tangent; 0 where all are flat.
double steepest(const House& house) {
  double steepest = 0.0;
  const auto blocks = expand_blocks(house);
  for (int i = 0; i < house.num_components(); ++i) {
    if (blocks[i].flat) continue;
    const Rectangle at = rectangle_of(blocks[i]);
    const double span = blocks[i].ridge == Axis::kX ? at.size_y() : at.size_x();
    steepest = std::max(steepest, blocks[i][block_value::kRise] / (0.5 * span));
  }
  return steepest;
}

double lowest_eaves(const House& house) {
  double lowest = house.roofs[0][r::kEaves];
  for (const Rule& roof : house.roofs) lowest = std::min(lowest, roof[r::kEaves]);
  return lowest;
}

double diagonal(const House& house) {
  const auto blocks = expand_blocks(house);
  Rectangle box = rectangle_of(blocks[0]);
  for (int i = 1; i < house.num_components(); ++i) box = bounds(box, rectangle_of(blocks[i]));
  return std::hypot(box.size_x(), box.size_y());
}

/// Makes the plan larger by a factor, the heights of what is on it kept.
void scale_plan(double factor, House* house) {
  for (Rule& footprint : house->footprints) {
    for (double& value : footprint.parameters()) value *= factor;
  }
}

/// Makes all heights larger by a factor and lifts the eaves. Roofs that die into others still do:
/// where they meet depends on ratios of height differences alone.
void change_heights(double factor, double lift, House* house) {
  for (Rule& roof : house->roofs) {
    roof[r::kEaves] = factor * roof[r::kEaves] + lift;
    if (!is_flat(roof)) roof[r::kRise] *= factor;
  }
}

double wide_pitch(Random* random) {
  const double kind = random->uniform(0.0, 1.0);
  if (kind < 0.25) return random->uniform(15.0, 30.0) * kDegree;
  if (kind < 0.80) return random->uniform(28.0, 48.0) * kDegree;
  return random->uniform(45.0, 60.0) * kDegree;
}

double wide_eaves(Random* random) {
  const double kind = random->uniform(0.0, 1.0);
  if (kind < 0.25) return random->uniform(kLowestEaves, 3.0);
  if (kind < 0.85) return random->uniform(3.0, 6.5);
  return random->uniform(6.0, 9.0);
}

void widen(Random* random, House* house) {
  scale_plan(random->chance(0.3) ? random->uniform(1.2, 1.7) : random->uniform(0.85, 1.25), house);
  if (house->foundation == Foundation::kI && random->chance(0.3)) {
    house->footprints[0][param::rectangle::kLength] *= random->uniform(1.1, 1.7);
  }
  const double slope = steepest(*house);
  const double factor =
      slope > 0.0 ? std::clamp(std::tan(wide_pitch(random)) / slope, 0.3, 2.5) : 1.0;
  const double eaves = wide_eaves(random);
  change_heights(factor, eaves - factor * lowest_eaves(*house), house);
  if (house->foundation == Foundation::kI && random->chance(kFlatShare)) {
    house->roofs[0] = make_flat_roof(std::max(eaves, 2.6));
  }
}

/// Low and narrow, with one side at a wall: a porch, or a lean-to along most of it.
void add_low_extension(Random* random, House* house) {
  std::vector<Rectangle> others;
  const auto blocks = expand_blocks(*house);
  const auto sources = block_sources(*house);
  for (size_t i = 0; i < blocks.size(); ++i) {
    if (!stands_on_roof(sources[i].role)) others.push_back(rectangle_of(blocks[i]));
  }
  const double height = std::min(random->uniform(2.1, 2.7), lowest_eaves(*house) - 0.4);
  if (height < 2.05) return;
  for (int attempt = 0; attempt < 8; ++attempt) {
    const Rectangle& wall =
        others[static_cast<size_t>(random->integer(0, house->num_components() - 1))];
    const int side = random->integer(0, 3);
    const double w0 = side < 2 ? wall.y0 : wall.x0, w1 = side < 2 ? wall.y1 : wall.x1;
    const bool porch = random->chance(0.4);
    const double depth = porch ? random->uniform(1.2, 2.2) : random->uniform(1.8, 3.8);
    const double along = porch ? random->uniform(1.6, 3.0) : random->uniform(0.4, 1.0) * (w1 - w0);
    if (along > w1 - w0 || along < 1.2) continue;
    const double start = random->chance(0.3) ? w0 : random->uniform(w0, w1 - along);
    Rectangle place;
    if (side == 0) place = {wall.x1, wall.x1 + depth, start, start + along};
    if (side == 1) place = {wall.x0 - depth, wall.x0, start, start + along};
    if (side == 2) place = {start, start + along, wall.y1, wall.y1 + depth};
    if (side == 3) place = {start, start + along, wall.y0 - depth, wall.y0};
    if (std::any_of(others.begin(), others.end(),
                    [&](const Rectangle& o) { return shared_area(place, o) > 1e-9; })) {
      continue;
    }
    using namespace param::rectangle;
    Rule garage = make_rule(RuleKind::kGarageI);
    garage[kCenterX] = place.mid_x();
    garage[kCenterY] = place.mid_y();
    garage[kLength] = place.size_x();
    garage[kWidth] = place.size_y();
    garage[param::garage::kHeightI] = height;
    house->garages.push_back(garage);
    return;
  }
}

/// Boxes instead of gables, as high as the gables' ridges, so that they end where those did.
void flatten_dormers(House* house) {
  namespace d = param::dormer;
  for (Rule& dormer : house->dormers) {
    dormer[d::kEaves] += dormer[d::kRise];
    dormer[d::kRise] = 0.0;
  }
}

}  // namespace

House random_training_house(Foundation foundation, Random* random, const PriorOptions& options) {
  assert(foundation != Foundation::kC);
  assert(options.check().empty());
  if (random->chance(kAsPriorShare)) return random_house(foundation, random, options);
  PriorOptions bare = options;
  bare.dormer_share = bare.chimney_share = bare.garage_share = 0.0;
  House house;
  do {
    house = random_house(foundation, random, bare);
    widen(random, &house);
  } while (!is_distinct(house) || diagonal(house) > options.max_diagonal);
  Random for_dormers = random->fork(), for_chimneys = random->fork(), for_garages = random->fork();
  if (for_dormers.chance(options.dormer_share)) {
    if (for_dormers.chance(0.4)) {
      add_box_dormers(&for_dormers, &house);
    } else {
      add_dormers(&for_dormers, &house);
      if (for_dormers.chance(0.4)) flatten_dormers(&house);
    }
  }
  if (for_chimneys.chance(options.chimney_share)) add_chimneys(&for_chimneys, &house);
  if (for_garages.chance(options.garage_share)) {
    if (for_garages.chance(0.65)) add_garages(&for_garages, &house);
    if (for_garages.chance(0.45)) add_low_extension(&for_garages, &house);
  }
  return house;
}

}  // namespace gable
