#include <gable/grammar/synthesis/houses/distinct.h>
#include <gable/grammar/synthesis/houses/prior.h>
#include <gable/grammar/synthesis/houses/random_blocks.h>
#include <gable/grammar/synthesis/houses/random_details.h>
#include <gable/grammar/synthesis/houses/random_garage.h>
#include <gable/grammar/synthesis/houses/random_wings.h>
#include <gable/grammar/synthesis/houses/rectangle.h>

#include <cassert>
#include <cmath>
#include <numeric>

namespace gable {
namespace {

constexpr Foundation kFoundations[5] = {Foundation::kI, Foundation::kII, Foundation::kIII,
                                        Foundation::kL, Foundation::kU};

House random_foundation(Foundation foundation, Random* random) {
  if (foundation == Foundation::kL) return random_l(random);
  if (foundation == Foundation::kU) return random_u(random);
  return random_blocks(foundation, random);
}

/// The box around the blocks; components only, or garages as well.
Rectangle plan_bounds(const House& house, bool garages) {
  const auto sources = block_sources(house);
  const auto blocks = expand_blocks(house);
  Rectangle box = rectangle_of(blocks[0]);
  for (size_t i = 1; i < blocks.size(); ++i) {
    const bool wanted = sources[i].role == BlockRole::kComponent ||
                        (garages && sources[i].role == BlockRole::kGarage);
    if (wanted) box = bounds(box, rectangle_of(blocks[i]));
  }
  return box;
}

double diagonal(const House& house, bool garages) {
  const Rectangle box = plan_bounds(house, garages);
  return std::hypot(box.size_x(), box.size_y());
}

void center(House* house) {
  const Rectangle box = plan_bounds(*house, false);
  // The first two parameters of every footprint rule are a point of the house frame.
  for (Rule& footprint : house->footprints) {
    footprint[0] -= box.mid_x();
    footprint[1] -= box.mid_y();
  }
}

}  // namespace

std::string PriorOptions::check() const {
  double sum = 0.0;
  for (double weight : foundation_weights) {
    if (!(weight >= 0.0)) return "foundation_weights must be >= 0";
    sum += weight;
  }
  if (!(sum > 0.0)) return "foundation_weights must not all be 0";
  const auto is_share = [](double share) { return share >= 0.0 && share <= 1.0; };
  if (!is_share(dormer_share)) return "dormer_share must be in [0, 1]";
  if (!is_share(chimney_share)) return "chimney_share must be in [0, 1]";
  if (!is_share(garage_share)) return "garage_share must be in [0, 1]";
  if (!(max_diagonal >= 26.0)) return "max_diagonal must be >= 26";
  return "";
}

House random_house(Foundation foundation, Random* random, const PriorOptions& options) {
  assert(foundation != Foundation::kC);
  assert(options.check().empty());
  Random draw = random->fork();
  House house;
  do {
    house = random_foundation(foundation, &draw);
  } while (!is_distinct(house) || diagonal(house, false) > options.max_diagonal);
  center(&house);
  house.azimuth[0] = draw.uniform(0.0, 2.0 * M_PI);
  // Each kind of detail has its own generator, so that one share changes nothing of the others.
  Random for_dormers = draw.fork();
  Random for_chimneys = draw.fork();
  Random for_garages = draw.fork();
  if (for_dormers.chance(options.dormer_share)) add_dormers(&for_dormers, &house);
  if (for_chimneys.chance(options.chimney_share)) add_chimneys(&for_chimneys, &house);
  if (for_garages.chance(options.garage_share)) add_garages(&for_garages, &house);
  while (diagonal(house, true) > options.max_diagonal) house.garages.pop_back();
  return house;
}

House random_house(Random* random, const PriorOptions& options) {
  const auto& weights = options.foundation_weights;
  double left = random->uniform(0.0, std::accumulate(weights.begin(), weights.end(), 0.0));
  size_t drawn = 0;
  for (size_t i = 0; i < weights.size() && left >= 0.0; ++i) {
    if (weights[i] > 0.0) drawn = i;
    left -= weights[i];
  }
  return random_house(kFoundations[drawn], random, options);
}

}  // namespace gable
