#include <gable/grammar/plan_outline.h>
#include <gable/grammar/synthesis/gardens.h>
#include <gable/grammar/synthesis/ground/terrain.h>
#include <gable/grammar/synthesis/streets.h>
#include <gable/grammar/synthesis/village.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>

namespace gable {
namespace {

constexpr Foundation kFoundations[5] = {Foundation::kI, Foundation::kII, Foundation::kIII,
                                        Foundation::kL, Foundation::kU};

/// `count` types with the shares of `weights`, in random order.
std::vector<Foundation> shared_out(int count, const std::array<double, 5>& weights,
                                   Random* random) {
  const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
  std::vector<Foundation> types;
  for (int i = 0; i < count; ++i) {
    double left = (i + 0.5) / count * total;
    size_t type = 0;
    while (type + 1 < weights.size() && left >= weights[type]) left -= weights[type++];
    types.push_back(kFoundations[type]);
  }
  for (int i = count - 1; i > 0; --i) std::swap(types[i], types[random->integer(0, i)]);
  return types;
}

/// The grid around all houses; moves the houses and the streets so that it starts at
/// options.north_west.
Grid grid_around(const VillageOptions& options, std::vector<House>* houses,
                 Eigen::Vector2d* shift) {
  double west = std::numeric_limits<double>::infinity(), east = -west, south = west, north = -west;
  for (const House& house : *houses) {
    for (const PlanPolygon& polygon : plan_outline(house)) {
      for (const Eigen::Vector2d& p : polygon.outer) {
        const Eigen::Vector2d world = house.origin.head<2>() + p;
        west = std::min(west, world.x());
        east = std::max(east, world.x());
        south = std::min(south, world.y());
        north = std::max(north, world.y());
      }
    }
  }
  Grid grid;
  grid.gsd = options.gsd;
  grid.north_west = options.north_west;
  grid.cols = static_cast<int>(std::ceil((east - west + 2.0 * options.margin) / options.gsd));
  grid.rows = static_cast<int>(std::ceil((north - south + 2.0 * options.margin) / options.gsd));
  *shift = options.north_west + Eigen::Vector2d(options.margin - west, -options.margin - north);
  for (House& house : *houses) house.origin.head<2>() += *shift;
  return grid;
}

/// Lowest terrain along the outline, every metre.
double lowest_ground(const PlanPolygon& world_outline, const Terrain& terrain) {
  double lowest = std::numeric_limits<double>::infinity();
  const auto& ring = world_outline.outer;
  for (size_t k = 0; k < ring.size(); ++k) {
    const Eigen::Vector2d along = ring[(k + 1) % ring.size()] - ring[k];
    const int steps = std::max(1, static_cast<int>(std::ceil(along.norm())));
    for (int i = 0; i < steps; ++i) {
      lowest = std::min(lowest, terrain.at(ring[k] + along * (static_cast<double>(i) / steps)));
    }
  }
  return lowest;
}

PlanPolygon to_world(PlanPolygon polygon, const House& house) {
  for (auto& p : polygon.outer) p += house.origin.head<2>();
  for (auto& hole : polygon.holes) {
    for (auto& p : hole) p += house.origin.head<2>();
  }
  return polygon;
}

}  // namespace

std::string VillageOptions::check() const {
  if (!(count >= 1)) return "count must be >= 1";
  if (!(gsd >= 0.1 && gsd <= 2.0)) return "gsd must be in [0.1, 2]";
  if (!(gap >= 0.0)) return "gap must be >= 0";
  if (!(steepness >= 0.0 && steepness <= 0.3)) return "steepness must be in [0, 0.3]";
  if (!(dtm_noise >= 0.0)) return "dtm_noise must be >= 0";
  if (!(trees_per_house >= 0.0)) return "trees_per_house must be >= 0";
  if (!(touching_trees >= 0.0 && touching_trees <= 1.0)) return "touching_trees must be in [0, 1]";
  if (!(hedge_share >= 0.0 && hedge_share <= 1.0)) return "hedge_share must be in [0, 1]";
  if (!(margin >= 0.0)) return "margin must be >= 0";
  const std::string in_lidar = lidar.check();
  return in_lidar.empty() ? prior.check() : in_lidar;
}

Village synthesize_village(const VillageOptions& options) {
  assert(options.check().empty());
  Random random(options.seed);
  Random for_types = random.fork(), for_houses = random.fork(), for_streets = random.fork();
  Random for_terrain = random.fork(), for_gardens = random.fork(), for_leaves = random.fork();
  Random for_survey = random.fork(), for_dtm = random.fork();

  Village village;
  std::vector<House> houses;
  for (Foundation type : shared_out(options.count, options.prior.foundation_weights, &for_types)) {
    houses.push_back(random_house(type, &for_houses, options.prior));
  }
  StreetPlan plan = lay_out_streets(houses, options.gap, Eigen::Vector2d::Zero(), &for_streets);
  for (const StreetPlot& plot : plan.plots) village.houses.push_back(plot.plot.house());
  Eigen::Vector2d shift;
  const Grid grid = grid_around(options, &village.houses, &shift);
  for (Street& street : plan.streets) street.origin += shift;
  for (size_t i = 0; i < plan.plots.size(); ++i) plan.plots[i].plot = Plot(village.houses[i]);

  const Terrain terrain(options.north_west, 80.0, options.steepness, &for_terrain);
  HeightRaster ground(grid, 0.0f);
  for (int row = 0; row < grid.rows; ++row) {
    for (int col = 0; col < grid.cols; ++col) {
      ground.at(row, col) = static_cast<float>(terrain.at(grid.center_of(row, col)));
    }
  }

  village.dsm = ground;
  village.truth = HeightRaster(grid, std::numeric_limits<float>::quiet_NaN());
  for (House& house : village.houses) {
    house.origin.z() = terrain.at(house.origin.head<2>());
    rasterise_house(house, &village.dsm, &village.truth);
    village.footprints.push_back(to_world(plan_outline(house)[0], house));
    const double lowest = lowest_ground(village.footprints.back(), terrain);
    village.base.push_back(std::min(0.0, lowest - house.origin.z()));
  }

  const Gardens gardens = plant_gardens(plan, options, &for_gardens);
  village.trees = gardens.trees;
  village.hedges = gardens.hedges;
  for (const Tree& tree : village.trees) add_tree(tree, ground, &for_leaves, &village.dsm);
  for (const Hedge& hedge : village.hedges) add_hedge(hedge, ground, &for_leaves, &village.dsm);
  add_survey_noise(options.lidar, ground, &for_survey, &village.dsm);

  village.dtm = ground;
  for (float& height : village.dtm.values) {
    height += static_cast<float>(for_dtm.normal(options.dtm_noise));
  }
  return village;
}

}  // namespace gable
